// SPDX-License-Identifier: GPL-3.0-or-later
// Foams of pictures in which bubbles are numbered.
#include "construct/from_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "foams.h"
#include "geometry/arc.h"
#include "geometry/bounds.h"
#include "reference.h"

namespace foam::test {
namespace {

/// A picture of a foam: label is the id of the bubble in the middle of a pixel, plus 1; 0 outside.
LabelImage picture_of(const Foam& foam, Vec2 corner, Vec2 extent, Index width, Index height) {
  LabelImage image{width, height, {}, corner, {extent.x / width, extent.y / height}};
  image.labels.assign(place_of(width) * place_of(height), 0);
  const bool torus = foam.surroundings.periodic();
  for (const Bubble b : foam.bubble_slots()) {
    std::vector<Vec2> outline;
    Vec2 at = foam.position[foam.start(foam.bubble_half[b])];
    for_each_half(foam, b, [&](Half h) {
      for (int k = 0; k < 100; ++k) {
        outline.push_back(arc_point(at, foam.chord(h), foam.half_angle(h), 0.01 * k));
      }
      at += foam.chord(h);
    });
    const Bounds bounds = bounds_of(outline);
    const auto row_of = [&](double y) {
      return static_cast<Index>(std::floor((y - corner.y) / image.pixel.y - 0.5));
    };
    for (Index row = row_of(bounds.low.y); row <= row_of(bounds.high.y) + 1; ++row) {
      const double y = corner.y + (row + 0.5) * image.pixel.y;
      std::vector<double> crossings;
      for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vec2 p = outline[k];
        const Vec2 q = outline[(k + 1) % outline.size()];
        if ((p.y <= y) != (q.y <= y)) {
          crossings.push_back(p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x));
        }
      }
      std::ranges::sort(crossings);
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const auto first =
            static_cast<Index>(std::ceil((crossings[k] - corner.x) / image.pixel.x - 0.5));
        for (Index x = first; corner.x + (x + 0.5) * image.pixel.x < crossings[k + 1]; ++x) {
          const Index column = torus ? (x % width + width) % width : x;
          const Index line = torus ? (row % height + height) % height : row;
          if (column >= 0 && line >= 0 && column < width && line < height) {
            image.labels[place_of(line) * place_of(width) + place_of(column)] =
                foam.bubble_id[b] + 1;
          }
        }
      }
    }
  }
  return image;
}

/// With the picture's edges at a distance from a free foam.
LabelImage picture_of(const Foam& foam, Index width) {
  const Bounds bounds = bounds_of(foam.position);
  const double margin = foam.mean_spacing();
  const double extent = std::max(bounds.extent().x, bounds.extent().y) + 2 * margin;
  return picture_of(foam, bounds.low - Vec2{margin, margin}, {extent, extent}, width, width);
}

using Pair = std::pair<std::int64_t, std::int64_t>;

/// Who is beside whom, how often; ids less a number, −1 is the outside.
std::map<Pair, int> neighbours(const Foam& foam, std::int64_t less = 0) {
  std::map<Pair, int> pairs;
  const auto id = [&](Bubble b) { return b.is_outside() ? -1 : foam.bubble_id[b] - less; };
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f)) {
      ++pairs[std::minmax({id(foam.left(f.half())), id(foam.right(f.half()))})];
    }
  }
  return pairs;
}

/// Rows from above, a character for a pixel: digits are labels.
LabelImage drawn(const std::vector<std::string>& rows) {
  LabelImage image;
  image.width = static_cast<Index>(rows[0].size());
  image.height = static_cast<Index>(rows.size());
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      image.labels.push_back(c - '0');
    }
  }
  return image;
}

/// Each row and column so many times.
LabelImage enlarged(const LabelImage& image, Index times) {
  LabelImage result{image.width * times, image.height * times, {}, image.corner, image.pixel};
  for (Index y = 0; y < result.height; ++y) {
    for (Index x = 0; x < result.width; ++x) {
      result.labels.push_back(
          image.labels[place_of(y / times) * place_of(image.width) + place_of(x / times)]);
    }
  }
  return result;
}

std::vector<std::int64_t> ids(const Foam& foam) {
  return {foam.bubble_id.begin(), foam.bubble_id.end()};
}

