// SPDX-License-Identifier: GPL-3.0-or-later
//
// The films and bubbles of a foam as polylines and polygons, all of them at once on any machine
// (parallel/host.h): each counts its points, sums say where they go, and each fills in its own.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/number.h"
#include "parallel/host.h"
#include "parallel/kernels.h"
#include "sampling/arcs.h"
#include "sampling/polygon.h"
#include "sampling/sampled_foam.h"
#include "statistics/bubble_records.h"

namespace foam {
namespace detail {

struct PresentFilm {
  FoamView mesh;

  FOAM_HOST_DEVICE Index operator()(Index film) const { return mesh.has_film(film) ? film : kNone; }
};

struct PresentJunction {
  FoamView mesh;

  FOAM_HOST_DEVICE Index operator()(Index junction) const {
    return mesh.has_junction(junction) ? junction : kNone;
  }
};

struct TargetArea {
  FoamView mesh;

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? mesh.target_area[bubble] : 0;
  }
};

/// Where the parts of films' polylines go.
struct FilmPlaces {
  const Index* films = nullptr;
  const Index* junctions = nullptr;
  const Index* junction_number = nullptr;
  const Index* film_number = nullptr;
  Index junction_count = 0;
  Index* segments = nullptr; ///< of each film of the mesh
  /// The points that are no junctions, and come after those that are: the inner points, then, of a
  /// film across a period, its end.
  std::int64_t* own_points = nullptr;
  std::int64_t* offsets = nullptr; ///< FilmPolylines::offsets
};

struct CountFilmPoints {
  static constexpr std::size_t kLeastPerThread = 2048;

  FoamView mesh;
  FilmPlaces place;
  double chord_error = 0;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index film = place.films[i];
    const Index segments = film_segments(mesh, 2 * film, chord_error);
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
  FoamView mesh;
  FilmPlaces place;
  PlacePoint put;

  FOAM_HOST_DEVICE void operator()(Index i) const { put(i, mesh.position[place.junctions[i]], i); }
};

struct PlaceFilm {
  static constexpr std::size_t kLeastPerThread = 1024;

  FoamView mesh;
  FilmPlaces place;
  PlacePoint put;
  std::int64_t* connectivity = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index film = place.films[i];
    const Index half = 2 * film;
    const Index start = mesh.start(half);
    const Index end = place.junction_number[mesh.end(half)];
    std::int64_t point = place.junction_count + place.own_points[i];
    std::int64_t* entry = connectivity + place.offsets[i];
    *entry++ = place.junction_number[start];
    for_each_inner_point(mesh, half, mesh.position[start], place.segments[film], [&](Vec2 p) {
      put(point, p, kNone);
      *entry++ = point++;
    });
    if (const Wrap wrap = mesh.film_wrap[film]; wrap != Wrap{}) {
      put(point, mesh.position[mesh.end(half)] + mesh.period(wrap), end);
      *entry = point;
    } else {
      *entry = end;
    }
  }
};

struct MeasureFilm {
  static constexpr std::size_t kLeastPerThread = 2048;

  FoamView mesh;
  const ArcMeasures* arcs = nullptr;
  const Index* films = nullptr;
  const std::int64_t* id = nullptr;
  std::int64_t* left = nullptr;
  std::int64_t* right = nullptr;
  double* curvature = nullptr;
  double* pressure_difference = nullptr;
  double* length = nullptr;
  double* half_angle = nullptr;
  int* on_boundary = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index half = 2 * films[i];
    const Index bubble = mesh.left(half);
    const Index beyond = mesh.right(half);
    left[i] = name(bubble);
    right[i] = name(beyond);
    curvature[i] = arc_curvature(norm(mesh.chord(half)), mesh.half_angle(half));
    pressure_difference[i] = mesh.pressure_of(bubble) - mesh.pressure_of(beyond);
    length[i] = arcs[films[i]].length;
    half_angle[i] = mesh.half_angle(half);
    on_boundary[i] = mesh.on_world(half) ? 1 : 0;
  }

  FOAM_HOST_DEVICE std::int64_t name(Index bubble) const {
    return bubble == kWorld ? -1 : id[bubble];
  }
};

