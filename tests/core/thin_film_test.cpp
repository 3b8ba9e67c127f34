// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "optics/thin_film.h"

namespace foam {
namespace {

struct HueSaturationValue {
  double hue, saturation, value; // degrees, 0 … 1, 0 … 1
};

HueSaturationValue hsv(const Colour& c) {
  const double most = std::max({c.red, c.green, c.blue});
  const double range = most - std::min({c.red, c.green, c.blue});
  double hue = 0;
  if (range > 0) {
    hue = most == c.red     ? std::fmod((c.green - c.blue) / range + 6, 6)
          : most == c.green ? (c.blue - c.red) / range + 2
                            : (c.red - c.green) / range + 4;
  }
  return {60 * hue, range / most, most};
}

bool is_called(const HueSaturationValue& c, const std::string& name) {
  const auto between = [&](double low, double high) {
    return low < high ? c.hue >= low && c.hue <= high : c.hue >= low || c.hue <= high;
  };
  if (name == "white") {
    return c.value > 0.9 && c.saturation < 0.1;
  }
  if (name == "ruddy white") {
    return c.saturation < 0.1 && between(300, 30);
  }
  if (name == "yellow") {
    return between(40, 85);
  }
  if (name == "orange") {
    return between(20, 60);
  }
  if (name == "red") {
    return between(320, 45);
  }
  if (name == "scarlet") {
    return between(325, 30);
  }
  if (name == "bluish red") {
    return between(285, 345);
  }
  if (name == "purple") {
    return between(280, 320);
  }
  if (name == "violet") {
    return between(245, 290);
  }
  if (name == "indigo") {
    return between(195, 265);
  }
  if (name == "blue") {
    return between(185, 245);
  }
  if (name == "greenish blue") {
    return between(150, 200);
  }
  if (name == "bluish green") {
    return between(150, 190);
  }
  return name == "green" && between(100, 165);
}

// I. Newton, Opticks, book II part II: the thickness of air, in millionths of an inch, at which
// each colour is "most intense and specifick"; a film of water is three quarters as thick.
TEST(ThinFilm, has_newtons_colours_in_newtons_order) {
  const struct {
    int order;
    const char* name;
    double air;
  } table[] = {{1, "blue", 2 + 2. / 5},
               {1, "white", 5 + 1. / 4},
               {1, "yellow", 7 + 1. / 9},
               {1, "orange", 8},
               {1, "red", 9},
               {2, "violet", 11 + 1. / 6},
               {2, "indigo", 12 + 5. / 6},
               {2, "blue", 14},
               {2, "green", 15 + 1. / 8},
               {2, "yellow", 16 + 2. / 7},
               {2, "orange", 17 + 2. / 9},
               {2, "red", 18 + 1. / 3},
               {2, "scarlet", 19 + 2. / 3},
               {3, "purple", 21},
               {3, "indigo", 22 + 1. / 10},
               {3, "blue", 23 + 2. / 5},
               {3, "green", 25 + 1. / 5},
               {3, "yellow", 27 + 1. / 7},
               {3, "red", 29},
               {3, "bluish red", 32},
               {4, "bluish green", 34},
               {4, "green", 35 + 2. / 7},
               {4, "green", 36},
               {4, "red", 40 + 1. / 3},
               {5, "greenish blue", 46},
               {5, "red", 52 + 1. / 2},
               {6, "greenish blue", 58.75},
               {6, "red", 65},
               {7, "greenish blue", 71},
               {7, "ruddy white", 77}};
  for (const auto& [order, name, air] : table) {
    const double thickness = air * 25.4 * 3 / 4; // nm
    const auto colour = hsv(film_colour(thickness, 4. / 3));
    EXPECT_TRUE(is_called(colour, name))
        << name << " of order " << order << ", " << thickness << " nm, has the hue " << colour.hue
        << ", saturation " << colour.saturation << ", value " << colour.value;
  }
}

TEST(ThinFilm, is_black_when_it_is_thinnest) {
  EXPECT_EQ(film_colour(0).green, 0);
  EXPECT_LT(hsv(film_colour(5)).value, 0.15);
}

// A layer of a quarter of the wavelength between like media reflects ((n² − 1)/(n² + 1))², one of
// half the wavelength nothing (Born and Wolf, §1.6.4).
TEST(ThinFilm, reflects_most_at_a_quarter_of_the_wavelength) {
  for (const double n : {1.2, 1.333, 1.5}) {
    const double wavelength = 550;
    const double most = (n * n - 1) / (n * n + 1);
    EXPECT_NEAR(film_reflectance(wavelength / (4 * n), wavelength, n), most * most, 1e-15);
    EXPECT_NEAR(film_reflectance(3 * wavelength / (4 * n), wavelength, n), most * most, 1e-15);
    EXPECT_NEAR(film_reflectance(wavelength / (2 * n), wavelength, n), 0, 1e-15);
  }
}

// The tables of the CIE: each function sums to 106.857 over the nanometres of the visible spectrum,
// and the second has its maximum, 1, at 555 nm.
TEST(ThinFilm, sees_as_the_standard_observer) {
  Tristimulus sum;
  double greatest = 0, at = 0;
  for (int wavelength = 360; wavelength <= 830; ++wavelength) {
    const auto c = colour_matching(wavelength);
    sum.x += c.x;
    sum.y += c.y;
    sum.z += c.z;
    if (c.y > greatest) {
      greatest = c.y;
      at = wavelength;
    }
  }
  EXPECT_NEAR(sum.x, 106.857, 0.3);
  EXPECT_NEAR(sum.y, 106.857, 0.3);
  EXPECT_NEAR(sum.z, 106.857, 0.3);
  EXPECT_NEAR(greatest, 1, 0.01);
  EXPECT_NEAR(at, 555, 3);
}

// Over many fringes a very thick film reflects all colours alike: it has the chromaticity of
// daylight, x = 0.3127 and y = 0.3290.
TEST(ThinFilm, is_as_white_as_daylight_when_it_is_thick) {
  const auto [x, y, z] = reflected_daylight(30000, kSoapIndex);
  EXPECT_NEAR(x / (x + y + z), 0.3127, 0.002);
  EXPECT_NEAR(y / (x + y + z), 0.3290, 0.002);
}

TEST(ThinFilm, white_is_white) {
  const Colour white = srgb({0.9505, 1, 1.089});
  EXPECT_NEAR(white.red, 1, 1e-3);
  EXPECT_NEAR(white.green, 1, 1e-3);
  EXPECT_NEAR(white.blue, 1, 1e-3);
  const Colour middle = srgb({0.9505 / 5, 0.2, 1.089 / 5});
  EXPECT_NEAR(middle.green, 0.4845, 1e-3); // 1.055·0.2^(1/2.4) − 0.055
}

} // namespace
} // namespace foam
