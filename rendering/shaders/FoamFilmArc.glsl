// SPDX-License-Identifier: GPL-3.0-or-later
//
// Films and their arcs in the plane of the foam, for the geometry and the fragment shader. The plane's
// origin is the middle of the view, so that single precision is spent where one looks.

uniform samplerBuffer films; // as FilmBuffer.h lays them out
uniform int filmTexels;      // texels of each film
uniform vec2 viewOrigin;     // the middle of the view, as positions stand in the buffer
uniform float halfWidth;     // of a film, in pixels

struct Arc {
  vec2 start, end;
  float bulge; // tan(half-angle/2), > 0 where the arc bulges to the right
};

Arc filmArc(int film) {
  vec4 ends = texelFetch(films, film * filmTexels);
  float bulge = texelFetch(films, film * filmTexels + 1).x;
  return Arc(ends.xy - viewOrigin, ends.zw - viewOrigin, bulge);
}

Arc reversed(Arc arc) {
  return Arc(arc.end, arc.start, -arc.bulge);
}

vec2 leftNormal(vec2 v) {
  return vec2(-v.y, v.x);
}

// The arc seen from its middle: there its tangent is parallel to the chord, and its half-angle
// leads to either end. All of it is smooth where the arc becomes straight.
struct Frame {
  vec2 apex;
  vec2 along, left; // unit tangent and normal
  float curvature;  // > 0 where the arc turns to the left
  float chord;
  float cosine, sine; // of the half-angle
};

Frame frameOf(Arc arc) {
  vec2 chord = arc.end - arc.start;
  Frame f;
  f.chord = max(length(chord), 1e-30);
  f.along = chord / f.chord;
  f.left = leftNormal(f.along);
  f.apex = 0.5 * (arc.start + arc.end) - 0.5 * f.chord * arc.bulge * f.left;
  float q = 1.0 / (1.0 + arc.bulge * arc.bulge);
  f.cosine = (1.0 - arc.bulge * arc.bulge) * q;
  f.sine = 2.0 * arc.bulge * q;
  f.curvature = 2.0 * f.sine / f.chord;
  return f;
}
