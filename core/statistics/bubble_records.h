// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bubbles of a foam, measured one by one on any machine (parallel/host.h).
#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/foam_view.h"
#include "parallel/host.h"
#include "parallel/kernels.h"
#include "parallel/numbering.h"
#include "statistics/statistics.h"

namespace foam {

/// The names of a foam's bubbles, which they keep: what has to be sent to a machine once.
template <class Machine> struct BubbleNames {
  BubbleNames() = default;
  explicit BubbleNames(const std::vector<std::int64_t>& bubble_id)
      : id(bubble_id), ascending(in_ascending_order(bubble_id)) {}

  typename Machine::template Array<std::int64_t> id;
  typename Machine::template Array<Index> ascending; ///< the bubbles in the order of their ids

private:
  static std::vector<Index> in_ascending_order(const std::vector<std::int64_t>& bubble_id) {
    std::vector<Index> order(bubble_id.size());
    std::iota(order.begin(), order.end(), Index{0});
    if (!std::is_sorted(bubble_id.begin(), bubble_id.end())) {
      std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return bubble_id[static_cast<std::size_t>(a)] < bubble_id[static_cast<std::size_t>(b)];
      });
    }
    return order;
  }
};

namespace detail {

/// The bubbles that are there, in the order of their ids.
struct PresentBubble {
  FoamView mesh;
  const Index* ascending = nullptr;

  FOAM_HOST_DEVICE Index operator()(Index i) const {
    return mesh.has_bubble(ascending[i]) ? ascending[i] : kNone;
  }
};

/// What takes long to compute of an arc, and is asked for by both of its sides.
struct ArcMeasures {
  double length = 0;  ///< cm
  double segment = 0; ///< area between arc and chord as seen from half-film 2f, cm²
};

struct MeasureArc {
  static constexpr std::size_t kLeastPerThread = 2048;

  FoamView mesh;
  ArcMeasures* arcs = nullptr;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    if (mesh.has_film(film)) {
      const double chord = norm(mesh.chord(2 * film));
      const double alpha = mesh.half_angle(2 * film);
      arcs[film] = {arc_length(chord, alpha), segment_area(chord, alpha)};
    }
  }
};

/// tense_length() of films whose arcs have been measured.
struct TenseLength {
  FoamView mesh;
  const ArcMeasures* arcs = nullptr;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    return mesh.has_film(film) && !mesh.wall(2 * film) ? arcs[film].length : 0;
  }
};

struct RecordBubble {
  static constexpr std::size_t kLeastPerThread = 2048;

  FoamView mesh;
  const ArcMeasures* arcs = nullptr;
  const std::int64_t* id = nullptr;
  const Index* bubbles = nullptr;
  BubbleStatistics* records = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index bubble = bubbles[i];
    BubbleStatistics record;
    record.id = id[bubble];
    record.area = mesh.area(bubble, [this](Index film) { return arcs[film].segment; });
    record.target_area = mesh.target_area[bubble];
    record.pressure = mesh.pressure[bubble];
    record.sides = mesh.sides[bubble];
    for_each_half(mesh, bubble,
                  [&](Index h) { record.perimeter += arcs[FoamView::film_of(h)].length; });
    record.on_boundary = mesh.bubble_on_world(bubble);
    records[i] = record;
  }
};

} // namespace detail

/// A record of every bubble, in ascending order of id.
template <class Machine> class BubbleRecords {
public:
  explicit BubbleRecords(Machine& machine) : machine_(machine), bubbles_(machine) {}

  void measure(const FoamView& mesh, const BubbleNames<Machine>& names) {
    bubbles_.find(mesh.bubbles, detail::PresentBubble{mesh, names.ascending.data()});
    records_.resize(FoamView::size(bubbles_.count()));
    arcs_.resize(FoamView::size(mesh.films));
    machine_.for_each(mesh.films, detail::MeasureArc{mesh, arcs_.data()});
    machine_.for_each(bubbles_.count(), detail::RecordBubble{mesh, arcs_.data(), names.id.data(),
                                                             bubbles_.list(), records_.data()});
  }

  /// Film energy 2γ·Σl of the mesh that has been measured, N (Foam::energy).
  double energy(const FoamView& mesh) {
    return 2 * mesh.surface_tension *
           machine_.reduce(mesh.films, 0.0, detail::TenseLength{mesh, arcs_.data()},
                           parallel::Add{});
  }

  Index count() const { return bubbles_.count(); }
  /// The bubbles' places in the mesh.
  const Index* bubbles() const { return bubbles_.list(); }
  const BubbleStatistics* records() const { return records_.data(); }
  /// By film of the mesh.
  const detail::ArcMeasures* arcs() const { return arcs_.data(); }

  /// The records, for this machine; only measure() may follow.
  std::vector<BubbleStatistics> fetch_records() { return fetch(std::move(records_)); }

private:
  Machine& machine_;
  parallel::Numbering<Machine> bubbles_;
  typename Machine::template Array<BubbleStatistics> records_;
  typename Machine::template Array<detail::ArcMeasures> arcs_;
};

} // namespace foam
