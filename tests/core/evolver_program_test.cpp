// SPDX-License-Identifier: GPL-3.0-or-later
// Foams written for Surface Evolver are what Surface Evolver itself finds in the files. Skipped
// where the program is not installed: scripts/install-dependencies installs it.
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "containers.h"
#include "evolver/datafile.h"
#include "evolver/read_foam.h"
#include "evolver/write_foam.h"
#include "foams.h"

namespace foam::test {
namespace {

constexpr const char* kEvolver = FOAM_EVOLVER;

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What Surface Evolver says of a datafile.
struct Answer {
  double energy = 0;                    ///< as loaded
  double relaxed = 0;                   ///< after its own relaxation
  std::map<std::int64_t, double> areas; ///< by BubbleId
  std::string dump;                     ///< as loaded
};

class EvolverProgram : public testing::Test {
protected:
  void SetUp() override {
    if (std::string(kEvolver).empty()) {
      GTEST_SKIP() << "Surface Evolver is not installed: scripts/install-dependencies installs it";
    }
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("foam-evolver-") + info->name() + "-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override {
    if (!folder_.empty()) {
      std::filesystem::remove_all(folder_);
    }
  }

  Answer ask(const std::string& datafile) {
    std::ofstream(folder_ / "foam.fe") << datafile;
    std::ofstream(folder_ / "commands")
        << "quiet on\nprintf \"\\nENERGY %.17g\\n\",total_energy\n"
           "foreach body bb do printf \"AREA %d %.17g\\n\",bb.BubbleId,bb.volume\n"
           "dump \"foam.dmp\"\ng 5; hessian_seek\n"
           "printf \"\\nRELAXED %.17g\\n\",total_energy\nquit\nq\n";
    const std::string command =
        "cd '" + folder_.string() + "' && '" + kEvolver + "' foam.fe < commands > output 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    Answer answer;
    std::istringstream output(content_of(folder_ / "output"));
    bool relaxed = false;
    for (std::string line; std::getline(output, line);) {
      // The prompt may stand before what is printed.
      const auto words_after = [&](const char* key) {
        const auto at = line.find(key);
        return std::istringstream(
            at == std::string::npos ? "" : line.substr(at + std::string(key).size()));
      };
      if (auto energy = words_after("ENERGY "); energy >> answer.energy) {
        continue;
      }
      std::int64_t id = 0;
      if (auto area = words_after("AREA "); area >> id) {
        area >> answer.areas[id];
      }
      if (auto energy = words_after("RELAXED "); energy >> answer.relaxed) {
        relaxed = true;
      }
      EXPECT_EQ(line.find("ERROR"), std::string::npos) << line;
    }
    EXPECT_TRUE(relaxed) << output.str();
    answer.dump = content_of(folder_ / "foam.dmp");
    return answer;
  }

private:
  std::filesystem::path folder_;
};

EvolverFoam read(const std::string& text) {
  return read_evolver(text, [](const std::string& name) -> std::string {
    ADD_FAILURE() << "includes " << name;
    return {};
  });
}

double tension_of(const FilmSet& set, std::size_t film) {
  return set.tensions.empty() ? 2 * set.surface_tension : set.tensions[film];
}

void expect_same(const Foam& a, const Foam& b, double tolerance) {
  const FilmSet x = film_set(a);
  const FilmSet y = film_set(b);
  ASSERT_EQ(x.junctions.size(), y.junctions.size());
  ASSERT_EQ(x.films.size(), y.films.size());
  ASSERT_EQ(x.bubbles.size(), y.bubbles.size());
  for (std::size_t j = 0; j < x.junctions.size(); ++j) {
    EXPECT_LT(norm(x.junctions[j] - y.junctions[j]), tolerance);
  }
  for (std::size_t f = 0; f < x.films.size(); ++f) {
    FilmSet::Film film = y.films[f];
    EXPECT_NEAR(x.films[f].half_angle, film.half_angle, tolerance);
    film.half_angle = x.films[f].half_angle;
    EXPECT_TRUE(x.films[f] == film) << "film " << f;
    if (!a.surroundings.has_walls() || std::min(film.left, film.right) >= 0) { // no wall
      EXPECT_NEAR(tension_of(x, f), tension_of(y, f), tolerance);
    }
  }
  for (std::size_t k = 0; k < x.bubbles.size(); ++k) {
    EXPECT_EQ(x.bubbles[k].id, y.bubbles[k].id);
    EXPECT_NEAR(x.bubbles[k].pressure, y.bubbles[k].pressure, tolerance);
    EXPECT_NEAR(x.bubbles[k].target_area, y.bubbles[k].target_area, tolerance);
  }
  EXPECT_EQ(x.surroundings.has_walls(), y.surroundings.has_walls());
  EXPECT_EQ(x.surroundings.periodic(), y.surroundings.periodic());
  EXPECT_EQ(x.surroundings.wall_symmetry, y.surroundings.wall_symmetry);
  ASSERT_EQ(x.exteriors.size(), y.exteriors.size());
  for (std::size_t o = 0; o < x.exteriors.size(); ++o) {
    EXPECT_EQ(x.exteriors[o], y.exteriors[o]) << "outside " << o;
  }
  ASSERT_EQ(x.wall_pieces.size(), y.wall_pieces.size());
  for (std::size_t p = 0; p < x.wall_pieces.size(); ++p) {
    const Vec2 apart = x.wall_pieces[p].start - y.wall_pieces[p].start;
    const bool line = x.surroundings.wall_symmetry == WallSymmetry::Line; // begins anywhere
    EXPECT_LT(line ? std::abs(apart.y) : norm(apart), tolerance);
    EXPECT_LT(norm(x.wall_pieces[p].chord - y.wall_pieces[p].chord), tolerance);
    EXPECT_NEAR(x.wall_pieces[p].half_angle, y.wall_pieces[p].half_angle, tolerance);
  }
  EXPECT_LT(norm(x.surroundings.lattice.first - y.surroundings.lattice.first), tolerance);
  EXPECT_LT(norm(x.surroundings.lattice.second - y.surroundings.lattice.second), tolerance);
  EXPECT_EQ(x.time, y.time);
}

Foam tilted_foam(Index bubbles, std::uint64_t seed) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  const double side = std::sqrt(static_cast<double>(bubbles));
  options.torus = Lattice{{-0.5, 0.25}, {side, 0.125 * side}, {0.375 * side, 1.046875 * side}};
  options.fold = true;
  return build_from_points(jittered_grid(bubbles, 1, 1, seed), options);
}

TEST_F(EvolverProgram, AgreesOnRandomFoams) {
  double energy_error = 0;
  double area_error = 0;
  double fall = 0;
  for (int i = 0; i < 10; ++i) {
    const auto seed = static_cast<std::uint64_t>(i + 1);
    const auto bubbles = static_cast<Index>(20 + 15 * i);
    Foam foam = i % 3 == 2   ? tilted_foam(bubbles, seed)
                : i % 3 == 1 ? jittered_foam(Boundary::Periodic, bubbles, seed)
                             : jittered_foam(Boundary::Free, bubbles, seed);
    if (i % 2 == 1) {
      pull_unevenly(foam, 0.1, seed);
    }
    foam.time = 0.25 * i;
    for (std::int64_t& id : foam.bubble_id) { // as in a foam that has coarsened
      id = 3 * id + 1;
    }
    equilibrate(foam, 1e-13);
    ASSERT_TRUE(foam.report.converged);
    const std::string text = write_evolver(foam);
    expect_same(read(text).foam, foam, 1e-14 * bubbles);

    const Answer answer = ask(text);
    energy_error = std::max(energy_error, std::abs(answer.energy / foam.energy() - 1));
    ASSERT_EQ(answer.areas.size(), place_of(foam.bubble_count()));
    for (const Bubble b : foam.bubble_slots()) {
      ASSERT_TRUE(answer.areas.contains(foam.bubble_id[b]));
      area_error =
          std::max(area_error, std::abs(answer.areas.at(foam.bubble_id[b]) - foam.area(b)));
    }
    fall = std::max(fall, std::abs(answer.energy - answer.relaxed));
    const EvolverFoam back = read(answer.dump);
    expect_same(back.foam, foam, 1e-12);
    EXPECT_LT(back.largest_misfit, 1e-12);
    expect_valid(back.foam);
  }
  EXPECT_LT(energy_error, 1e-10);
  EXPECT_LT(area_error, 1e-10);
  EXPECT_LT(fall, 1e-9);
  std::cout << "energies differ by " << energy_error << ", areas by " << area_error
            << ", its relaxation by " << fall << '\n';
}

/// A disc with a square in it that is smaller than bubbles, beside the first of the points.
Foam foam_round_a_grain(Index bubbles, std::uint64_t seed) {
  Container container = disc({-1, 1, -1, 1}, WallContact::Slip);
  const std::vector<Vec2> points = points_in(container, bubbles, seed);
  constexpr double kSide = 0.02;
  const Vec2 at = points[0] + Vec2{kSide, kSide};
  const std::vector<Vec2> square = {at, at + Vec2{0, kSide}, at + Vec2{kSide, kSide},
                                    at + Vec2{kSide, 0}};
  Wall& grain = container.walls.emplace_back();
  for (std::size_t i = 0; i < 4; ++i) {
    grain.pieces.push_back({square[i], square[(i + 1) % 4] - square[i], 0});
  }
  return filled(container, points);
}

/// Of each shape of container several foams at random: one whose films slip, one whose films are
/// pinned, one with tensions of its own.
TEST_F(EvolverProgram, AgreesBetweenWalls) {
  double energy_error = 0;
  double area_error = 0;
  double fall = 0;
  int foams = 0;
  int untouched = 0;
  const auto compare = [&](const Foam& foam) {
    ASSERT_TRUE(foam.report.converged);
    const std::string text = write_evolver(foam);
    expect_same(read(text).foam, foam, 1e-13);
    const Answer answer = ask(text);
    energy_error = std::max(energy_error, std::abs(answer.energy / foam.energy() - 1));
    ASSERT_EQ(answer.areas.size(), place_of(foam.bubble_count()));
    for (const Bubble b : foam.bubble_slots()) {
      if (foam.has_bubble(b)) {
        area_error =
            std::max(area_error, std::abs(answer.areas.at(foam.bubble_id[b]) - foam.area(b)));
        untouched += foam.hosts_wall(b) ? 1 : 0;
      }
    }
    fall = std::max(fall, std::abs(answer.energy - answer.relaxed));
    const EvolverFoam back = read(answer.dump);
    expect_same(back.foam, foam, 1e-12);
    expect_valid(back.foam);
    ++foams;
  };
  for (auto [shape, container] : containers()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(shape + " " + std::to_string(seed));
      for (Wall& wall : container.walls) {
        wall.contact = seed == 2 ? WallContact::Pinned : WallContact::Slip;
      }
      Foam foam = random_foam_in(container, static_cast<Index>(8 * seed), seed);
      if (seed == 3) {
        pull_unevenly(foam, 0.1, seed);
        equilibrate(foam, 1e-12);
      }
      compare(foam);
    }
  }
  for (const std::uint64_t seed : {1, 2}) {
    SCOPED_TRACE("grain " + std::to_string(seed));
    compare(foam_round_a_grain(8, seed));
  }
  EXPECT_EQ(untouched, 2);
  EXPECT_LT(energy_error, 1e-10);
  EXPECT_LT(area_error, 1e-10);
  EXPECT_LT(fall, 1e-9);
  std::cout << "of " << foams << " foams energies differ by " << energy_error << ", areas by "
            << area_error << ", its relaxation by " << fall << '\n';
}

