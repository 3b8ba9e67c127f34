// SPDX-License-Identifier: GPL-3.0-or-later
#include "optics/thin_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foam {
namespace {

constexpr double kFirstWavelength = 380; // nm
constexpr double kStep = 10;             // nm

/// Relative spectral power of daylight, CIE standard illuminant D65 (ISO 11664-2), every 10 nm.
constexpr std::array<double, 41> kDaylight = {
    49.9755, 54.6482, 82.7549, 91.4860, 93.4318, 86.6823, 104.865, 117.008, 117.812,
    114.861, 115.923, 108.811, 109.354, 107.802, 104.790, 107.689, 104.405, 104.046,
    100.000, 96.3342, 95.7880, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992,
    80.0268, 80.2146, 82.2778, 78.2842, 69.7213, 71.6091, 74.3490, 61.6040, 69.8856,
    75.0870, 63.5927, 46.4182, 66.8054, 63.3828};

/// The daylight at a wavelength (nm), linear between the values of the table.
double daylight(double wavelength) {
  const double place = (wavelength - kFirstWavelength) / kStep;
  const auto i = std::min(static_cast<std::size_t>(place), kDaylight.size() - 2);
  const double t = place - static_cast<double>(i);
  return (1 - t) * kDaylight[i] + t * kDaylight[i + 1];
}

/// The sum over the visible spectrum of daylight, as much of it as `reflectance` says.
template <class Reflectance> Tristimulus sum_of_spectrum(Reflectance reflectance) {
  constexpr int kWavelengths = 401; // every nm: thick films have narrow fringes
  Tristimulus sum;
  for (int i = 0; i < kWavelengths; ++i) {
    const double wavelength = kFirstWavelength + i;
    const double light = daylight(wavelength) * reflectance(wavelength);
    const Tristimulus seen = colour_matching(wavelength);
    sum.x += light * seen.x;
    sum.y += light * seen.y;
    sum.z += light * seen.z;
  }
  return sum;
}

/// A bell with different widths on its two sides.
double lobe(double wavelength, double middle, double rise, double fall) {
  const double t = (wavelength - middle) * (wavelength < middle ? rise : fall);
  return std::exp(-0.5 * t * t);
}

double surface_reflectance(double index) {
  const double amplitude = (index - 1) / (index + 1);
  return amplitude * amplitude;
}

} // namespace

double film_reflectance(double thickness, double wavelength, double index) {
  const double r = surface_reflectance(index);
  const double half_phase = 2 * std::numbers::pi * index * thickness / wavelength;
  const double s = 4 * r * std::sin(half_phase) * std::sin(half_phase);
  return s / ((1 - r) * (1 - r) + s);
}

Tristimulus colour_matching(double wavelength) {
  const auto g = [&](double middle, double rise, double fall) {
    return lobe(wavelength, middle, rise, fall);
  };
  return {0.362 * g(442.0, 0.0624, 0.0374) + 1.056 * g(599.8, 0.0264, 0.0323) -
              0.065 * g(501.1, 0.0490, 0.0382),
          0.821 * g(568.8, 0.0213, 0.0247) + 0.286 * g(530.9, 0.0613, 0.0322),
          1.217 * g(437.0, 0.0845, 0.0278) + 0.681 * g(459.0, 0.0385, 0.0725)};
}

Tristimulus reflected_daylight(double thickness, double index) {
  static const double white = sum_of_spectrum([](double) { return 1.0; }).y;
  const Tristimulus sum = sum_of_spectrum(
      [&](double wavelength) { return film_reflectance(thickness, wavelength, index); });
  return {sum.x / white, sum.y / white, sum.z / white};
}

Colour srgb(const Tristimulus& light) {
  const auto [x, y, z] = light;
  std::array<double, 3> colour = {3.2406 * x - 1.5372 * y - 0.4986 * z,
                                  -0.9689 * x + 1.8758 * y + 0.0415 * z,
                                  0.0557 * x - 0.2040 * y + 1.0570 * z};
  const double grey = std::clamp(y, 0.0, 1.0);
  double saturation = 1;
  for (const double c : colour) {
    const double limit = c > grey ? 1 - grey : -grey;
    if (std::abs(c - grey) > std::abs(limit)) {
      saturation = std::min(saturation, limit / (c - grey));
    }
  }
  for (double& c : colour) {
    const double linear = std::clamp(grey + saturation * (c - grey), 0.0, 1.0);
    c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  }
  return {colour[0], colour[1], colour[2]};
}

Colour film_colour(double thickness, double index) {
  const double r = surface_reflectance(index);
  const double most = 4 * r / ((1 + r) * (1 + r)); // film_reflectance where the sine is 1
  const Tristimulus light = reflected_daylight(thickness, index);
  return srgb({light.x / most, light.y / most, light.z / most});
}

std::vector<Colour> film_colours(double thickest, int count, double index) {
  std::vector<Colour> colours(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    colours[static_cast<std::size_t>(i)] = film_colour(thickest * i / (count - 1), index);
  }
  return colours;
}

} // namespace foam
