// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/film_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "construct/jittered_grid.h"
#include "hand_made.h"
#include "topology/operations.h"

namespace foam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

FilmSet sample(Boundary boundary, Index n = 12) {
  BuildOptions options;
  options.boundary = boundary;
  FilmSet set = film_set(build_from_points(jittered_grid(n, 1, 1, 1), options));
  set.time = 1.5;
  set.t1_count = 3;
  set.t2_count = 2;
  set.t3_count = 1;
  set.report = {true, 7, 1e-12, 1e-13, 1e-14};
  for (std::size_t f = 0; f < set.films.size(); ++f) {
    set.films[f].half_angle = 0.01 * static_cast<double>(f % 7);
  }
  for (std::size_t b = 0; b < set.bubbles.size(); ++b) {
    set.bubbles[b].pressure = 0.1 * static_cast<double>(b);
  }
  return set;
}

void expect_same(const FilmSet& a, const FilmSet& b) {
  EXPECT_EQ(a.junctions, b.junctions);
  EXPECT_TRUE(a.films == b.films);
  EXPECT_EQ(a.tensions, b.tensions);
  EXPECT_TRUE(a.bubbles == b.bubbles);
  EXPECT_TRUE(a.exteriors == b.exteriors);
  EXPECT_TRUE(static_cast<const FoamRecord&>(a) == static_cast<const FoamRecord&>(b));
  EXPECT_TRUE(a == b);
}

std::string error_of(const FilmSet& set) {
  try {
    foam_of(set);
  } catch (const FoamError& error) {
    return error.what();
  }
  return "no error";
}

