// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bubbles of a foam, measured one by one on any executor (parallel/host.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/foam_view.h"
#include "parallel/host.h"
#include "parallel/kernels.h"
#include "parallel/numbering.h"
#include "statistics/statistics.h"

namespace foam {

/// The order of a foam's bubbles by their names, which they keep: what has to be sent to an
/// executor once.
template <class Executor> struct BubbleNames {
  BubbleNames() = default;
  explicit BubbleNames(const Field<Bubble, std::int64_t>& bubble_id)
      : ascending(in_ascending_order(bubble_id)) {}

  typename Executor::template Array<Bubble> ascending;

private:
  static std::vector<Bubble> in_ascending_order(const Field<Bubble, std::int64_t>& bubble_id) {
    std::vector<Bubble> order;
    order.reserve(bubble_id.size());
    for (const Bubble b : Slots<Bubble>(static_cast<Index>(bubble_id.size()))) {
      order.push_back(b);
    }
    if (!std::ranges::is_sorted(bubble_id)) {
      std::ranges::sort(order, {}, [&](Bubble b) { return bubble_id[b]; });
    }
    return order;
  }
};

namespace detail {

/// The bubbles that are there, in the order of their ids.
struct PresentBubble {
  ConstFoamView mesh;
  const Bubble* ascending = nullptr;

  FOAM_HOST_DEVICE Bubble operator()(Index i) const {
    return mesh.has_bubble(ascending[i]) ? ascending[i] : Bubble(kNone);
  }
};

/// What takes long to compute of an arc, and is asked for by both of its sides.
struct ArcMeasures {
  double length = 0;    ///< cm
  double segment = 0;   ///< area between arc and chord as seen from the film's half(), cm²
  SymmetricTensor pull; ///< T·∫t⊗t ds, N; 0 of a wall
};

struct MeasureArc {
  static constexpr std::size_t kLeastPerThread = 2048;

  ConstFoamView mesh;
  FieldView<Film, ArcMeasures> arcs;

  FOAM_HOST_DEVICE void operator()(Film film) const {
    if (mesh.has_film(film)) {
      if (mesh.wall(film.half())) {
        arcs[film] = {mesh.length(film.half()), mesh.segment(film), {}};
        return;
      }
      const Vec2 chord = mesh.chord(film.half());
      const double alpha = mesh.half_angle(film.half());
      arcs[film] = {arc_length(norm(chord), alpha), segment_area(norm(chord), alpha),
                    mesh.tension(film) * arc_tangents(chord, alpha)};
    }
  }
};

/// tense_length() of films whose arcs have been measured.
struct TenseLength {
  ConstFoamView mesh;
  ConstFieldView<Film, ArcMeasures> arcs;

  FOAM_HOST_DEVICE double operator()(Film film) const {
    return mesh.bends(film) ? mesh.relative_tension(film) * arcs[film].length : 0;
  }
};

struct RecordBubble {
  static constexpr std::size_t kLeastPerThread = 2048;

  ConstFoamView mesh;
  ConstFieldView<Film, ArcMeasures> arcs;
  const Bubble* bubbles = nullptr;
  BubbleStatistics* records = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Bubble bubble = bubbles[i];
    BubbleStatistics record;
    record.id = mesh.bubble_id[bubble];
    record.area = mesh.area(bubble, [this](Film film) { return arcs[film].segment; });
    record.target_area = mesh.target_area[bubble];
    record.pressure = mesh.pressure[bubble];
    record.sides = mesh.sides[bubble];
    for_each_half(mesh, bubble, [&](Half h) {
      const ArcMeasures& arc = arcs[h.film()];
      record.perimeter += arc.length;
      record.stress += (mesh.right(h).is_outside() ? 1.0 : 0.5) * arc.pull;
    });
    record.stress = (1 / record.area) * record.stress - isotropic(record.pressure);
    record.on_boundary = mesh.bubble_on_outside(bubble);
    records[i] = record;
  }
};

} // namespace detail

/// A record of every bubble, in ascending order of id.
template <class Executor> class BubbleRecords {
public:
  explicit BubbleRecords(Executor& executor) : executor_(executor), bubbles_(executor) {}

  void measure(const ConstFoamView& mesh, const BubbleNames<Executor>& names) {
    bubbles_.find(mesh.bubbles, detail::PresentBubble{mesh, names.ascending.data()});
    records_.resize(place_of(bubbles_.count()));
    arcs_.resize(place_of(mesh.films));
    executor_.for_each(
        mesh.film_slots(),
        detail::MeasureArc{mesh, FieldView<Film, detail::ArcMeasures>(arcs_.data())});
    executor_.for_each(bubbles_.count(),
                       detail::RecordBubble{mesh, arcs(), bubbles_.list(), records_.data()});
  }

  /// Energy Σ T·l of the mesh that has been measured, N (Foam::energy).
  double energy(const ConstFoamView& mesh) {
    return mesh.reference_tension() * executor_.reduce(mesh.film_slots(), 0.0,
                                                       detail::TenseLength{mesh, arcs()},
                                                       parallel::Add{});
  }

  Index count() const { return bubbles_.count(); }
  const Bubble* bubbles() const { return bubbles_.list(); }
  const BubbleStatistics* records() const { return records_.data(); }
  ConstFieldView<Film, detail::ArcMeasures> arcs() const {
    return ConstFieldView<Film, detail::ArcMeasures>(arcs_.data());
  }

  /// The records, for this machine; only measure() may follow.
  std::vector<BubbleStatistics> fetch_records() { return fetch(std::move(records_)); }

private:
  Executor& executor_;
  parallel::Numbering<Executor, Bubble> bubbles_;
  typename Executor::template Array<BubbleStatistics> records_;
  typename Executor::template Array<detail::ArcMeasures> arcs_;
};

} // namespace foam
