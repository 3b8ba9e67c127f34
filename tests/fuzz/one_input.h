// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a reader does with any bytes: it makes a foam that is one, or tells an error. Anything else
// ends the program.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include "base/error.h"
#include "construct/from_labels.h"
#include "evolver/read_foam.h"
#include "evolver/write_foam.h"
#include "mesh/validate.h"

namespace foam::test {

/// \returns whether it made a foam
template <class Make> bool makes_foam_or_tells(const Make& make) {
  try {
    const Foam foam = make();
    for (const std::string& problem : validate(foam)) {
      std::fprintf(stderr, "%s\n", problem.c_str());
      std::abort();
    }
    write_evolver(foam);
    return true;
  } catch (const FoamError& error) {
    if (error.what()[0] == '\0') {
      std::abort();
    }
    return false;
  }
}

/// A file of Surface Evolver's, which may include itself.
inline bool read_datafile(const std::string& text) {
  return makes_foam_or_tells(
      [&] { return read_evolver(text, [&](const std::string&) { return text; }).foam; });
}

/// A picture: two bytes say how wide it is, what its background and its border, and the others are
/// labels.
inline bool read_labels(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 3) {
    return false;
  }
  LabelImage image;
  image.width = 1 + bytes[0] % 64;
  image.height = static_cast<Index>((bytes.size() - 2) / static_cast<std::size_t>(image.width));
  image.labels.assign(bytes.begin() + 2,
                      bytes.begin() + 2 + static_cast<std::ptrdiff_t>(image.width) * image.height);
  LabelOptions options;
  options.border = static_cast<PictureBorder>(bytes[1] % 4);
  if (bytes[1] & 4) {
    options.background.reset();
  }
  return makes_foam_or_tells([&] { return build_from_labels(image, options).foam; });
}

} // namespace foam::test
