// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/reservations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "../two_sided_bubbles.h"
#include "foams.h"
#include "hand_made.h"
#include "parallel/host.h"
#include "thesis/rules.h"
#include "topology/collapse_operations.h"
#include "topology/operations.h"

namespace foam {
namespace {

using Operations = CollapseOperations<ThesisRules>;

/// An executor that calls its kernels one by one in an order of its own.
class Shuffled {
public:
  template <class T> using Array = std::vector<T>;

  explicit Shuffled(unsigned seed) : generator_(seed) {}

  template <class Kernel> void for_each(Index size, const Kernel& kernel) {
    std::vector<Index> order(place_of(size));
    std::iota(order.begin(), order.end(), Index{0});
    std::shuffle(order.begin(), order.end(), generator_);
    std::for_each(order.begin(), order.end(), kernel);
  }
  template <class T, class Map, class Combine>
  T reduce(Index size, T zero, const Map& map, const Combine& combine) const {
    return Host(1).reduce(size, zero, map, combine);
  }
  template <class T> T exclusive_scan(T* counts, Index size) const {
    return Host(1).exclusive_scan(counts, size);
  }

private:
  std::mt19937 generator_;
};

/// Thresholds at which very many films and bubbles of a foam give way.
ThesisRules coarse_rules() {
  return {.limit = {.t1_length = 0.5, .t2_area = 0.7},
          .two_sided_bubbles = TwoSidedBubbles::Remove};
}

/// A flag for each element of a kind, all of them set.
template <class Element> class AllSet {
public:
  explicit AllSet(Slots<Element> slots) : flags_(place_of(slots.size()), 1) {}
  operator FieldView<Element, std::uint8_t>() {
    return FieldView<Element, std::uint8_t>(flags_.data());
  }

private:
  std::vector<std::uint8_t> flags_;
};

template <class Executor> Foam collapsed(Executor executor, Foam foam, const ThesisRules& rules) {
  AllSet swappable(foam.film_slots());
  Reservations<Executor> reservations(executor);
  reservations.run(view_of(foam), Operations{rules, swappable});
  note_performed(foam, reservations.take_performed());
  return foam;
}

void expect_same(const Foam& a, const Foam& b) {
  EXPECT_EQ(a.t1_count, b.t1_count);
  EXPECT_EQ(a.t2_count, b.t2_count);
  EXPECT_EQ(a.t3_count, b.t3_count);
  EXPECT_EQ(a.half_junction, b.half_junction);
  EXPECT_EQ(a.half_bubble, b.half_bubble);
  EXPECT_EQ(a.bubble_half, b.bubble_half);
  EXPECT_EQ(a.junction_half, b.junction_half);
  EXPECT_EQ(a.sides, b.sides);
  EXPECT_EQ(a.film_wrap, b.film_wrap);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.film_angle, b.film_angle);
  EXPECT_EQ(a.target_area, b.target_area);
  EXPECT_EQ(a.pressure, b.pressure);
}

/// Performs the candidate with the lowest key of all until there is none.
void collapse_greedily(Foam& foam, const ThesisRules& rules) {
  AllSet swappable(foam.film_slots());
  const Operations operations{rules, swappable};
  FoamView mesh = view_of(foam);
  while (true) {
    Index best = 0;
    for (const Index i : Operations::candidates(mesh)) {
      best = operations.key(mesh, i) < operations.key(mesh, best) ? i : best;
    }
    if (operations.key(mesh, best) == kNoReservation) {
      return;
    }
    note_performed(foam, Operations::describe(mesh, best));
    operations.perform(mesh, best);
  }
}

class Boundaries : public testing::TestWithParam<Boundary> {};
INSTANTIATE_TEST_SUITE_P(Reservations, Boundaries,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST_P(Boundaries, MeshIsValidAfterEveryRound) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Foam foam = test::jittered_foam(GetParam(), 300, seed);
    AllSet swappable(foam.film_slots());
    Host host;
    Reservations<Host> reservations(host);
    int rounds = 0;
    while (reservations.round(view_of(foam), Operations{coarse_rules(), swappable}) > 0) {
      expect_valid(foam);
      note_performed(foam, reservations.take_performed());
      ASSERT_LT(++rounds, 1000);
    }
    EXPECT_GT(foam.t1_count, 50);
    EXPECT_GT(foam.t2_count, 5);
    EXPECT_GT(rounds, 3);
    EXPECT_EQ(foam.bubble_count(), 300 - foam.t2_count - foam.t3_count);
  }
}