TEST(FromLabels, ReferenceIsTheSameFoam) {
  const Foam reference = foam_of(evolver_foam());
  LabelOptions options;
  options.border = PictureBorder::Torus;
  options.surface_tension = reference.surface_tension;
  const LabelFoam made =
      build_from_labels(picture_of(reference, {0, 0}, {10, 10}, 2000, 2000), options);
  expect_valid(made.foam);
  EXPECT_EQ(neighbours(made.foam, 1), neighbours(reference));
  EXPECT_EQ(
      made.points_of_more_films + made.holes + made.split_labels + made.pockets + made.left_out, 0);
  Foam foam = made.foam;
  double worst = 0;
  for (const Bubble b : foam.bubble_slots()) {
    worst = std::max(worst, std::abs(foam.area(b) / reference.area(b) - 1));
  }
  EXPECT_LT(worst, 0.002);
  EXPECT_NEAR(gas(foam), 100, 1e-9);
  foam.target_area = reference.target_area;
  equilibrate(foam, 1e-12);
  EXPECT_TRUE(foam.report.converged);
  EXPECT_NEAR(foam.energy(), reference.energy(), 1e-9);
  std::cout << "areas are off by up to " << worst << ", films by up to "
            << *std::ranges::max_element(made.misfit) * 200 << " pixels, the relaxed energy by "
            << foam.energy() - reference.energy() << '\n';
}

TEST(FromLabels, CoarsePicturesHaveTheirOwnNeighbours) {
  const Foam reference = foam_of(evolver_foam());
  LabelOptions options;
  options.border = PictureBorder::Torus;
  const LabelFoam made =
      build_from_labels(picture_of(reference, {0, 0}, {10, 10}, 300, 300), options);
  expect_valid(made.foam);
  int wrong = 0;
  auto missing = neighbours(reference);
  for (const auto& [pair, count] : neighbours(made.foam, 1)) {
    wrong += std::max(0, count - missing[pair]);
    missing[pair] -= count;
  }
  std::cout << wrong << " of 300 films are others at 300 x 300 pixels, "
            << made.points_of_more_films << " points of more than three\n";
  EXPECT_LE(wrong, 3 + made.points_of_more_films);
}

TEST(FromLabels, FreeFoamsAreFoundWithAndWithoutLines) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Foam foam = random_foam(40, Boundary::Free, seed);
    LabelImage image = picture_of(foam, 1200);
    const LabelFoam made = build_from_labels(image, {});
    expect_valid(made.foam);
    EXPECT_EQ(neighbours(made.foam, 1), neighbours(foam));
    Foam relaxed = made.foam;
    relaxed.target_area = foam.target_area;
    equilibrate(relaxed, 1e-12);
    EXPECT_NEAR(relaxed.energy(), foam.energy(), 1e-9);

    // Lines of one pixel, as watersheds leave them.
    const LabelImage whole = image;
    for (Index y = 0; y + 1 < image.height; ++y) {
      for (Index x = 0; x + 1 < image.width; ++x) {
        const std::size_t p = place_of(y) * place_of(image.width) + place_of(x);
        const std::int64_t here = whole.labels[p];
        if (here != whole.labels[p + 1] || here != whole.labels[p + place_of(image.width)]) {
          image.labels[p] = 0;
        }
      }
    }
    const LabelFoam lined = build_from_labels(image, {});
    expect_valid(lined.foam);
    EXPECT_EQ(neighbours(lined.foam, 1), neighbours(foam));
    EXPECT_EQ(lined.pockets, 0);
    for (const Bubble b : foam.bubble_slots()) {
      EXPECT_NEAR(lined.foam.area(b), foam.area(b), 0.08 * foam.area(b));
    }
  }
}

TEST(FromLabels, PicturesHaveOriginAndPixels) {
  LabelImage image = enlarged(drawn({"112", "332", "334"}), 8);
  image.corner = {5, -3};
  image.pixel = {0.5, 0.25};
  const Foam foam = build_from_labels(image, {}).foam;
  expect_valid(foam);
  EXPECT_EQ(ids(foam), (std::vector<std::int64_t>{1, 2, 3, 4}));
  for (const auto& [bubble, pixels] : {std::pair{0, 2}, {1, 2}, {2, 4}, {3, 1}}) {
    EXPECT_NEAR(foam.area(Bubble(bubble)), pixels * 64 * 0.125, 0.02);
  }
  const Bounds bounds = bounds_of(foam.position);
  EXPECT_GE(bounds.low.x, 5);
  EXPECT_LE(bounds.high.x, 17);
  EXPECT_GE(bounds.low.y, -3);
  EXPECT_LE(bounds.high.y, 3);
  // The lowest row is the first: 4 lies below 2.
  EXPECT_TRUE(neighbours(foam).contains({2, 4}));
  EXPECT_FALSE(neighbours(foam).contains({1, 4}));
}

