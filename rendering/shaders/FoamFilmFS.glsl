// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much of a pixel a film covers, from the distance to its arc.
flat in int film;

uniform mat3 pixelToPlane; // from (x, y, 1) of a pixel to the foam's plane, homogeneous

//FilmStyle::Dec
#define PLAIN 0
#define INK 1
#define TEXTURE 2
#if FILM_STYLE == TEXTURE
uniform sampler2D filmTexture;
#endif

//FilmArc::Dec

// The plane around this pixel, to first order.
vec2 here;      // its place
mat2 pixelStep; // change of place per pixel
mat2 toPixels;  // the inverse

void lookAtPixel() {
  vec3 h = pixelToPlane * vec3(gl_FragCoord.xy, 1.0);
  here = h.xy / h.z;
  pixelStep = mat2(pixelToPlane[0].xy - here * pixelToPlane[0].z,
                   pixelToPlane[1].xy - here * pixelToPlane[1].z) / h.z;
  toPixels = inverse(pixelStep);
}

float pixelLength(vec2 v) {
  return length(toPixels * v);
}

// Whether this pixel is across from some place on the arc, rather than from an end.
bool isAcross(Arc arc, Frame f) {
  bool afterStart = dot(here - arc.start, f.cosine * f.along - f.sine * f.left) >= 0.0;
  bool beforeEnd = dot(here - arc.end, f.cosine * f.along + f.sine * f.left) <= 0.0;
  return abs(arc.bulge) <= 1.0 ? afterStart && beforeEnd : afterStart || beforeEnd;
}

// Distance from the arc, in pixels. With r from the arc's middle and its curvature k, the function
// g = r.left − k·r²/2 vanishes on the circle; the distance is 2g/(1 + |∇g|), also for k = 0.
float distanceTo(Arc arc) {
  Frame f = frameOf(arc);
  if (!isAcross(arc, f)) {
    return min(pixelLength(here - arc.start), pixelLength(here - arc.end));
  }
  vec2 r = here - f.apex;
  float g = dot(r, f.left) - 0.5 * f.curvature * dot(r, r);
  vec2 gradient = f.left - f.curvature * r;
  float slope = length(gradient);
  return 2.0 * abs(g) / (1.0 + slope) * slope / max(length(gradient * pixelStep), 1e-30);
}

// The film that leaves a junction by an end: 2·film for the start of a film, 2·film + 1 for its end.
Arc departure(int end) {
  Arc arc = filmArc(end / 2);
  return end % 2 == 0 ? arc : reversed(arc);
}

// The signed distance to the side of a Plateau border in pixels, < 0 in the liquid; far away where
// the film itself is nearer than the side. The film leaves the border's junction.
float distanceToBorder(Arc film, vec3 side) {
  const float kFar = 1e30;
  if (side.z <= 0.0) {
    return kFar;
  }
  Frame f = frameOf(film);
  vec2 r = here - f.apex;
  vec2 c = side.xy - f.apex;
  float leftOfFilm = dot(r, f.left) - 0.5 * f.curvature * dot(r, r);
  float centreLeft = dot(c, f.left) - 0.5 * f.curvature * dot(c, c);
  // The side touches the film where the line from the film's centre through the side's crosses it.
  vec2 normal = f.left - f.curvature * c;
  bool beforeTouching = dot(here - side.xy, -leftNormal(normal)) < 0.0;
  bool afterStart = dot(here - film.start, f.cosine * f.along - f.sine * f.left) >= 0.0;
  if (leftOfFilm * centreLeft <= 0.0 || !beforeTouching || !afterStart) {
    return kFar;
  }
  vec2 fromSide = here - side.xy;
  float fromCentre = max(length(fromSide), 1e-30);
  return (side.z - fromCentre) / length((fromSide / fromCentre) * pixelStep);
}

// The part of a pixel that a line of the given half-width covers at this distance.
float lineCoverage(float distance, float halfWidthHere) {
  return max(0.0, min(halfWidthHere, distance + 0.5) - max(-halfWidthHere, distance - 0.5));
}

