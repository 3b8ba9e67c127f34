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
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      return bubble_id[static_cast<std::size_t>(a)] < bubble_id[static_cast<std::size_t>(b)];
    });
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

struct RecordBubble {
  static constexpr std::size_t kLeastPerThread = 1024;

  FoamView mesh;
  const std::int64_t* id = nullptr;
  const Index* bubbles = nullptr;
  BubbleStatistics* records = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index bubble = bubbles[i];
    BubbleStatistics record;
    record.id = id[bubble];
    record.area = mesh.area(bubble);
    record.target_area = mesh.target_area[bubble];
    record.pressure = mesh.pressure[bubble];
    record.sides = mesh.sides[bubble];
    for_each_half(mesh, bubble, [&](Index h) { record.perimeter += mesh.length(h); });
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
    machine_.for_each(bubbles_.count(), detail::RecordBubble{mesh, names.id.data(), bubbles_.list(),
                                                             records_.data()});
  }

  Index count() const { return bubbles_.count(); }
  /// The bubbles' places in the mesh.
  const Index* bubbles() const { return bubbles_.list(); }
  const BubbleStatistics* records() const { return records_.data(); }

  /// The records, for this machine; only measure() may follow.
  std::vector<BubbleStatistics> fetch_records() { return fetch(std::move(records_)); }

private:
  Machine& machine_;
  parallel::Numbering<Machine> bubbles_;
  typename Machine::template Array<BubbleStatistics> records_;
};

} // namespace foam