struct CountBubblePoints {
  FoamView mesh;
  const Index* bubbles = nullptr;
  const Index* segments = nullptr;
  std::int64_t* offsets = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    std::int64_t count = 0;
    for_each_half(mesh, bubbles[i], [&](Index h) { count += segments[FoamView::film_of(h)]; });
    offsets[i] = count;
  }
};

struct PlaceBubble {
  static constexpr std::size_t kLeastPerThread = 256;

  FoamView mesh;
  FilmPlaces place;
  const Point3* film_points = nullptr;
  const Index* bubbles = nullptr;
  const std::int64_t* offsets = nullptr;
  Vec2* outline = nullptr; ///< scratch for as many points
  Point3* points = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index bubble = bubbles[i];
    Vec2* vertex = outline + offsets[i];
    Vec2 corner = mesh.position[mesh.start(mesh.bubble_half[bubble])];
    for_each_half(mesh, bubble, [&](Index h) {
      *vertex++ = corner;
      vertex = copy_inner_points(h, corner, vertex);
      corner += mesh.chord(h);
    });
    const Polygon polygon =
        with_best_fan({outline + offsets[i], static_cast<Index>(offsets[i + 1] - offsets[i]), 0});
    const Vec2 shift = into_box(centroid(polygon));
    for (Index k = 0; k < polygon.size; ++k) {
      const Vec2 p = polygon[k] + shift;
      points[offsets[i] + k] = {p.x, p.y, 0};
    }
  }

private:
  /// Those of the film's polyline, in the half-film's direction and from where that starts.
  FOAM_HOST_DEVICE Vec2* copy_inner_points(Index half, Vec2 start, Vec2* to) const {
    const Index film = FoamView::film_of(half);
    const Index count = place.segments[film] - 1;
    const Point3* const inner =
        film_points + place.junction_count + place.own_points[place.film_number[film]];
    const Vec2 film_start = mesh.position[mesh.start(2 * film)];
    const Vec2 shift = start - (half & 1 ? film_start + mesh.chord(2 * film) : film_start);
    for (Index k = 0; k < count; ++k) {
      const Point3& p = inner[half & 1 ? count - 1 - k : k];
      *to++ = shift + Vec2{p[0], p[1]};
    }
    return to;
  }

  /// The translation by whole periods that brings a point into the box.
  FOAM_HOST_DEVICE Vec2 into_box(Vec2 p) const {
    if (mesh.boundary != Boundary::Periodic) {
      return {};
    }
    const Box& box = mesh.box;
    return {-std::floor((p.x - box.xmin) / box.width()) * box.width(),
            -std::floor((p.y - box.ymin) / box.height()) * box.height()};
  }
};

} // namespace detail

