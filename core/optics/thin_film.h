// SPDX-License-Identifier: GPL-3.0-or-later
//
// The colours of soap films: white light that is reflected at both surfaces of a thin film
// interferes with itself.
#pragma once

#include <vector>

namespace foam {

struct Colour {
  double red = 0, green = 0, blue = 0; ///< sRGB (IEC 61966-2-1), 0 … 1, for display
};

/// CIE 1931 tristimulus values.
struct Tristimulus {
  double x = 0, y = 0, z = 0;
};

/// The refractive index of water, which a soap solution has to about 0.01.
inline constexpr double kSoapIndex = 1.333;

/// The part of the light of a wavelength (nm) that a film of a thickness (nm) and refractive index
/// in air reflects at normal incidence: Fresnel's reflection at both surfaces, summed over all
/// reflections to and fro (Airy; M. Born and E. Wolf, Principles of Optics, §7.6.1).
double film_reflectance(double thickness, double wavelength, double index);

/// The CIE 1931 colour-matching functions at a wavelength (nm), by the fit of C. Wyman, P.-P. Sloan
/// and P. Shirley, Simple analytic approximations to the CIE XYZ color matching functions, J.
/// Computer Graphics Techniques 2 (2013) no. 2, p. 1.
Tristimulus colour_matching(double wavelength);

/// What a film reflects of daylight (CIE standard illuminant D65), relative to a white of y = 1.
Tristimulus reflected_daylight(double thickness, double index);

/// The colour of tristimulus values. Where it is more saturated than a display can show, it is
/// mixed with grey of the same luminance.
Colour srgb(const Tristimulus& light);

/// The colour of a film in daylight before a black background, so bright that a film that reflects
/// all wavelengths as well as it can would be white.
Colour film_colour(double thickness, double index = kSoapIndex);

/// film_colour at `count` thicknesses (nm) from 0 to `thickest`.
std::vector<Colour> film_colours(double thickest, int count, double index = kSoapIndex);

} // namespace foam