TEST(FromLabels, BorderIsWhatIsAskedFor) {
  const LabelImage image = enlarged(drawn({"1122", "1552", "3664", "3344"}), 10);
  LabelOptions options;
  const Foam free = build_from_labels(image, options).foam;
  expect_valid(free);
  EXPECT_EQ(free.bubble_count(), 6);
  EXPECT_EQ(free.surroundings.boundary, Boundary::Free);

  options.border = PictureBorder::Wall;
  Foam walled = build_from_labels(image, options).foam;
  expect_valid(walled);
  EXPECT_EQ(neighbours(walled), neighbours(free));
  EXPECT_EQ(walled.surroundings.boundary, Boundary::Container);
  EXPECT_NEAR(gas(walled), 1600, 1e-6);
  equilibrate(walled);
  expect_equilibrium(walled);

  options.border = PictureBorder::LeftOut;
  const Foam inner = build_from_labels(image, options).foam;
  expect_valid(inner);
  EXPECT_EQ(ids(inner), (std::vector<std::int64_t>{5, 6}));
  EXPECT_EQ(inner.film_count(), 3);

  options.border = PictureBorder::Torus;
  const Foam torus = build_from_labels(image, options).foam;
  expect_valid(torus);
  EXPECT_EQ(torus.bubble_count(), 6);
  EXPECT_NEAR(gas(torus), 1600, 1e-6);
}

/// A foam in a gas on a torus is the same wherever the picture's border cuts it.
TEST(FromLabels, BackgroundRoundAFoamOnATorusIsAGas) {
  const std::vector<std::string> rows = {"00000000", "00112200", "00112200", "00333300",
                                         "00000000"};
  LabelOptions torus;
  torus.border = PictureBorder::Torus;
  const LabelImage image = enlarged(drawn(rows), 4);
  const Foam whole = build_from_labels(image, {}).foam;
  for (const Index right : {0, 13, 20}) {
    for (const Index up : {0, 7, 11}) {
      LabelImage moved = image;
      for (Index y = 0; y < image.height; ++y) {
        for (Index x = 0; x < image.width; ++x) {
          const Index to = (y + up) % image.height * image.width + (x + right) % image.width;
          moved.labels[place_of(to)] = image.labels[place_of(y * image.width + x)];
        }
      }
      const LabelFoam found = build_from_labels(moved, torus);
      expect_valid(found.foam);
      EXPECT_EQ(found.foam.surroundings.boundary, Boundary::Free);
      EXPECT_EQ(neighbours(found.foam), neighbours(whole));
      EXPECT_EQ(ids(found.foam), ids(whole));
      EXPECT_EQ(found.pockets + found.left_out + found.split_labels, 0);
      EXPECT_NEAR(gas(found.foam), gas(whole), 1e-12);
      EXPECT_NEAR(found.foam.energy(), whole.energy(), 1e-12);
    }
  }
}

