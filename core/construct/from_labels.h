// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "construct/division.h"

namespace foam {

/// A picture of numbered bubbles.
struct LabelImage {
  Index width = 0;
  Index height = 0;
  std::vector<std::int64_t> labels; ///< row by row, the lowest first
  Vec2 corner;                      ///< the lowest and leftmost of the picture, cm
  Vec2 pixel{1, 1};                 ///< width and height of a pixel, cm
};

enum class PictureBorder {
  Films,   ///< bubbles there have films along it, unless they are beside the background
  LeftOut, ///< bubbles there are left out, and stand for the world
  Wall,    ///< it is the wall of a container
  Torus    ///< it meets the opposite one
};

struct LabelOptions {
  /// The label of what is outside of the foam, and of lines between its bubbles.
  std::optional<std::int64_t> background = 0;
  PictureBorder border = PictureBorder::Films;
  double surface_tension = 0.25; ///< γ, N/cm, > 0
};

struct LabelFoam : DivisionFoam {
  Index holes = 0;        ///< regions inside of a single bubble, which are taken for a part of it
  Index split_labels = 0; ///< parts of a label that hang together with no other: bubbles of their
                          ///< own
  Index pockets = 0;      ///< of background between bubbles: bubbles as well
  Index left_out = 0;     ///< regions that do not hang together with the foam
};

/// The foam with the neighbours and areas of a picture's regions. A region is what hangs together
/// of a label by the sides of pixels; its bubble has the label as its id, further ones of a label
/// have higher ids than there are labels. Lines of background that are one or two pixels wide are
/// closed first. Films are arcs with the area of the pixels beside them. On a torus on which
/// background goes all round the foam that is free, in one piece wherever the border cuts it.
/// \throws FoamError for labels that are negative, pictures without bubbles, and walls that have
/// background beside them
LabelFoam build_from_labels(const LabelImage& image, const LabelOptions& options);

} // namespace foam