// Where this pixel is on a film, in pixels: along it from its middle, and to the left of it.
vec2 placeOn(Frame f) {
  vec2 r = here - f.apex;
  float x = dot(r, f.along);
  float y = dot(r, f.left);
  float ahead = 1.0 - f.curvature * y;
  bool straight = abs(f.curvature) * f.chord < 1e-3;
  float along = straight ? x / ahead : atan(f.curvature * x, ahead) / f.curvature;
  float across = (2.0 * y - f.curvature * dot(r, r)) / (1.0 + length(f.left - f.curvature * r));
  return vec2(along, across) / sqrt(abs(determinant(pixelStep)));
}

float hash(float n) {
  return fract(sin(n) * 43758.5453);
}

// Smooth noise between 0 and 1 along a line, another one for each seed.
float noise(float x, float seed) {
  float i = floor(x);
  return mix(hash(i + seed), hash(i + 1.0 + seed), smoothstep(0.0, 1.0, x - i));
}

// A stroke of a pen: thin where it begins and ends, its pressure never quite even, its edges a little
// rough. At the ends it is as thin for every film, so that strokes meet.
float inkHalfWidth(Frame f, vec2 place) {
  float halfLength = max(0.5 * pixelLength(f.chord * f.along), 1e-3);
  float t = clamp(abs(place.x) / halfLength, 0.0, 1.0);
  float seed = 17.0 * float(film);
  float pressure = 0.75 + 0.5 * noise(place.x / 25.0, seed);
  float rough = noise(place.x / 2.5, seed + 5.0 * sign(place.y)) - 0.5;
  return halfWidth * mix(pressure + 0.2 * rough, 0.35, smoothstep(0.2, 1.0, t));
}

#if FILM_STYLE == TEXTURE
// The texture's colour; its height is the film's width, and its own proportions are kept.
vec4 textureColour(vec2 place) {
  vec2 size = vec2(textureSize(filmTexture, 0));
  float width = 2.0 * max(halfWidth, 0.5);
  float margin = 0.5 / size.y;
  vec2 uv = vec2(place.x / width * size.y / size.x, clamp(place.y / width + 0.5, margin, 1.0 - margin));
  return textureLod(filmTexture, uv, log2(max(size.y / width, 1.0)));
}
#endif

// What this film covers of the pixel, and in paint what its style does to its colour.
float filmCoverage(out vec4 paint) {
  paint = vec4(1.0);
  lookAtPixel();
  Arc arc = filmArc(film);
  float distance = distanceTo(arc);
  bool wet = filmTexels > 3;
  if (!wet && distance > halfWidth + 0.5) {
    return 0.0;
  }

  float halfWidthHere = halfWidth;
#if FILM_STYLE == INK
  Frame f = frameOf(arc);
  halfWidthHere = inkHalfWidth(f, placeOn(f));
#elif FILM_STYLE == TEXTURE
  paint = textureColour(placeOn(frameOf(arc)));
#endif
  float line = lineCoverage(distance, halfWidthHere);

  float liquid = 0.0;
  vec4 neighbours = texelFetch(films, film * filmTexels + 2);
  float ownDistance;
  for (int i = 0; i < 4; ++i) {
    // The neighbours left and right of the start, then of the end.
    int own = 2 * film + i / 2;
    int other = int(neighbours[i]);
    if (other < 0) {
      continue;
    }
    // All films of a junction see it from there, so that they agree to the last bit who is nearest.
    Arc leaving = i < 2 ? arc : reversed(arc);
    if (i % 2 == 0) {
      ownDistance = distanceTo(leaving);
    }
    Arc beside = departure(other);
    if (beside.start != leaving.start) {
      continue; // in a periodic foam, it is drawn a period away
    }
    float otherDistance = distanceTo(beside);
    if (otherDistance < ownDistance || (otherDistance == ownDistance && other < own)) {
      return 0.0;
    }
    if (wet) {
      vec3 side = texelFetch(films, film * filmTexels + 3 + i).xyz;
      side.xy -= viewOrigin;
      liquid = max(liquid, clamp(halfWidthHere + 0.5 - distanceToBorder(leaving, side), 0.0, 1.0));
    }
  }
  return max(line, liquid);
}