class AnyBoundary : public testing::TestWithParam<Boundary> {};
INSTANTIATE_TEST_SUITE_P(Boundaries, AnyBoundary,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST_P(AnyBoundary, RoundTripKeepsEverything) {
  for (const Index n : {3, 4, 12, 200}) {
    const FilmSet set = sample(GetParam(), n);
    expect_same(film_set(foam_of(set)), set);
  }
}

TEST_P(AnyBoundary, VanishedElementsAreLeftOut) {
  BuildOptions options;
  options.boundary = GetParam();
  Foam foam = build_from_points(jittered_grid(40, 1, 1, 3), options);
  Index removed = 0;
  for (const Film f : foam.film_slots()) {
    if (removed >= 5 || !can_perform_t1(foam, f)) {
      continue;
    }
    for (const Bubble b : perform_t1(foam, f)) {
      if (!b.is_outside() && can_perform_t2(foam, b)) {
        perform_t2(foam, b);
        ++removed;
      }
    }
  }
  ASSERT_GT(removed, 0);
  const FilmSet set = film_set(foam);
  EXPECT_EQ(set.bubbles.size(), static_cast<std::size_t>(40 - removed));
  EXPECT_EQ(set.films.size(), place_of(foam.film_count()));
  EXPECT_EQ(set.junctions.size(), place_of(foam.junction_count()));
  const Foam read = foam_of(set);
  expect_valid(read);
  EXPECT_NEAR(read.energy(), foam.energy(), 1e-12 * foam.energy());
  expect_same(film_set(read), set);
}

TEST_P(AnyBoundary, BubblesMayHaveAnyIds) {
  FilmSet set = sample(GetParam());
  const auto renamed = [](std::int64_t id) { return id < 0 ? id : 5'000'000'000 + 7 * id; };
  for (auto& bubble : set.bubbles) {
    bubble.id = renamed(bubble.id);
  }
  for (auto& film : set.films) {
    film.left = renamed(film.left);
    film.right = renamed(film.right);
  }
  expect_same(film_set(foam_of(set)), set);
}

struct Damage {
  std::string error;
  std::function<void(FilmSet&)> do_it;
};

TEST(FilmSet, ErrorsNameTheElement) {
  const std::vector<Damage> damages = {
      {"the foam has no films", [](FilmSet& s) { s.films.clear(); }},
      {"TimeValue is nan", [](FilmSet& s) { s.time = kNan; }},
      {"SurfaceTension must be positive, but is 0", [](FilmSet& s) { s.surface_tension = 0; }},
      {"the periods (0, 0) and (0, ", [](FilmSet& s) { s.surroundings.lattice.first = {}; }},
      {"film 0 names bubble ", [](FilmSet& s) { s.bubbles.erase(s.bubbles.begin()); }},
      {"film 4 names bubble 99, which is not listed", [](FilmSet& s) { s.films[4].left = 99; }},
      {"BubbleId 3 is negative or listed twice", [](FilmSet& s) { s.bubbles[4].id = 3; }},
      {"BubbleId -1 is negative or listed twice", [](FilmSet& s) { s.bubbles[4].id = -1; }},
      {"the pressure of bubble 2 is nan", [](FilmSet& s) { s.bubbles[2].pressure = kNan; }},
      {"the target area of bubble 2 must be positive, but is -1",
       [](FilmSet& s) { s.bubbles[2].target_area = -1; }},
      {"the target area of bubble 2 must be positive, but is nan",
       [](FilmSet& s) { s.bubbles[2].target_area = kNan; }},
      {"the position of junction 5 is nan", [](FilmSet& s) { s.junctions[5].y = kNan; }},
      {"the half-angle of film 6 is 3.2", [](FilmSet& s) { s.films[6].half_angle = 3.2; }},
      {"the half-angle of film 6 is nan", [](FilmSet& s) { s.films[6].half_angle = kNan; }},
      {"film 7 ends in junction 24, which does not exist", [](FilmSet& s) { s.films[7].end = 24; }},
      {"film 7 ends in junction -1, which does not exist",
       [](FilmSet& s) { s.films[7].start = -1; }},
      {"2 films meet in junction ", [](FilmSet& s) { s.films.pop_back(); }},
      {"more than three films meet in junction ",
       [](FilmSet& s) { s.films.push_back(s.films[0]); }},
      {"0 films meet in junction 24, not three", [](FilmSet& s) { s.junctions.push_back({}); }},
      {"the bubbles around junction ",
       [](FilmSet& s) { std::swap(s.films[3].left, s.films[3].right); }},
      {"the films of bubble ", [](FilmSet& s) { s.films[2].wrap.x += 1; }},
  };
  for (const Damage& damage : damages) {
    FilmSet set = sample(Boundary::Periodic);
    damage.do_it(set);
    EXPECT_EQ(error_of(set).find(damage.error), 0u) << damage.error << " / " << error_of(set);
  }
}

/// Tensions that differ a little from film to film, so that every junction can hold them.
std::vector<double> some_tensions(const FilmSet& set) {
  std::vector<double> tensions;
  for (std::size_t f = 0; f < set.films.size(); ++f) {
    tensions.push_back(0.5 + 0.01 * static_cast<double>(f % 11));
  }
  return tensions;
}

TEST_P(AnyBoundary, RoundTripKeepsTensionsAndOutsides) {
  FilmSet set = sample(GetParam());
  set.tensions = some_tensions(set);
  for (Exterior& exterior : set.exteriors) {
    exterior.pressure = 0.25;
  }
  const Foam foam = foam_of(set);
  EXPECT_FALSE(foam.has_uniform_tension());
  EXPECT_EQ(foam.tension(Film(7)), set.tensions[7]);
  EXPECT_EQ(foam.exterior.size(), GetParam() == Boundary::Periodic ? 0u : 1u);
  expect_same(film_set(foam), set);
}

TEST(FilmSet, RoundTripKeepsASkewedTorus) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = Lattice{{0.5, -1}, {4, 0.5}, {5.5, 4}};
  FilmSet set = film_set(build_from_points(jittered_grid(16, 1, 1, 1), options));
  set.tensions = some_tensions(set);
  const Foam foam = foam_of(set);
  EXPECT_EQ(foam.surroundings.lattice, *options.torus);
  expect_same(film_set(foam), set);
}

TEST(FilmSet, OutsidesThatAreNotListedGoWithTheBoundary) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Fixed}) {
    FilmSet set = sample(boundary);
    const std::vector<Exterior> listed = std::exchange(set.exteriors, {});
    ASSERT_EQ(listed.size(), 1u);
    EXPECT_EQ(listed[0].kind,
              boundary == Boundary::Fixed ? Exterior::Kind::Solid : Exterior::Kind::Gas);
    EXPECT_TRUE(film_set(foam_of(set)).exteriors == listed);
  }
}

TEST(FilmSet, ErrorsInTensionsNameFilmAndJunction) {
  FilmSet set = sample(Boundary::Free);
  const std::size_t films = set.films.size();
  set.tensions = {0.5, 0.5};
  EXPECT_EQ(error_of(set), "there are 2 tensions for " + std::to_string(films) + " films");
  for (const auto& [bad, text] : {std::pair{0.0, "0"}, {-0.5, "-0.5"}, {kNan, "nan"}}) {
    set.tensions.assign(films, 0.5);
    set.tensions[3] = bad;
    EXPECT_EQ(error_of(set), std::string("the tension of film 3 must be positive, but is ") + text);
  }
  // A film as strong as the two others together leaves them no angle.
  set.tensions.assign(films, 0.5);
  const Foam foam = foam_of(set);
  const auto& halves = foam.junction_half[Junction(2)];
  set.tensions[halves[0].film().place()] = 0.25;
  set.tensions[halves[1].film().place()] = 0.75;
  EXPECT_EQ(error_of(set), "junction 2 cannot hold films of tensions 0.25, 0.75 and 0.5 N/cm: one "
                           "pulls harder than the other two together");
}

