// SPDX-License-Identifier: GPL-3.0-or-later
//
// The films and bubbles of a foam as polylines and polygons, all of them at once on any executor
// (parallel/host.h): each counts its points, sums say where they go, and each fills in its own.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "parallel/host.h"
#include "parallel/kernels.h"
#include "sampling/arcs.h"
#include "sampling/polygon.h"
#include "sampling/sampled_foam.h"
#include "statistics/bubble_records.h"

namespace foam {
namespace sampling_detail {

using detail::ArcMeasures;

struct PresentFilm {
  ConstFoamView mesh;

  FOAM_HOST_DEVICE Film operator()(Film film) const {
    return mesh.has_film(film) ? film : Film(kNone);
  }
};

struct PresentJunction {
  ConstFoamView mesh;

  FOAM_HOST_DEVICE Junction operator()(Junction junction) const {
    return mesh.has_junction(junction) ? junction : Junction(kNone);
  }
};

struct TargetArea {
  ConstFoamView mesh;

  FOAM_HOST_DEVICE double operator()(Bubble bubble) const {
    return mesh.has_bubble(bubble) ? mesh.target_area[bubble] : 0;
  }
};

/// Where the parts of films' polylines go.
struct FilmPlaces {
  const Film* films = nullptr;
  const Junction* junctions = nullptr;
  ConstFieldView<Junction, Index> junction_number;
  ConstFieldView<Film, Index> film_number;
  Index junction_count = 0;
  FieldView<Film, Index> segments;
  /// The points that are no junctions, and come after those that are: the inner points, then, of a
  /// film across a period, its end.
  std::int64_t* own_points = nullptr;
  std::int64_t* offsets = nullptr; ///< FilmPolylines::offsets
};

struct CountFilmPoints {
  static constexpr std::size_t kLeastPerThread = 2048;

  ConstFoamView mesh;
  FilmPlaces place;
  double chord_error = 0;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Film film = place.films[i];
    const Index segments = film_segments(mesh, film.half(), chord_error);
    place.segments[film] = segments;
    place.offsets[i] = segments + 1;
    place.own_points[i] = segments - 1 + (mesh.film_wrap[film] != Wrap{} ? 1 : 0);
  }
};

struct PlacePoint {
  Point3* points = nullptr;
  std::int64_t* junction_id = nullptr;

  FOAM_HOST_DEVICE void operator()(std::int64_t i, Vec2 p, Index junction) const {
    points[i] = {p.x, p.y, 0};
    junction_id[i] = junction;
  }
};

struct PlaceJunction {
  ConstFoamView mesh;
  FilmPlaces place;
  PlacePoint put;

  FOAM_HOST_DEVICE void operator()(Index i) const { put(i, mesh.position[place.junctions[i]], i); }
};

struct PlaceFilm {
  static constexpr std::size_t kLeastPerThread = 1024;

  ConstFoamView mesh;
  FilmPlaces place;
  PlacePoint put;
  std::int64_t* connectivity = nullptr;
  double chord_error = 0; ///< cm

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Film film = place.films[i];
    const Half half = film.half();
    const Junction start = mesh.start(half);
    const Index end = place.junction_number[mesh.end(half)];
    const Index segments = place.segments[film];
    const std::int64_t first = place.junction_count + place.own_points[i];
    std::int64_t* entry = connectivity + place.offsets[i];
    *entry++ = place.junction_number[start];
    for_each_inner_point(mesh, film, mesh.position[start], segments, chord_error,
                         [&](Index k, Vec2 p) { put(first + k - 1, p, kNone); });
    for (Index k = 1; k < segments; ++k) {
      *entry++ = first + k - 1;
    }
    const std::int64_t point = first + segments - 1;
    if (const Wrap wrap = mesh.film_wrap[film]; wrap != Wrap{}) {
      put(point, mesh.position[mesh.end(half)] + mesh.surroundings.lattice.period(wrap), end);
      *entry = point;
    } else {
      *entry = end;
    }
  }
};

struct MeasureFilm {
  static constexpr std::size_t kLeastPerThread = 2048;

