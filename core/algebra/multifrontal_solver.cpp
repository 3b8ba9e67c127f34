// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/multifrontal_solver.h"

#include <algorithm>
#include <cmath>
#include <future>

#include "algebra/dense_elimination.h"
#include "parallel/thread_count.h"

namespace foam {
namespace {

constexpr double kSmallestPivot = 1e-13; // of a front's largest entry
constexpr double kBackwardError = 1e-7;  // of a factorisation that serves
constexpr double kWorthAThread = 2e6;    // multiplications

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

double largest_of(std::span<const double> entries) {
  double largest = 0;
  for (const double entry : entries) {
    largest = std::max(largest, std::abs(entry));
  }
  return largest;
}

/// Adds to the lower triangle of a front, be its columns pivots' or the contribution's.
class FrontMatrix {
public:
  FrontMatrix(std::vector<double>& panel, std::vector<double>& contribution, Index pivots,
              Index size)
      : panel_(panel.data()), contribution_(contribution.data()), pivots_(pivots), size_(size) {}

  double& operator()(Index i, Index j) const {
    const Index row = std::max(i, j);
    const Index column = std::min(i, j);
    return column < pivots_
               ? panel_[static_cast<std::ptrdiff_t>(column) * size_ + row]
               : contribution_[static_cast<std::ptrdiff_t>(column - pivots_) * (size_ - pivots_) +
                               (row - pivots_)];
  }

private:
  double* panel_;
  double* contribution_;
  Index pivots_, size_;
};

} // namespace

MultifrontalSolver::MultifrontalSolver(int threads) : threads_(thread_count(threads)) {}

void MultifrontalSolver::analyse(const EliminationTree& tree, std::span<const FilmShare> shares) {
  order_ = tree.order;
  std::vector<Index> position(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    position[at(order_[i])] = static_cast<Index>(i);
  }
  fronts_.clear();
  std::vector<Index> front_of(order_.size()); // that eliminates a position
  for (const EliminationTree::Node& node : tree.nodes) {
    for (Index i = node.begin; i < node.end; ++i) {
      front_of[at(i)] = static_cast<Index>(fronts_.size());
    }
    fronts_.emplace_back().node = node;
  }
  for (std::size_t s = 0; s < shares.size(); ++s) {
    Index first = kNone;
    for (const Index u : shares[s].unknown) {
      if (u != kNone && (first == kNone || position[at(u)] < first)) {
        first = position[at(u)];
      }
    }
    if (first != kNone) {
      fronts_[at(front_of[at(first)])].shares.push_back(static_cast<Index>(s));
    }
  }
  std::vector<Index> place(order_.size(), kNone); // in the front at hand, by position
  for (Front& front : fronts_) {
    const auto meet = [&](Index p) {
      if (p >= front.node.end && place[at(p)] == kNone) {
        place[at(p)] = 0;
        front.above.push_back(p);
      }
    };
    for (const Index s : front.shares) {
      for (const Index u : shares[at(s)].unknown) {
        if (u != kNone) {
          meet(position[at(u)]);
        }
      }
    }
    for (const Index child : front.node.children) {
      if (child != kNone) {
        std::ranges::for_each(fronts_[at(child)].above, meet);
      }
    }
    std::ranges::sort(front.above);
    for (Index i = 0; i < front.pivots(); ++i) {
      place[at(front.node.begin + i)] = i;
    }
    for (std::size_t i = 0; i < front.above.size(); ++i) {
      place[at(front.above[i])] = front.pivots() + static_cast<Index>(i);
    }
    for (const Index s : front.shares) {
      auto& places = front.places.emplace_back();
      std::ranges::transform(shares[at(s)].unknown, places.begin(), [&](Index u) {
        return u == kNone ? kNone : place[at(position[at(u)])];
      });
    }
    const double size = front.size();
    const double left = size - front.pivots();
    front.work = (size * size * size - left * left * left) / 6;
    for (const Index child : front.node.children) {
      if (child != kNone) {
        Front& below = fronts_[at(child)];
        front.work += below.work;
        std::ranges::transform(below.above, std::back_inserter(below.parent),
                               [&](Index p) { return place[at(p)]; });
      }
    }
    for (const Index p : front.above) {
      place[at(p)] = kNone;
    }
  }
}

/// Does something with both children of a front, at the same time if it is worth it: part(child,
/// threads).
template <class Part>
void MultifrontalSolver::both_children(Index front, int threads, double least,
                                       const Part& part) const {
  const auto [first, second] = fronts_[at(front)].node.children;
  if (first == kNone) {
    return;
  }
  if (threads > 1 && fronts_[at(front)].work > least) {
    std::future<void> other = std::async(
        std::launch::async, [&part, child = first, threads] { part(child, threads / 2); });
    part(second, threads - threads / 2);
    other.get();
  } else {
    part(first, 1);
    part(second, 1);
  }
}

/// Visits all fronts of a subtree, children before their parent.
template <class Visit>
void MultifrontalSolver::upwards(Index front, int threads, double least, const Visit& visit) const {
  both_children(front, threads, least,
                [&](Index child, int share) { upwards(child, share, least, visit); });
  visit(front);
}

/// Visits all fronts of a subtree, children after their parent.
template <class Visit>
void MultifrontalSolver::downwards(Index front, int threads, double least,
                                   const Visit& visit) const {
  visit(front);
  both_children(front, threads, least,
                [&](Index child, int share) { downwards(child, share, least, visit); });
}

Index MultifrontalSolver::factorise(std::span<const FilmShare> shares,
                                    std::span<const double> diagonal) {
  upwards(static_cast<Index>(fronts_.size()) - 1, threads_, kWorthAThread, [&](Index f) {
    Front& front = fronts_[at(f)];
    assemble(front, shares, diagonal);
    front.pivot.resize(at(front.pivots()));
    front.broken = !eliminate_densely(front.panel, front.contribution, front.pivot,
                                      kSmallestPivot * largest_of(front.panel));
  });
  Index negative = 0;
  for (const Front& front : fronts_) {
    if (front.broken) {
      return -1;
    }
    negative +=
        static_cast<Index>(std::ranges::count_if(front.pivot, [](double d) { return d < 0; }));
  }
  return accurate(shares, diagonal) ? negative : -1;
}

void MultifrontalSolver::assemble(Front& front, std::span<const FilmShare> shares,
                                  std::span<const double> diagonal) {
  const Index p = front.pivots();
  const auto above = front.above.size();
  front.panel.assign(at(p) * at(front.size()), 0.0);
  front.contribution.assign(above * above, 0.0);
  const FrontMatrix matrix(front.panel, front.contribution, p, front.size());
  for (Index i = 0; i < p; ++i) {
    matrix(i, i) = diagonal[at(order_[at(front.node.begin + i)])];
  }
  for (std::size_t s = 0; s < front.shares.size(); ++s) {
    const std::array<Index, 7>& place = front.places[s];
    const double* value = shares[at(front.shares[s])].value.data();
    for (std::size_t row = 0; row < 7; ++row) {
      for (std::size_t column = 0; column <= row; ++column, ++value) {
        if (place[row] != kNone && place[column] != kNone) {
          const bool folded = row != column && place[row] == place[column];
          matrix(place[row], place[column]) += (folded ? 2 : 1) * *value;
        }
      }
    }
  }
  for (const Index child : front.node.children) {
    if (child == kNone) {
      continue;
    }
    Front& below = fronts_[at(child)];
    const std::size_t count = below.parent.size();
    for (std::size_t column = 0; column < count; ++column) {
      for (std::size_t row = column; row < count; ++row) {
        matrix(below.parent[row], below.parent[column]) += below.contribution[column * count + row];
      }
    }
    below.contribution.clear();
    below.contribution.shrink_to_fit();
  }
}

void MultifrontalSolver::solve(std::span<double> rhs) {
  vector_.resize(rhs.size());
  for (std::size_t i = 0; i < rhs.size(); ++i) {
    vector_[i] = rhs[at(order_[i])];
  }
  const auto root = static_cast<Index>(fronts_.size()) - 1;
  const double least = 10 * kWorthAThread;
  upwards(root, threads_, least, [&](Index f) { solve_upwards(fronts_[at(f)]); });
  downwards(root, threads_, least, [&](Index f) { solve_downwards(fronts_[at(f)]); });
  for (std::size_t i = 0; i < rhs.size(); ++i) {
    rhs[at(order_[i])] = vector_[i];
  }
}

/// y ← D⁻¹·L⁻¹·y of the pivots; what that does to those above goes to the parent.
void MultifrontalSolver::solve_upwards(Front& front) {
  const std::span own = std::span(vector_).subspan(at(front.node.begin), front.pivot.size());
  front.contribution.assign(front.above.size(), 0.0);
  for (const Index child : front.node.children) {
    if (child != kNone) {
      const Front& below = fronts_[at(child)];
      for (std::size_t i = 0; i < below.parent.size(); ++i) {
        const auto place = at(below.parent[i]);
        (place < own.size() ? own[place] : front.contribution[place - own.size()]) +=
            below.contribution[i];
      }
    }
  }
  solve_lower(front.panel, own, front.contribution);
  for (std::size_t i = 0; i < own.size(); ++i) {
    own[i] /= front.pivot[i];
  }
}

/// y ← L⁻ᵀ·y of the pivots.
void MultifrontalSolver::solve_downwards(Front& front) {
  for (std::size_t i = 0; i < front.above.size(); ++i) {
    front.contribution[i] = vector_[at(front.above[i])];
  }
  solve_upper(front.panel, std::span(vector_).subspan(at(front.node.begin), front.pivot.size()),
              front.contribution);
}

/// Whether small pivots have left enough digits: the backward error of one solution (N. J. Higham,
/// Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, ch. 7).
bool MultifrontalSolver::accurate(std::span<const FilmShare> shares,
                                  std::span<const double> diagonal) {
  constexpr double kGoldenRatio = 0.6180339887498949; // its multiples' fractions repeat nowhere
  std::vector<double> rest(order_.size());
  for (std::size_t u = 0; u < rest.size(); ++u) {
    const double multiple = kGoldenRatio * static_cast<double>(u);
    rest[u] = multiple - std::floor(multiple) - 0.5;
  }
  std::vector<double> solution = rest;
  solve(solution);
  for (std::size_t u = 0; u < rest.size(); ++u) {
    rest[u] -= diagonal[u] * solution[u];
  }
  double largest = 0;
  for (const FilmShare& share : shares) {
    subtract_product(share, share.unknown, solution, rest);
    largest = std::max(largest, largest_entry(share));
  }
  return largest_of(rest) < kBackwardError * largest * largest_of(solution);
}

} // namespace foam