TEST(FilmSet, PinnedJunctionsHoldAnyTensions) {
  FilmSet set = sample(Boundary::Fixed);
  set.tensions.assign(set.films.size(), 0.5);
  const Foam foam = foam_of(set);
  for (const Film f : foam.film_slots()) {
    if (foam.wall(f.half())) {
      set.tensions[f.place()] = 5;
    }
  }
  EXPECT_EQ(error_of(set), "no error");
}

TEST(FilmSet, ABubbleWithoutFilmsIsRefused) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    FilmSet set = sample(boundary);
    set.bubbles.push_back({1000, 0, 1});
    EXPECT_EQ(error_of(set), "bubble 1000 has no films");
  }
}

TEST(FilmSet, TwoFoamsInOneAreRefused) {
  FilmSet set = sample(Boundary::Free);
  const FilmSet other = sample(Boundary::Free);
  const auto junctions = static_cast<Index>(set.junctions.size());
  for (const Vec2 p : other.junctions) {
    set.junctions.push_back({p.x + 100, p.y});
  }
  const auto shifted = [](std::int64_t id) { return id < 0 ? id : id + 100; };
  for (auto film : other.films) {
    set.films.push_back({film.start + junctions, film.end + junctions, shifted(film.left),
                         shifted(film.right), film.half_angle, film.wrap});
  }
  for (const auto& bubble : other.bubbles) {
    set.bubbles.push_back({bubble.id + 100, bubble.pressure, bubble.target_area});
  }
  EXPECT_EQ(error_of(set).find("Euler's V - E + F is "), 0u) << error_of(set);
}

/// Random damage to a few entries.
class Vandal {
public:
  explicit Vandal(unsigned seed) : random_(seed) {}

  void damage(FilmSet& set) {
    for (auto n = pick(3); n-- > -1;) {
      strike(set);
    }
  }

private:
  std::int64_t pick(std::size_t n) { return static_cast<std::int64_t>(random_() % n); }
  template <class T> T& any(std::vector<T>& of) {
    return of[static_cast<std::size_t>(pick(of.size()))];
  }
  Index junction(const FilmSet& set) {
    return static_cast<Index>(pick(set.junctions.size() + 3)) - 2;
  }
  std::int64_t bubble(const FilmSet& set) { return pick(set.bubbles.size() + 3) - 2; }
  double real() {
    const std::vector<double> values{kNan, std::numeric_limits<double>::infinity(), -4, 0, 1e300,
                                     0.5};
    return values[static_cast<std::size_t>(pick(values.size()))];
  }

  void strike(FilmSet& set) {
    if (set.films.empty() || set.bubbles.empty() || set.junctions.empty()) {
      return;
    }
    auto& film = any(set.films);
    switch (pick(12)) {
    case 0:
      film.start = junction(set);
      break;
    case 1:
      film.end = junction(set);
      break;
    case 2:
      film.left = bubble(set);
      break;
    case 3:
      film.right = bubble(set);
      break;
    case 4:
      std::swap(film.left, film.right);
      break;
    case 5:
      std::swap(film.left, any(set.films).left);
      break;
    case 6:
      std::swap(film.start, any(set.films).start);
      break;
    case 7:
      film.wrap.x += 1;
      break;
    case 8:
      film.half_angle = real();
      break;
    case 9:
      any(set.junctions).x = real();
      break;
    case 10:
      any(set.bubbles).id = bubble(set);
      break;
    default:
      set.films.erase(set.films.begin() + pick(set.films.size()));
    }
  }

  std::mt19937 random_;
};

TEST_P(AnyBoundary, DamageIsAnErrorOrAFoam) {
  Vandal vandal(1);
  for (const Index n : {3, 12}) {
    const FilmSet valid = sample(GetParam(), n);
    for (int trial = 0; trial < 3000; ++trial) {
      FilmSet set = valid;
      vandal.damage(set);
      try {
        expect_valid(foam_of(set));
      } catch (const FoamError& error) {
        EXPECT_NE(std::string(error.what()), "");
      }
    }
  }
}

} // namespace
} // namespace foam