  ConstFoamView mesh;
  ConstFieldView<Film, ArcMeasures> arcs;
  const Film* films = nullptr;
  std::int64_t* left = nullptr;
  std::int64_t* right = nullptr;
  double* curvature = nullptr;
  double* pressure_difference = nullptr;
  double* length = nullptr;
  double* half_angle = nullptr;
  double* tension = nullptr; ///< null where all films have 2γ
  int* on_boundary = nullptr;
  int* kind = nullptr; ///< null without walls

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Film film = films[i];
    const Half half = film.half();
    left[i] = name(mesh.left(half));
    right[i] = name(mesh.right(half));
    curvature[i] = curvature_of(half);
    pressure_difference[i] = mesh.pressure_difference(half);
    length[i] = arcs[film].length;
    half_angle[i] = half_angle_of(half);
    if (tension) {
      tension[i] = mesh.tension(film);
    }
    on_boundary[i] = mesh.on_outside(half) ? 1 : 0;
    if (kind) {
      kind[i] = mesh.wall(half) ? 1 : 0;
    }
  }

  /// Of a stretch of a wall the mean.
  FOAM_HOST_DEVICE double curvature_of(Half half) const {
    if (!mesh.wall(half)) {
      return arc_curvature(norm(mesh.chord(half)), mesh.half_angle(half));
    }
    const WallStretch stretch = mesh.stretch(half);
    return stretch.length > 0 ? stretch.turn / stretch.length : 0;
  }

  /// Of a stretch of a wall if that is one arc, or else 0.
  FOAM_HOST_DEVICE double half_angle_of(Half half) const {
    if (!mesh.wall(half)) {
      return mesh.half_angle(half);
    }
    constexpr double kSame = 1e-9;
    double before = 0;
    bool first = true;
    bool one_arc = true;
    mesh.for_each_wall_part(half, [&](const WallPiece& part, double corner) {
      const double d = norm(part.chord);
      const double own = d > 0 ? arc_curvature(d, part.half_angle) : before;
      one_arc = one_arc && (first || (std::abs(corner) < kSame &&
                                      std::abs(own - before) <= kSame * std::abs(before)));
      before = own;
      first = false;
    });
    return one_arc ? 0.5 * mesh.stretch(half).turn : 0;
  }

  FOAM_HOST_DEVICE std::int64_t name(Bubble bubble) const {
    return bubble.is_outside() ? std::int64_t{bubble.index()} : mesh.bubble_id[bubble];
  }
};

struct CountBubblePoints {
  ConstFoamView mesh;
  const Bubble* bubbles = nullptr;
  ConstFieldView<Film, Index> segments;
  std::int64_t* offsets = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    std::int64_t count = 0;
    for_each_half(mesh, bubbles[i], [&](Half h) { count += segments[h.film()]; });
    offsets[i] = count;
  }
};

struct PlaceBubble {
  static constexpr std::size_t kLeastPerThread = 256;

  ConstFoamView mesh;
  FilmPlaces place;
  const Point3* film_points = nullptr;
  const Bubble* bubbles = nullptr;
  const std::int64_t* offsets = nullptr;
  Vec2* outline = nullptr; ///< scratch for as many points
  Point3* points = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Bubble bubble = bubbles[i];
    Vec2* vertex = outline + offsets[i];
    Vec2 corner = mesh.position[mesh.start(mesh.bubble_half[bubble])];
    for_each_half(mesh, bubble, [&](Half h) {
      *vertex++ = corner;
      vertex = copy_inner_points(h, corner, vertex);
      corner += mesh.chord(h);
    });
    const Polygon polygon =
        with_best_fan({outline + offsets[i], static_cast<Index>(offsets[i + 1] - offsets[i]), 0});
    const Vec2 shift = into_cell(centroid(polygon));
    for (Index k = 0; k < polygon.size; ++k) {
      const Vec2 p = polygon[k] + shift;
      points[offsets[i] + k] = {p.x, p.y, 0};
    }
  }

private:
  /// Those of the film's polyline, in the half-film's direction and from where that starts.
  FOAM_HOST_DEVICE Vec2* copy_inner_points(Half half, Vec2 start, Vec2* to) const {
    const Film film = half.film();
    const Index count = place.segments[film] - 1;
    const Point3* const inner =
        film_points + place.junction_count + place.own_points[place.film_number[film]];
    const Vec2 film_start = mesh.position[mesh.start(film.half())];
    const Vec2 shift =
        start - (half.reversed() ? film_start + mesh.chord(film.half()) : film_start);
    for (Index k = 0; k < count; ++k) {
      const Point3& p = inner[half.reversed() ? count - 1 - k : k];
      *to++ = shift + Vec2{p[0], p[1]};
    }
    return to;
  }

  /// The translation by whole periods that brings a point into the cell.
  FOAM_HOST_DEVICE Vec2 into_cell(Vec2 p) const {
    if (!mesh.surroundings.has_images()) {
      return {};
    }
    const Lattice& lattice = mesh.surroundings.lattice;
    return -lattice.period(lattice.cell_of(p));
  }
};

} // namespace sampling_detail