TEST_P(Boundaries, WinnersOfARoundTouchNoCommonBubble) {
  Foam foam = test::jittered_foam(GetParam(), 400, 5);
  AllSet swappable(foam.film_slots());
  const Operations operations{coarse_rules(), swappable};
  const ConstFoamView mesh = const_view(view_of(foam));
  std::vector<std::uint64_t> lowest(foam.bubble_half.size(), kNoReservation);
  const Slots<Index> candidates = Operations::candidates(mesh);
  std::vector<std::uint64_t> key(place_of(candidates.size()));
  Host host;
  host.for_each(candidates.size(),
                detail::Reserve<Operations>{mesh, operations, key.data(), lowest.data()});
  host.for_each(candidates.size(),
                detail::Withdraw<Operations>{mesh, operations, key.data(), lowest.data()});
  std::set<Bubble> taken;
  int winners = 0;
  for (const Index i : candidates) {
    if (key[place_of(i)] != kNoReservation) {
      ++winners;
      std::set<Bubble> own;
      for (const Bubble b : Operations::bubbles(mesh, i)) {
        own.insert(b);
      }
      own.erase(kWorld);
      for (const Bubble b : own) {
        EXPECT_TRUE(taken.insert(b).second) << b.index();
      }
    }
  }
  EXPECT_GT(winners, 10);
}

TEST_P(Boundaries, ResultDoesNotDependOnTheOrderOfVisiting) {
  const Foam start = test::jittered_foam(GetParam(), 300, 2);
  const Foam one = collapsed(Host(1), start, coarse_rules());
  EXPECT_GT(one.t1_count + one.t2_count, 100);
  for (const int threads : {2, 5}) {
    const Foam many = collapsed(Host(threads, 16), start, coarse_rules());
    expect_same(many, one);
    EXPECT_EQ(many.operations, one.operations);
  }
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Foam shuffled = collapsed(Shuffled(seed), start, coarse_rules());
    expect_same(shuffled, one);
    EXPECT_EQ(shuffled.operations, one.operations);
  }
}

/// As long as no operation makes a candidate that would have come before one that went ahead
/// elsewhere, the rounds do what a greedy walk in the order of the operations does.
TEST_P(Boundaries, RoundsDoWhatAGreedyWalkDoes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Foam start = test::jittered_foam(GetParam(), 200, seed);
    const ThesisRules rules{.limit = {.t1_length = 0.4, .t2_area = 0.4},
                            .two_sided_bubbles = TwoSidedBubbles::Remove};
    Foam greedy = start;
    collapse_greedily(greedy, rules);
    EXPECT_GT(greedy.t1_count, 5);
    expect_same(collapsed(Host(), start, rules), greedy);
  }
}

TEST_P(Boundaries, TwoSidedBubblesAreRemoved) {
  const Foam start = test::with_two_sided_bubbles(test::jittered_foam(GetParam(), 300, 3));
  expect_valid(start);
  const ThesisRules rules{.limit = {.t1_length = 0, .t2_area = 1e9},
                          .two_sided_bubbles = TwoSidedBubbles::Remove};
  const Foam rounds = collapsed(Host(), start, rules);
  expect_valid(rounds);
  EXPECT_GT(rounds.t3_count, 5);
  EXPECT_EQ(rounds.bubble_count(), start.bubble_count() - rounds.t2_count - rounds.t3_count);
}

TEST_P(Boundaries, TwoSidedBubblesSlideAsOneAfterTheOther) {
  Foam serial = test::with_two_sided_bubbles(test::jittered_foam(GetParam(), 300, 4));
  expect_valid(serial);
  Foam parallel = serial;
  const ThesisRules rules{.limit = {.t1_length = 0.05, .t2_area = 0},
                          .two_sided_bubbles = TwoSidedBubbles::Slide};
  std::int64_t slid = 0;
  for (const Bubble b : serial.bubble_slots()) {
    if (serial.has_bubble(b) && serial.sides[b] == 2 && rules.slides(serial, b)) {
      slide_two_sided_bubble(serial, b, rules.two_sided().sliding_distance());
      ++slid;
    }
  }
  AllSet waiting(parallel.bubble_slots());
  Host host(4, 16);
  EXPECT_EQ(
      Reservations<Host>(host).run(view_of(parallel), SlideOperations{rules.two_sided(), waiting}),
      slid);
  EXPECT_GT(slid, 10);
  expect_same(parallel, serial);
}

TEST(BidKey, OrdersByRankThenSizeThenNumber) {
  EXPECT_LT(reservation_key(false, 10, 9), reservation_key(true, 0, 0));
  EXPECT_LT(reservation_key(true, 0.1, 9), reservation_key(true, 0.2, 0));
  EXPECT_LT(reservation_key(true, 0, 9), reservation_key(true, 1e-30, 0));
  EXPECT_LT(reservation_key(true, 0.1, 3), reservation_key(true, 0.1, 4));
  EXPECT_NE(reservation_key(true, 1e30, 2147483647), kNoReservation);
}

} // namespace
} // namespace foam
