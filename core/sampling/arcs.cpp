// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/arcs.h"

namespace foam {

void sample_arc(const Foam& foam, Index half, Vec2 start, double chord_error,
                std::vector<Vec2>& points) {
  const Vec2 chord = foam.chord(half);
  const double alpha = foam.half_angle(half);
  const int segments = arc_segments(norm(chord), alpha, chord_error);
  points.push_back(start);
  for (int i = 1; i < segments; ++i) {
    points.push_back(arc_point(start, chord, alpha, static_cast<double>(i) / segments));
  }
  points.push_back(start + chord);
}

std::vector<Vec2> sample_bubble(const Foam& foam, Index bubble, double chord_error) {
  std::vector<Vec2> outline{
      foam.position[Foam::size(foam.start(foam.bubble_half[Foam::size(bubble)]))]};
  for_each_half(foam, bubble, [&](Index h) {
    const Vec2 corner = outline.back();
    outline.pop_back();
    sample_arc(foam, h, corner, chord_error, outline);
  });
  outline.pop_back();
  return outline;
}

} // namespace foam
