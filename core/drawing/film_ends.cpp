// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/film_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/arc.h"

namespace foam {
namespace {

/// An end of a film: where it is and how the film leaves it.
struct Departure {
  std::int64_t junction = -1;
  double direction = 0; ///< of the tangent, rad
  std::size_t end = 0;  ///< 2·film, or 2·film + 1 for its end
};

/// The film as it leaves one of its ends.
DrawnFilm outgoing(const std::vector<DrawnFilm>& films, std::size_t end) {
  const DrawnFilm& film = films[end / 2];
  if (end % 2 == 0) {
    return film;
  }
  return {film.end, film.start, -film.bulge, film.end_junction, film.start_junction};
}

double half_angle(const DrawnFilm& film) {
  return 2 * std::atan(film.bulge);
}

FilmAtJunction at_junction(const DrawnFilm& film) {
  const Vec2 chord = film.end - film.start;
  return {start_tangent(chord, half_angle(film)), arc_curvature(norm(chord), half_angle(film))};
}

/// The departures of all films that have a direction, junction by junction and counter-clockwise.
std::vector<Departure> sorted_departures(const std::vector<DrawnFilm>& films) {
  std::vector<Departure> departures;
  departures.reserve(2 * films.size());
  for (std::size_t end = 0; end < 2 * films.size(); ++end) {
    const DrawnFilm film = outgoing(films, end);
    if (film.start == film.end) {
      continue;
    }
    const Vec2 tangent = at_junction(film).tangent;
    departures.push_back({film.start_junction, std::atan2(tangent.y, tangent.x), end});
  }
  std::sort(departures.begin(), departures.end(), [](const Departure& a, const Departure& b) {
    return a.junction != b.junction     ? a.junction < b.junction
           : a.direction != b.direction ? a.direction < b.direction
                                        : a.end < b.end;
  });
  return departures;
}

} // namespace

std::vector<FilmEnd> film_ends(const std::vector<DrawnFilm>& films, double border_radius) {
  std::vector<FilmEnd> ends(2 * films.size());
  const auto departures = sorted_departures(films);
  for (std::size_t begin = 0, stop = 0; begin < departures.size(); begin = stop) {
    double shortest = std::numeric_limits<double>::infinity();
    for (; stop < departures.size() && departures[stop].junction == departures[begin].junction;
         ++stop) {
      const DrawnFilm& film = films[departures[stop].end / 2];
      shortest = std::min(shortest, arc_length(norm(film.end - film.start), half_angle(film)));
    }
    if (stop - begin < 2) {
      continue;
    }
    constexpr double kReach = 0.45; // of a film, so that the borders at its ends stay apart
    for (std::size_t i = begin; i < stop; ++i) {
      const std::size_t right = departures[i].end;
      const std::size_t left = departures[i + 1 < stop ? i + 1 : begin].end;
      const DrawnFilm first = outgoing(films, right);
      const DrawnFilm second = outgoing(films, left);
      ends[right].left.end = static_cast<std::int64_t>(left);
      ends[left].right.end = static_cast<std::int64_t>(right);
      if (border_radius > 0) {
        const auto side =
            border_side(at_junction(first), at_junction(second), border_radius, kReach * shortest);
        ends[right].left.side = ends[left].right.side = side.value_or(BorderSide{});
      }
    }
  }
  return ends;
}

double border_margin(const FilmEnd& end) {
  double margin = 0;
  for (const Neighbour& neighbour : {end.left, end.right}) {
    margin = std::max(margin, norm(neighbour.side.centre) - neighbour.side.radius);
  }
  return margin;
}

} // namespace foam
