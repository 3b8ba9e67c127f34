// SPDX-License-Identifier: GPL-3.0-or-later
//
// The equations of one junction (thesis 3.1): the areas of its three bubbles and what a root search
// asks of its three films, against the three pressures and its position.
//
// Functions are templates of the mesh, a Foam or what stands for one on another device
// (mesh/mesh_access.h), and of the root search, AngleRootSearch or EnergyRootSearch. That offers
//   kConditions           the number of its conditions on the films,
//   values(star)          the quantities that its conditions are about,
//   targets(star)         what these shall be, and
//   solve(star, system)   the step z that a system asks for.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mesh/mesh_access.h"
#include "thesis/thesis_film.h"

namespace foam::thesis {

/// A junction with its three films and bubbles, counter-clockwise. Bubble k lies on the left of
/// film k, between films k and k + 1.
struct JunctionStar {
  std::array<Half, 3> half{};          ///< outgoing
  std::array<Bubble, 3> bubble{};      ///< or outsides
  std::array<Vec2, 3> chord{};         ///< e_k = x_k − x, cm
  std::array<double, 3> pressure{};    ///< of the bubbles, N/cm²
  std::array<double, 3> target_area{}; ///< A^τ of the bubbles, cm²; an outside has none
  double tension = 0;                  ///< of all films, 2γ, N/cm
};

/// The quantities that a junction's equations are about.
template <class Search> struct JunctionSample {
  std::array<double, 3> area{};                    ///< of the bubbles, cm²
  std::array<double, Search::kConditions> value{}; ///< of the films
};

/// A junction's unknowns p_i, p_j, p_k, x, y, N/cm² and cm.
inline constexpr std::size_t kUnknowns = 5;

/// ∇f_j by rows: A_i, A_j, A_k and the root search's conditions.
template <class Search>
using JunctionJacobian = std::array<std::array<double, kUnknowns>, 3 + Search::kConditions>;

/// The equations jacobian·z = deviation of a junction's change z. The thesis writes ∇f_j·z = −f_j
/// (3.1.7), but in its ∇f_j has the derivatives of A and θ, of which f_j holds the negatives: the
/// two signs cancel.
template <class Search> struct JunctionSystem {
  JunctionJacobian<Search> jacobian{};
  std::array<double, 3 + Search::kConditions> deviation{}; ///< f_j, what lacks to the targets
  std::array<bool, kUnknowns> ignored{};
};

/// The solution of a junction's system.
struct JunctionStep {
  std::array<double, 3> pressure{}; ///< Δp of the bubbles, N/cm²
  Vec2 position;                    ///< Δx, cm