TEST_F(EvolverProgram, AgreesOnArcsBeyondASemicircle) {
  Foam foam = double_bubble(1, 0.1);
  equilibrate(foam, 1e-13);
  double widest = 0;
  for (const double alpha : foam.film_angle) {
    widest = std::max(widest, std::abs(alpha));
  }
  EXPECT_GT(widest, 1.7);
  const Answer answer = ask(write_evolver(foam));
  EXPECT_NEAR(answer.energy, foam.energy(), 1e-12);
  EXPECT_NEAR(answer.relaxed, foam.energy(), 1e-10);
}

/// Edges that Evolver has refined are the films that they were.
TEST_F(EvolverProgram, RefinedEdgesAreFilms) {
  const Foam foam = [] {
    Foam made = random_foam(30, Boundary::Periodic);
    equilibrate(made, 1e-13);
    return made;
  }();
  const Answer answer = ask(write_evolver(foam) + "\nrefine edge; refine edge where id % 2 == 0\n");
  EXPECT_EQ(evolver::parse_datafile(answer.dump, {}).edges.size(), 3 * place_of(foam.film_count()));
  const EvolverFoam back = read(answer.dump);
  EXPECT_EQ(back.foam.film_count(), foam.film_count());
  EXPECT_NEAR(back.foam.energy(), foam.energy(), 1e-12 * foam.energy());
  EXPECT_LT(back.largest_misfit, 1e-12);
}

} // namespace
} // namespace foam::test