template <class Machine> class FoamSampler {
public:
  explicit FoamSampler(Machine& machine)
      : machine_(machine), films_(machine), junctions_(machine), records_(machine) {}

  /// sample() of the foam but for its record.
  SampledFoam sample(const FoamView& mesh, const BubbleNames<Machine>& names, double chord_error) {
    SampledFoam sampled;
    records_.measure(mesh, names);
    const detail::FilmPlaces place =
        place_films(mesh, chord_error > 0 ? chord_error : mean_spacing(mesh) / 200);
    place_bubbles(mesh, place);
    measure_films(mesh, names);
    sampled.energy = records_.energy(mesh);
    sampled.films = fetch_films();
    sampled.bubbles = {fetch(std::move(bubble_points_)), fetch(std::move(bubble_offsets_)),
                       records_.fetch_records()};
    return sampled;
  }

private:
  template <class T> using Array = typename Machine::template Array<T>;

  /// Foam::mean_spacing()
  double mean_spacing(const FoamView& mesh) {
    const double total =
        machine_.reduce(mesh.bubbles, 0.0, detail::TargetArea{mesh}, parallel::Add{});
    return std::sqrt(total / std::max(records_.count(), Index{1}));
  }

  detail::FilmPlaces place_films(const FoamView& mesh, double chord_error) {
    films_.find(mesh.films, detail::PresentFilm{mesh});
    junctions_.find(mesh.junctions, detail::PresentJunction{mesh});
    const Index films = films_.count();
    const auto length = FoamView::size(films);

    segments_.resize(FoamView::size(mesh.films));
    own_points_.resize(length + 1);
    film_offsets_.resize(length + 1);
    const detail::FilmPlaces place{films_.list(),      junctions_.list(),   junctions_.number(),
                                   films_.number(),    junctions_.count(),  segments_.data(),
                                   own_points_.data(), film_offsets_.data()};
    machine_.for_each(films, detail::CountFilmPoints{mesh, place, chord_error});
    const std::int64_t points = junctions_.count() + machine_.sum_up(own_points_.data(), films);
    const std::int64_t entries = machine_.sum_up(film_offsets_.data(), films);

    film_points_.resize(static_cast<std::size_t>(points));
    junction_id_.resize(static_cast<std::size_t>(points));
    connectivity_.resize(static_cast<std::size_t>(entries));
    const detail::PlacePoint put{film_points_.data(), junction_id_.data()};
    machine_.for_each(junctions_.count(), detail::PlaceJunction{mesh, place, put});
    machine_.for_each(films, detail::PlaceFilm{mesh, place, put, connectivity_.data()});
    return place;
  }

  void measure_films(const FoamView& mesh, const BubbleNames<Machine>& names) {
    const auto length = FoamView::size(films_.count());
    left_.resize(length);
    right_.resize(length);
    curvature_.resize(length);
    pressure_difference_.resize(length);
    length_.resize(length);
    half_angle_.resize(length);
    on_boundary_.resize(length);
    machine_.for_each(films_.count(),
                      detail::MeasureFilm{mesh, records_.arcs(), films_.list(), names.id.data(),
                                          left_.data(), right_.data(), curvature_.data(),
                                          pressure_difference_.data(), length_.data(),
                                          half_angle_.data(), on_boundary_.data()});
  }

  FilmPolylines fetch_films() {
    return {fetch(std::move(film_points_)),  fetch(std::move(junction_id_)),
            fetch(std::move(film_offsets_)), fetch(std::move(connectivity_)),
            fetch(std::move(left_)),         fetch(std::move(right_)),
            fetch(std::move(curvature_)),    fetch(std::move(pressure_difference_)),
            fetch(std::move(length_)),       fetch(std::move(half_angle_)),
            fetch(std::move(on_boundary_))};
  }

  void place_bubbles(const FoamView& mesh, const detail::FilmPlaces& place) {
    const Index bubbles = records_.count();
    bubble_offsets_.resize(FoamView::size(bubbles) + 1);
    machine_.for_each(bubbles, detail::CountBubblePoints{mesh, records_.bubbles(), segments_.data(),
                                                         bubble_offsets_.data()});
    const auto points = static_cast<std::size_t>(machine_.sum_up(bubble_offsets_.data(), bubbles));
    outline_.resize(points);
    bubble_points_.resize(points);
    machine_.for_each(bubbles, detail::PlaceBubble{mesh, place, film_points_.data(),
                                                   records_.bubbles(), bubble_offsets_.data(),
                                                   outline_.data(), bubble_points_.data()});
  }

  Machine& machine_;
  parallel::Numbering<Machine> films_, junctions_;
  BubbleRecords<Machine> records_;
  Array<Index> segments_;
  Array<std::int64_t> own_points_, film_offsets_, bubble_offsets_;
  Array<Point3> film_points_, bubble_points_;
  Array<Vec2> outline_;
  Array<std::int64_t> junction_id_, connectivity_, left_, right_;
  Array<double> curvature_, pressure_difference_, length_, half_angle_;
  Array<int> on_boundary_;
};

} // namespace foam