template <class Executor> class FoamSampler {
public:
  explicit FoamSampler(Executor& executor)
      : executor_(executor), films_(executor), junctions_(executor), records_(executor) {}

  /// sample() of the foam but for its record and its outsides.
  SampledFoam sample(const ConstFoamView& mesh, const BubbleNames<Executor>& names,
                     double chord_error) {
    SampledFoam sampled;
    records_.measure(mesh, names);
    const sampling_detail::FilmPlaces place =
        place_films(mesh, chord_error > 0 ? chord_error : mean_spacing(mesh) / 200);
    place_bubbles(mesh, place);
    measure_films(mesh);
    sampled.energy = records_.energy(mesh);
    sampled.films = fetch_films();
    sampled.bubbles = {fetch(std::move(bubble_points_)), fetch(std::move(bubble_offsets_)),
                       records_.fetch_records()};
    return sampled;
  }

private:
  template <class T> using Array = typename Executor::template Array<T>;

  /// Foam::mean_spacing()
  double mean_spacing(const ConstFoamView& mesh) {
    const double total = executor_.reduce(mesh.bubble_slots(), 0.0,
                                          sampling_detail::TargetArea{mesh}, parallel::Add{});
    return std::sqrt(total / std::max(records_.count(), Index{1}));
  }

  sampling_detail::FilmPlaces place_films(const ConstFoamView& mesh, double chord_error) {
    films_.find(mesh.film_slots(), sampling_detail::PresentFilm{mesh});
    junctions_.find(mesh.junction_slots(), sampling_detail::PresentJunction{mesh});
    const Index films = films_.count();
    const auto length = place_of(films);

    segments_.resize(place_of(mesh.films));
    own_points_.resize(length + 1);
    film_offsets_.resize(length + 1);
    const sampling_detail::FilmPlaces place{films_.list(),
                                            junctions_.list(),
                                            ConstFieldView<Junction, Index>(junctions_.number()),
                                            ConstFieldView<Film, Index>(films_.number()),
                                            junctions_.count(),
                                            FieldView<Film, Index>(segments_.data()),
                                            own_points_.data(),
                                            film_offsets_.data()};
    executor_.for_each(films, sampling_detail::CountFilmPoints{mesh, place, chord_error});
    const std::int64_t points =
        junctions_.count() + executor_.exclusive_scan(own_points_.data(), films);
    const std::int64_t entries = executor_.exclusive_scan(film_offsets_.data(), films);

    film_points_.resize(static_cast<std::size_t>(points));
    junction_id_.resize(static_cast<std::size_t>(points));
    connectivity_.resize(static_cast<std::size_t>(entries));
    const sampling_detail::PlacePoint put{film_points_.data(), junction_id_.data()};
    executor_.for_each(junctions_.count(), sampling_detail::PlaceJunction{mesh, place, put});
    executor_.for_each(
        films, sampling_detail::PlaceFilm{mesh, place, put, connectivity_.data(), chord_error});
    return place;
  }

  void measure_films(const ConstFoamView& mesh) {
    const auto length = place_of(films_.count());
    left_.resize(length);
    right_.resize(length);
    curvature_.resize(length);
    pressure_difference_.resize(length);
    length_.resize(length);
    half_angle_.resize(length);
    tension_.resize(mesh.has_uniform_tension() ? 0 : length);
    on_boundary_.resize(length);
    kind_.resize(mesh.surroundings.has_walls() ? length : 0);
    executor_.for_each(
        films_.count(),
        sampling_detail::MeasureFilm{
            mesh, records_.arcs(), films_.list(), left_.data(), right_.data(), curvature_.data(),
            pressure_difference_.data(), length_.data(), half_angle_.data(),
            mesh.has_uniform_tension() ? nullptr : tension_.data(), on_boundary_.data(),
            mesh.surroundings.has_walls() ? kind_.data() : nullptr});
  }

  FilmPolylines fetch_films() {
    return {fetch(std::move(film_points_)),  fetch(std::move(junction_id_)),
            fetch(std::move(film_offsets_)), fetch(std::move(connectivity_)),
            fetch(std::move(left_)),         fetch(std::move(right_)),
            fetch(std::move(curvature_)),    fetch(std::move(pressure_difference_)),
            fetch(std::move(length_)),       fetch(std::move(half_angle_)),
            fetch(std::move(tension_)),      fetch(std::move(on_boundary_)),
            fetch(std::move(kind_))};
  }

  void place_bubbles(const ConstFoamView& mesh, const sampling_detail::FilmPlaces& place) {
    const Index bubbles = records_.count();
    bubble_offsets_.resize(place_of(bubbles) + 1);
    executor_.for_each(
        bubbles, sampling_detail::CountBubblePoints{mesh, records_.bubbles(),
                                                    ConstFieldView<Film, Index>(segments_.data()),
                                                    bubble_offsets_.data()});
    const auto points =
        static_cast<std::size_t>(executor_.exclusive_scan(bubble_offsets_.data(), bubbles));
    outline_.resize(points);
    bubble_points_.resize(points);
    executor_.for_each(bubbles,
                       sampling_detail::PlaceBubble{mesh, place, film_points_.data(),
                                                    records_.bubbles(), bubble_offsets_.data(),
                                                    outline_.data(), bubble_points_.data()});
  }

  Executor& executor_;
  parallel::Numbering<Executor, Film> films_;
  parallel::Numbering<Executor, Junction> junctions_;
  BubbleRecords<Executor> records_;
  Array<Index> segments_;
  Array<std::int64_t> own_points_, film_offsets_, bubble_offsets_;
  Array<Point3> film_points_, bubble_points_;
  Array<Vec2> outline_;
  Array<std::int64_t> junction_id_, connectivity_, left_, right_;
  Array<double> curvature_, pressure_difference_, length_, half_angle_, tension_;
  Array<int> on_boundary_, kind_;
};

} // namespace foam
