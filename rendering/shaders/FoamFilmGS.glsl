// SPDX-License-Identifier: GPL-3.0-or-later
//VTK::System::Dec
//
// Puts a ribbon around each film that covers all of its pixels. How smooth the ribbon is does not
// matter: the fragment shader knows how far each pixel is from the arc. A ribbon never lies over
// itself, so that no pixel is drawn twice.
layout(lines) in;
layout(triangle_strip, max_vertices = 38) out;

flat in int filmOfVertex[];
flat out int film;

uniform int PrimitiveIDOffset;
uniform mat4 planeToClip;   // from (x, y, 0, 1) in the foam's plane
uniform vec2 viewportSize;  // in pixels
//VTK::CustomUniforms::Dec
//VTK::TCoord::Dec
//VTK::Color::Dec
//VTK::Picking::Dec

//FilmArc::Dec

const int kMostSegments = 16;

// The length in the plane, in any direction, of a pixel at p.
float unitsPerPixel(vec2 p) {
  vec4 clip = planeToClip * vec4(p, 0.0, 1.0);
  vec2 ndc = clip.xy / clip.w;
  vec2 dx = (planeToClip[0].xy - ndc * planeToClip[0].w) / clip.w * 0.5 * viewportSize;
  vec2 dy = (planeToClip[1].xy - ndc * planeToClip[1].w) / clip.w * 0.5 * viewportSize;
  // The smaller singular value of the matrix (dx, dy), which is det/larger.
  float a = dot(dx, dx) + dot(dy, dy);
  float det = abs(dx.x * dy.y - dx.y * dy.x);
  float larger = sqrt(0.5 * (a + sqrt(max(a * a - 4.0 * det * det, 0.0))));
  const float kGrazing = 0.02; // seen more edge-on than that, a film may lose pixels
  return 1.0 / max(det / larger, kGrazing * larger);
}

// Whether a rectangle in the plane, middle ± a ± b, is beyond one side of the view. An edge of the view
// is a plane in clip coordinates, and the nearest corner to it is found by sign.
bool isOutside(vec2 middle, vec2 a, vec2 b) {
  vec4 m = planeToClip * vec4(middle, 0.0, 1.0);
  vec4 da = planeToClip * vec4(a, 0.0, 0.0);
  vec4 db = planeToClip * vec4(b, 0.0, 0.0);
  vec2 edge = 1.0 + 2.0 * (halfWidth + 1.0) / viewportSize;
  vec2 right = m.xy - m.w * edge - abs(da.xy - da.w * edge) - abs(db.xy - db.w * edge);
  vec2 left = -m.xy - m.w * edge - abs(da.xy + da.w * edge) - abs(db.xy + db.w * edge);
  return any(greaterThan(right, vec2(0.0))) || any(greaterThan(left, vec2(0.0)));
}

void vertexAt(vec2 p, float t) {
  film = filmOfVertex[0];
  gl_Position = planeToClip * vec4(p, 0.0, 1.0);
  gl_PrimitiveID = gl_PrimitiveIDIn;
  const int i = 0;
  //VTK::Color::Impl
  //VTK::TCoord::Impl
  //VTK::Picking::Impl
  EmitVertex();
}

void main() {
  Arc arc = filmArc(filmOfVertex[0]);
  if (arc.start == arc.end) {
    return;
  }
  Frame f = frameOf(arc);
  float borders = texelFetch(films, filmOfVertex[0] * filmTexels + 1).y;
  float radius = 1.0 / max(abs(f.curvature), 1e-30);
  float height = 0.5 * f.chord * arc.bulge;
  float reach = abs(arc.bulge) > 1.0 ? radius : 0.5 * f.chord;
  if (isOutside(f.apex + 0.5 * height * f.left, (reach + borders) * f.along,
                (0.5 * abs(height) + borders) * f.left)) {
    return;
  }
  float pixel = max(max(unitsPerPixel(arc.start), unitsPerPixel(arc.end)), unitsPerPixel(f.apex));
  float margin = (halfWidth + 0.6) * pixel + borders;

  // As many segments as keep their chords within a few pixels of the arc.
  float halfAngle = 2.0 * atan(arc.bulge);
  float segments = max(abs(halfAngle) * sqrt(radius / (8.0 * pixel)), abs(halfAngle) / 0.5);
  int n = clamp(int(ceil(segments)), 1, kMostSegments);
  bool tight = radius < 2.0 * margin || (abs(arc.bulge) > 1.0 && f.chord < 4.0 * margin);
  if (tight || abs(height) < 4.0 * pixel || n == 1) {
    float x = reach + margin;
    vec2 low = (min(height, 0.0) - margin) * f.left;
    vec2 high = (max(height, 0.0) + margin) * f.left;
    vertexAt(f.apex - x * f.along + low, 0.0);
    vertexAt(f.apex - x * f.along + high, 0.0);
    vertexAt(f.apex + x * f.along + low, 1.0);
    vertexAt(f.apex + x * f.along + high, 1.0);
    EndPrimitive();
    return;
  }

  // A band around the arc, with half a square more at either end. Its outer border goes around the
  // circle of the radius + margin, its inner one is inside that of the radius − margin.
  float inner = margin;
  float outer = (radius + margin) / cos(halfAngle / float(n)) - radius;
  float outward = -sign(f.curvature);
  for (int i = -1; i <= n + 1; ++i) {
    float t = clamp(float(i) / float(n), 0.0, 1.0);
    float angle = halfAngle * (2.0 * t - 1.0);
    vec2 normal = cos(angle) * f.left - sin(angle) * f.along;
    float halfSine = sin(0.5 * angle);
    vec2 onArc = f.apex + (sin(angle) * f.along + 2.0 * halfSine * halfSine * f.left) / f.curvature;
    float beyond = i < 0 ? -margin : i > n ? margin : 0.0;
    vec2 p = onArc - beyond * leftNormal(normal);
    vertexAt(p + outward * outer * normal, t);
    vertexAt(p - outward * inner * normal, t);
  }
  EndPrimitive();
}