TEST(FromLabels, WhatIsNoBubbleIsCounted) {
  const auto made = [](const std::vector<std::string>& rows) {
    LabelFoam foam = build_from_labels(enlarged(drawn(rows), 4), {});
    expect_valid(foam.foam);
    return foam;
  };
  const LabelFoam plain = made({"000000", "011220", "011220", "033330", "000000"});
  EXPECT_EQ(ids(plain.foam), (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_EQ(plain.holes + plain.pockets + plain.split_labels + plain.left_out, 0);
  const auto expect_counts = [](const LabelFoam& foam, Index holes, Index pockets, Index split,
                                Index out) {
    EXPECT_EQ(foam.holes, holes);
    EXPECT_EQ(foam.pockets, pockets);
    EXPECT_EQ(foam.split_labels, split);
    EXPECT_EQ(foam.left_out, out);
  };
  // A bubble in a bubble is a part of it, and background between two is one of its own.
  const LabelFoam holed =
      made({"00000000", "01111220", "01411220", "01110220", "01111220", "03333330", "00000000"});
  EXPECT_EQ(ids(holed.foam), (std::vector<std::int64_t>{1, 2, 3, 5}));
  expect_counts(holed, 1, 1, 0, 0);
  const LabelFoam island = made({"0000000", "0111220", "0141220", "0111220", "0333330", "0000000"});
  EXPECT_EQ(ids(island.foam), (std::vector<std::int64_t>{1, 2, 3}));
  expect_counts(island, 1, 0, 0, 0);
  EXPECT_NEAR(island.foam.area(Bubble(0)), 9 * 16, 1);
  // Two parts of a label are two bubbles, of which the larger keeps it.
  const LabelFoam split = made({"000000", "011220", "011220", "033110", "000000"});
  EXPECT_EQ(ids(split.foam), (std::vector<std::int64_t>{1, 2, 3, 4}));
  EXPECT_TRUE(neighbours(split.foam).contains({2, 4}));
  expect_counts(split, 0, 0, 1, 0);
  // Another foam beside it is left out.
  const LabelFoam apart = made({"000000000", "011220550", "011220660", "033330000", "000000000"});
  EXPECT_EQ(ids(apart.foam), (std::vector<std::int64_t>{1, 2, 3}));
  expect_counts(apart, 0, 0, 0, 2);
}

TEST(FromLabels, FourInAPointAreTwoJunctions) {
  const LabelFoam made = build_from_labels(enlarged(drawn({"12", "34"}), 6), {});
  expect_valid(made.foam);
  EXPECT_EQ(made.points_of_more_films, 1);
  EXPECT_EQ(made.foam.film_count(), 9);
  // Of two that are one bubble the other two come between.
  const LabelFoam same =
      build_from_labels(enlarged(drawn({"1114", "1214", "1131", "1111"}), 6), {});
  expect_valid(same.foam);
  EXPECT_TRUE(neighbours(same.foam).contains({2, 4}) || neighbours(same.foam).contains({2, 3}));
}

TEST(FromLabels, ErrorsNameTheCause) {
  const auto error_of = [](const LabelImage& image,
                           const LabelOptions& options = {}) -> std::string {
    try {
      build_from_labels(image, options);
    } catch (const FoamError& error) {
      return error.what();
    }
    return "no error";
  };
  LabelImage image = enlarged(drawn({"000", "010", "000"}), 4);
  EXPECT_NE(error_of(image), "no error"); // a single bubble has no junction
  EXPECT_EQ(error_of(drawn({"00", "00"})), "the picture shows no bubbles");
  EXPECT_EQ(error_of({}), "a picture of 0 x 0 pixels cannot have 0 labels");
  image.labels[3] = -7;
  EXPECT_EQ(error_of(image), "labels must not be negative, but one is -7");
  image.pixel.x = 0;
  EXPECT_EQ(error_of(image), "the width of a pixel must be positive, but is 0");
  LabelOptions wall;
  wall.border = PictureBorder::Wall;
  EXPECT_EQ(error_of(enlarged(drawn({"120", "122"}), 4), wall),
            "the picture's border cannot be a wall: there is background beside it");
}

/// Whatever a picture shows, it is an error that is told or a foam that is one.
TEST(FromLabels, NoiseIsAnErrorOrAFoam) {
  Random random(1);
  int foams = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    LabelImage image;
    image.width = 2 + static_cast<Index>(10 * random.uniform());
    image.height = 2 + static_cast<Index>(10 * random.uniform());
    const double kinds = 2 + 6 * random.uniform();
    for (Index p = 0; p < image.width * image.height; ++p) {
      image.labels.push_back(static_cast<std::int64_t>(kinds * random.uniform()));
    }
    LabelOptions options;
    options.border = static_cast<PictureBorder>(trial % 4);
    if (trial % 3 == 0) {
      options.background.reset();
    }
    const Index times = 1 + trial % 5;
    try {
      const LabelFoam made = build_from_labels(enlarged(image, times), options);
      EXPECT_TRUE(validate(made.foam).empty());
      ++foams;
    } catch (const FoamError& error) {
      EXPECT_NE(std::string(error.what()), "");
    }
  }
  std::cout << foams << " of 3000 pictures of noise are foams\n";
  EXPECT_GT(foams, 1000);
}

} // namespace
} // namespace foam::test