  FOAM_HOST_DEVICE bool finite() const {
    return std::isfinite(pressure[0] + pressure[1] + pressure[2] + position.x + position.y);
  }
};

FOAM_HOST_DEVICE inline constexpr std::size_t after(std::size_t k) {
  return (k + 1) % 3;
}
FOAM_HOST_DEVICE inline constexpr std::size_t before(std::size_t k) {
  return (k + 2) % 3;
}

template <class Mesh>
FOAM_HOST_DEVICE JunctionStar junction_star(const Mesh& mesh, Junction junction) {
  JunctionStar star;
  star.half = mesh.junction_half[junction];
  star.tension = mesh.reference_tension();
  for (std::size_t k = 0; k < 3; ++k) {
    star.bubble[k] = mesh.left(star.half[k]);
    star.chord[k] = mesh.chord(star.half[k]);
    star.pressure[k] = mesh.pressure_of(star.bubble[k]);
    if (!star.bubble[k].is_outside()) {
      star.target_area[k] = mesh.target_area[star.bubble[k]];
    }
  }
  return star;
}

/// Half-angle of the junction's film k, bubble k on its left, bubble k − 1 on its right.
FOAM_HOST_DEVICE inline double half_angle(const JunctionStar& star, std::size_t k) {
  return thesis_half_angle(norm(star.chord[k]), star.pressure[k] - star.pressure[before(k)],
                           star.tension);
}

/// φ, the angle that turns edge a into edge b counter-clockwise, in [0, 2π) (3.3.3, 3.3.4).
FOAM_HOST_DEVICE inline double edge_angle(Vec2 a, Vec2 b) {
  const double psi = angle_from_to(a, b);
  return psi < 0 ? psi + 2 * std::numbers::pi : psi;
}

/// θ = φ − α_j + α_k (3.3.7), with the signs of half-angles that are all seen from the junction.
FOAM_HOST_DEVICE inline double angle_between(const JunctionStar& star, std::size_t from,
                                             std::size_t to) {
  return edge_angle(star.chord[from], star.chord[to]) + half_angle(star, from) -
         half_angle(star, to);
}

FOAM_HOST_DEVICE inline std::array<double, 3> angles_between(const JunctionStar& star) {
  return {angle_between(star, 0, 1), angle_between(star, 1, 2), angle_between(star, 2, 0)};
}

/// Length of the junction's film k (3.5.1), cm.
FOAM_HOST_DEVICE inline double film_length(const JunctionStar& star, std::size_t k) {
  return arc_length(norm(star.chord[k]), half_angle(star, k));
}

/// Energy of the films that meet in the junction, 2γ·Σl (3.5.2), N.
FOAM_HOST_DEVICE inline double local_energy(const JunctionStar& star) {
  return star.tension * (film_length(star, 0) + film_length(star, 1) + film_length(star, 2));
}

/// The orientation invariant (3.5.1): films 0, 1, 2 follow each other counter-clockwise.
FOAM_HOST_DEVICE inline bool oriented(const JunctionStar& star) {
  return angle_between(star, 0, 1) < angle_between(star, 0, 2);
}

/// A_⌢ (3.3.10) of half-film h on the account of its left bubble, whose pressure is given.
template <class Mesh>
FOAM_HOST_DEVICE double thesis_segment(const Mesh& mesh, Half h, double left_pressure) {
  if (mesh.wall(h)) {
    return 0;
  }
  const double chord = norm(mesh.chord(h));
  const double difference = left_pressure - mesh.pressure_of(mesh.right(h));
  return segment_area(chord, thesis_half_angle(chord, difference, mesh.reference_tension()));
}

/// Area (3.3.12) of the bubble on the left of h, cm².
template <class Mesh> FOAM_HOST_DEVICE double thesis_area(const Mesh& mesh, Half first) {
  const double pressure = mesh.pressure_of(mesh.left(first));
  double twice_polygon = 0;
  double segments = 0;
  Vec2 at;
  Half h = first;
  do {
    const Vec2 chord = mesh.chord(h);
    twice_polygon += cross(at, chord);
    segments += thesis_segment(mesh, h, pressure);
    at += chord;
    h = mesh.next_in_bubble(h);
  } while (h != first);
  return 0.5 * twice_polygon + segments;
}

/// Areas and film values with the pressure of bubble k changed by dp, but for what does not depend
/// on it.
template <class Search, class Mesh>
FOAM_HOST_DEVICE JunctionSample<Search> vary_pressure(const Search& search, const Mesh& mesh,
                                                      JunctionStar star, std::size_t k, double dp) {
  star.pressure[k] += dp;
  JunctionSample<Search> sample;
  sample.value = search.values(star);
  Half h = star.half[k];
  do {
    const double segment = thesis_segment(mesh, h, star.pressure[k]);
    sample.area[k] += segment;
    for (const std::size_t other : {after(k), before(k)}) {
      if (mesh.right(h) == star.bubble[other]) {
        sample.area[other] -= segment;
      }
    }
    h = mesh.next_in_bubble(h);
  } while (h != star.half[k]);
  return sample;
}

/// Areas and film values with the junction moved, but for what does not depend on its position: of
/// a bubble's polygon the triangle that has a corner in the junction remains, of its arcs the two
/// that end there.
template <class Search>
FOAM_HOST_DEVICE JunctionSample<Search> vary_position(const Search& search, JunctionStar star,
                                                      Vec2 move) {
  std::array<double, 3> segment{};
  for (std::size_t k = 0; k < 3; ++k) {
    star.chord[k] -= move;
    segment[k] = segment_area(norm(star.chord[k]), half_angle(star, k));
  }
  JunctionSample<Search> sample;
  sample.value = search.values(star);
  for (std::size_t k = 0; k < 3; ++k) {
    sample.area[k] =
        0.5 * cross(star.chord[k], star.chord[after(k)]) + segment[k] - segment[after(k)];
  }
  return sample;
}

/// ∇f_j by central differences with step h (3.1.1); an outside's row and column are zero (3.4.1).
template <class Search, class Mesh>
FOAM_HOST_DEVICE JunctionJacobian<Search> junction_jacobian(const Search& search, const Mesh& mesh,
                                                            const JunctionStar& star, double h) {
  JunctionJacobian<Search> jacobian{};
  const auto set_column = [&](std::size_t c, const JunctionSample<Search>& plus,
                              const JunctionSample<Search>& minus) {
    for (std::size_t k = 0; k < 3; ++k) {
      jacobian[k][c] = star.bubble[k].is_outside() ? 0 : (plus.area[k] - minus.area[k]) / (2 * h);
    }
    for (std::size_t k = 0; k < Search::kConditions; ++k) {
      jacobian[3 + k][c] = (plus.value[k] - minus.value[k]) / (2 * h);
    }
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (!star.bubble[k].is_outside()) {
      set_column(k, vary_pressure(search, mesh, star, k, h),
                 vary_pressure(search, mesh, star, k, -h));
    }
  }
  set_column(3, vary_position(search, star, {h, 0}), vary_position(search, star, {-h, 0}));
  set_column(4, vary_position(search, star, {0, h}), vary_position(search, star, {0, -h}));
  return jacobian;
}

/// ‖a − b‖_∞, the largest sum of a row.
template <std::size_t Rows, std::size_t Columns>
FOAM_HOST_DEVICE double
row_norm_of_difference(const std::array<std::array<double, Columns>, Rows>& a,
                       const std::array<std::array<double, Columns>, Rows>& b) {
  double largest = 0;
  for (std::size_t r = 0; r < Rows; ++r) {
    double sum = 0;
    for (std::size_t c = 0; c < Columns; ++c) {
      sum += std::abs(a[r][c] - b[r][c]);
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

/// How ∇f_j is found: h, δ_error and δ_scale of Figure 4.1.
struct DifferenceOptions {
  double step = 0;
  double tolerance = 0;
  double minimum_scale = 0;
};

/// ∇f_j with the step halved until two in a row differ by no more than δ_error (Figure 4.1).
template <class Search, class Mesh>
FOAM_HOST_DEVICE JunctionJacobian<Search> adaptive_jacobian(const Search& search, const Mesh& mesh,
                                                            const JunctionStar& star,
                                                            const DifferenceOptions& options) {
  JunctionJacobian<Search> jacobian{};
  double error = 2 * options.tolerance;
  for (double scale = 1; error > options.tolerance && scale > options.minimum_scale; scale *= 0.5) {
    const JunctionJacobian<Search> old = jacobian;
    jacobian = junction_jacobian(search, mesh, star, options.step * scale);
    error = row_norm_of_difference(jacobian, old);
  }
  return jacobian;
}

/// f_j and ∇f_j. In a junction that is pinned to a container's wall each of its bubbles' pressures
/// answers for its own area alone, and nothing moves.
template <class Search, class Mesh>
FOAM_HOST_DEVICE JunctionSystem<Search> junction_system(const Search& search, const Mesh& mesh,
                                                        Junction junction, const JunctionStar& star,
                                                        const DifferenceOptions& options) {
  JunctionSystem<Search> system;
  system.jacobian = adaptive_jacobian(search, mesh, star, options);
  for (std::size_t k = 0; k < 3; ++k) {
    system.ignored[k] = star.bubble[k].is_outside();
    if (!system.ignored[k]) {
      system.deviation[k] = star.target_area[k] - thesis_area(mesh, star.half[k]);
    }
  }
  if (!mesh.freedom(junction).any()) {
    system.ignored[3] = system.ignored[4] = true;
    for (std::size_t r = 0; r < system.jacobian.size(); ++r) {
      for (std::size_t c = 0; c < kUnknowns; ++c) {
        system.jacobian[r][c] = r == c ? system.jacobian[r][c] : 0;
      }
    }
  } else {
    const auto value = search.values(star);
    const auto target = search.targets(star);
    for (std::size_t k = 0; k < Search::kConditions; ++k) {
      system.deviation[3 + k] = target[k] - value[k];
    }
  }
  return system;
}

} // namespace foam::thesis
