// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/multifrontal_solver.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <future>

#include "algebra/dense_elimination.h"
#include "parallel/kernels.h"
#include "parallel/thread_count.h"

namespace foam {
namespace {

constexpr double kSmallestPivot = 1e-13; // of a front's largest entry
constexpr double kBackwardError = 1e-7;  // of a factorisation that serves
constexpr double kWorthAThread = 2e6;    // multiplications

double largest_of(std::span<const double> entries) {
  constexpr parallel::Larger larger{};
  double largest = 0;
  for (const double entry : entries) {
    largest = larger(largest, std::abs(entry));
  }
  return largest;
}

/// Adds to the lower triangle of a front, be its columns pivots' or the contribution's.
class FrontMatrix {
public:
  FrontMatrix(std::span<double> columns, std::vector<double>& contribution, Index pivots,
              Index size)
      : columns_(columns.data()), contribution_(contribution.data()), pivots_(pivots), size_(size) {
  }

  double& operator()(Index i, Index j) const {
    const Index row = std::max(i, j);
    const Index column = std::min(i, j);
    return column < pivots_
               ? columns_[static_cast<std::ptrdiff_t>(column) * size_ + row]
               : contribution_[static_cast<std::ptrdiff_t>(column - pivots_) * (size_ - pivots_) +
                               (row - pivots_)];
  }

private:
  double* columns_;
  double* contribution_;
  Index pivots_, size_;
};

} // namespace

std::size_t MultifrontalSolver::Front::entries() const {
  return place_of(pivots()) * place_of(size());
}

std::span<Index> MultifrontalSolver::above(const Front& front) {
  return {above_.data() + front.first_above, place_of(front.above)};
}

std::span<Index> MultifrontalSolver::places_above(const Front& front) {
  return {parent_.data() + front.first_above, place_of(front.above)};
}

template <class Entry> std::span<Entry> MultifrontalSolver::columns(const Front& front) {
  return {reinterpret_cast<Entry*>(factor_.get()) + front.first_entry, front.entries()};
}

std::span<double> MultifrontalSolver::pivots(const Front& front) {
  return {pivot_.data() + front.node.begin, place_of(front.pivots())};
}

std::span<double> MultifrontalSolver::vector(const Front& front) {
  return {vector_.data() + front.node.begin + front.first_above, place_of(front.size())};
}

MultifrontalSolver::MultifrontalSolver(int threads) : threads_(thread_count(threads)) {}

template <std::size_t N>
void MultifrontalSolver::analyse(const EliminationTree& tree,
                                 std::span<const ElementMatrix<N>> elements) {
  order_ = tree.order;
  Numbering numbering{std::vector<Index>(order_.size()), std::vector<Index>(order_.size(), kNone)};
  for (std::size_t i = 0; i < order_.size(); ++i) {
    numbering.position[place_of(order_[i])] = static_cast<Index>(i);
  }
  fronts_.clear();
  std::vector<Index> front_of(order_.size()); // that eliminates a position
  for (const EliminationTree::Node& node : tree.nodes) {
    for (Index i = node.begin; i < node.end; ++i) {
      front_of[place_of(i)] = static_cast<Index>(fronts_.size());
    }
    fronts_.emplace_back().node = node;
  }
  for (std::size_t e = 0; e < elements.size(); ++e) {
    Index first = kNone;
    for (const Index u : elements[e].unknown) {
      if (u != kNone && (first == kNone || numbering.position[place_of(u)] < first)) {
        first = numbering.position[place_of(u)];
      }
    }
    if (first != kNone) {
      fronts_[place_of(front_of[place_of(first)])].elements.push_back(static_cast<Index>(e));
    }
  }
  above_.clear();
  parent_.clear();
  entries_ = 0;
  for (Front& front : fronts_) {
    find_above(front, elements, numbering);
    find_places(front, elements, numbering);
  }
  vector_.resize(order_.size() + above_.size());
  solution_.resize(order_.size());
  pivot_.resize(order_.size());
}

/// Lists the unknowns above a front that its elements and the fronts below it touch.
template <std::size_t N>
void MultifrontalSolver::find_above(Front& front, std::span<const ElementMatrix<N>> elements,
                                    Numbering& numbering) {
  front.first_above = above_.size();
  const auto meet = [&](Index p) {
    if (p >= front.node.end && numbering.place[place_of(p)] == kNone) {
      numbering.place[place_of(p)] = 0;
      above_.push_back(p);
    }
  };
  for (const Index e : front.elements) {
    for (const Index u : elements[place_of(e)].unknown) {
      if (u != kNone) {
        meet(numbering.position[place_of(u)]);
      }
    }
  }
  for (const Index child : front.node.children) {
    if (child != kNone) {
      const Front& below = fronts_[place_of(child)];
      for (std::size_t i = 0; i < place_of(below.above); ++i) {
        meet(above_[below.first_above + i]); // which may move them
      }
    }
  }
  front.above = static_cast<Index>(above_.size() - front.first_above);
  std::ranges::sort(above(front));
}

/// Finds where a front's own columns and what comes into it from below have their places.
template <std::size_t N>
void MultifrontalSolver::find_places(Front& front, std::span<const ElementMatrix<N>> elements,
                                     Numbering& numbering) {
  std::vector<Index>& place = numbering.place;
  front.first_entry = entries_;
  entries_ += front.entries();
  parent_.resize(above_.size());
  const std::span<const Index> positions = above(front);
  for (Index i = 0; i < front.pivots(); ++i) {
    place[place_of(front.node.begin + i)] = i;
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    place[place_of(positions[i])] = front.pivots() + static_cast<Index>(i);
  }
  for (const Index e : front.elements) {
    for (const Index u : elements[place_of(e)].unknown) {
      front.places.push_back(u == kNone ? kNone : place[place_of(numbering.position[place_of(u)])]);
    }
  }
  const double size = front.size();
  const double left = size - front.pivots();
  front.work = (size * size * size - left * left * left) / 6;
  for (const Index child : front.node.children) {
    if (child != kNone) {
      const Front& below = fronts_[place_of(child)];
      front.work += below.work;
      std::ranges::transform(above(below), places_above(below).begin(),
                             [&](Index p) { return place[place_of(p)]; });
    }
  }
  for (const Index p : positions) {
    place[place_of(p)] = kNone;
  }
}

/// Does something with two fronts, at the same time on several threads: part(front, threads).
template <class Part>
void MultifrontalSolver::both(Index first, Index second, int threads, const Part& part) {
  if (threads > 1) {
    std::future<void> other =
        std::async(std::launch::async, [&part, first, threads] { part(first, threads / 2); });
    part(second, threads - threads / 2);
    other.get();
  } else {
    part(first, 1);
    part(second, 1);
  }
}

/// Visits all fronts of a subtree, children before their parent: as they lie in memory.
template <class Visit>
void MultifrontalSolver::upwards(Index front, int threads, double least, const Visit& visit) const {
  const Front& root = fronts_[place_of(front)];
  const auto [first, second] = root.node.children;
  if (first != kNone) {
    both(first, second, root.work > least ? threads : 1,
         [&](Index child, int share) { upwards(child, share, least, visit); });
  }
  visit(front);
}

/// Visits all fronts of a subtree in the opposite order.
template <class Visit>
void MultifrontalSolver::downwards(Index front, int threads, double least,
                                   const Visit& visit) const {
  visit(front);
  const Front& root = fronts_[place_of(front)];
  const auto [first, second] = root.node.children;
  if (first != kNone) {
    both(second, first, root.work > least ? threads : 1,
         [&](Index child, int share) { downwards(child, share, least, visit); });
  }
}

template <std::size_t N>
Index MultifrontalSolver::factorise(std::span<const ElementMatrix<N>> elements,
                                    std::span<const double> diagonal) {
  rounded_ = false;
  if (capacity_ < entries_) {
    factor_ = std::make_unique_for_overwrite<std::byte[]>(entries_ * sizeof(double));
    capacity_ = entries_;
  }
  upwards(static_cast<Index>(fronts_.size()) - 1, threads_, kWorthAThread, [&](Index f) {
    Front& front = fronts_[place_of(f)];
    assemble(front, elements, diagonal);
    front.broken = !eliminate_densely(columns<double>(front), front.contribution, pivots(front),
                                      kSmallestPivot * largest_of(columns<double>(front)));
  });
  if (std::ranges::any_of(fronts_, &Front::broken) || !accurate(elements, diagonal)) {
    return -1;
  }
  return static_cast<Index>(std::ranges::count_if(pivot_, [](double d) { return d < 0; }));
}

template <std::size_t N>
void MultifrontalSolver::assemble(Front& front, std::span<const ElementMatrix<N>> elements,
                                  std::span<const double> diagonal) {
  const Index p = front.pivots();
  std::ranges::fill(columns<double>(front), 0.0);
  front.contribution.assign(place_of(front.above) * place_of(front.above), 0.0);
  const FrontMatrix matrix(columns<double>(front), front.contribution, p, front.size());
  for (Index i = 0; i < p; ++i) {
    matrix(i, i) = diagonal[place_of(order_[place_of(front.node.begin + i)])];
  }
  const Index* place = front.places.data();
  for (const Index e : front.elements) {
    const auto& value = elements[place_of(e)].value;
    for_each_lower<N>([&](std::size_t row, std::size_t column, std::size_t k) {
      if (place[row] != kNone && place[column] != kNone) {
        const bool folded = row != column && place[row] == place[column];
        matrix(place[row], place[column]) += (folded ? 2 : 1) * value[k];
      }
    });
    place += N;
  }
  for (const Index child : front.node.children) {
    if (child == kNone) {
      continue;
    }
    Front& below = fronts_[place_of(child)];
    const std::span<const Index> here = places_above(below);
    for (std::size_t column = 0; column < here.size(); ++column) {
      for (std::size_t row = column; row < here.size(); ++row) {
        matrix(here[row], here[column]) += below.contribution[column * here.size() + row];
      }
    }
    below.contribution.clear();
    below.contribution.shrink_to_fit();
  }
}

void MultifrontalSolver::round() {
  for (std::size_t i = rounded_ ? entries_ : 0; i < entries_; ++i) { // each from ahead of its place
    double entry = 0;
    std::memcpy(&entry, factor_.get() + i * sizeof entry, sizeof entry);
    const auto rounded = static_cast<float>(entry);
    std::memcpy(factor_.get() + i * sizeof rounded, &rounded, sizeof rounded);
  }
  rounded_ = true;
}

void MultifrontalSolver::solve(std::span<double> rhs) {
  for (std::size_t i = 0; i < rhs.size(); ++i) {
    solution_[i] = rhs[place_of(order_[i])];
  }
  const auto root = static_cast<Index>(fronts_.size()) - 1;
  const double least = 10 * kWorthAThread;
  upwards(root, threads_, least, [&](Index f) { solve_upwards(fronts_[place_of(f)]); });
  downwards(root, threads_, least, [&](Index f) { solve_downwards(fronts_[place_of(f)]); });
  for (std::size_t i = 0; i < rhs.size(); ++i) {
    rhs[place_of(order_[i])] = solution_[i];
  }
}

/// y ← D⁻¹·L⁻¹·y of the pivots. What that does to those above goes to the parent.
void MultifrontalSolver::solve_upwards(Front& front) {
  const std::span<double> x = vector(front);
  const auto above = std::copy_n(solution_.begin() + front.node.begin, front.pivots(), x.begin());
  std::fill(above, x.end(), 0.0);
  for (const Index child : front.node.children) {
    if (child != kNone) {
      const Front& below = fronts_[place_of(child)];
      const std::span<const Index> place = places_above(below);
      const std::span<const double> from = vector(below).subspan(place_of(below.pivots()));
      for (std::size_t i = 0; i < place.size(); ++i) {
        x[place_of(place[i])] += from[i];
      }
    }
  }
  if (rounded_) {
    solve_lower(columns<const float>(front), x);
  } else {
    solve_lower(columns<const double>(front), x);
  }
  std::transform(x.begin(), above, pivots(front).begin(), x.begin(), std::divides<>());
}

/// y ← L⁻ᵀ·y of the pivots.
void MultifrontalSolver::solve_downwards(Front& front) {
  const std::span<double> x = vector(front);
  std::ranges::transform(above(front), x.begin() + front.pivots(),
                         [&](Index p) { return solution_[place_of(p)]; });
  if (rounded_) {
    solve_upper(columns<const float>(front), x);
  } else {
    solve_upper(columns<const double>(front), x);
  }
  std::copy_n(x.begin(), front.pivots(), solution_.begin() + front.node.begin);
}

/// Whether small pivots have left enough digits: the backward error of one solution (N. J. Higham,
/// Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, ch. 7).
template <std::size_t N>
bool MultifrontalSolver::accurate(std::span<const ElementMatrix<N>> elements,
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
  for (const ElementMatrix<N>& element : elements) {
    subtract_product(element, element.unknown, solution, rest);
    largest = std::max(largest, largest_entry(element));
  }
  return largest_of(rest) < kBackwardError * largest * largest_of(solution);
}

// The sizes in use; others are to be added here.
template void MultifrontalSolver::analyse(const EliminationTree&,
                                          std::span<const ElementMatrix<7>>);
template Index MultifrontalSolver::factorise(std::span<const ElementMatrix<7>>,
                                             std::span<const double>);

} // namespace foam
