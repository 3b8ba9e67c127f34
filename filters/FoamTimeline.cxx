// SPDX-License-Identifier: GPL-3.0-or-later
#include "FoamTimeline.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "Message.h"

namespace foam::filters {
namespace {

std::size_t bytes(const FilmSet& films) {
  return films.junctions.size() * sizeof(Vec2) + films.films.size() * sizeof(FilmSet::Film) +
         films.bubbles.size() * sizeof(FilmSet::Bubble);
}

// The values of a structure as a tuple. The decompositions name every member, so that one added
// later cannot be forgotten.

auto values(const FilmSet::Film& film) {
  const auto& [start, end, left, right, half_angle, wrap] = film;
  return std::tie(start, end, left, right, half_angle, wrap);
}

auto values(const FilmSet::Bubble& bubble) {
  const auto& [id, pressure, target_area] = bubble;
  return std::tie(id, pressure, target_area);
}

auto values(const EquilibriumReport& report) {
  const auto& [converged, iterations, max_angle_error, max_area_error, residual] = report;
  return std::tie(converged, iterations, max_angle_error, max_area_error, residual);
}

auto values(const FoamRecord& record) {
  const auto& [boundary, box, surface_tension, time, t1_count, t2_count, t3_count, report] = record;
  return std::tuple_cat(
      std::tie(boundary, box, surface_tension, time, t1_count, t2_count, t3_count), values(report));
}

template <class T> bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return values(x) == values(y); });
}

bool same(const FilmSet& a, const FilmSet& b) {
  return values(static_cast<const FoamRecord&>(a)) == values(static_cast<const FoamRecord&>(b)) &&
         a.junctions == b.junctions && same(a.films, b.films) && same(a.bubbles, b.bubbles);
}

auto values(const JunctionOptions& options) {
  const auto& [sweep, root_search, energy_target, energy_decay, orientation_invariant, damping,
               finite_difference_step, jacobian_tolerance, pressure_tolerance, position_tolerance,
               minimum_scale] = options;
  return std::tie(sweep, root_search, energy_target, energy_decay, orientation_invariant, damping,
                  finite_difference_step, jacobian_tolerance, pressure_tolerance,
                  position_tolerance, minimum_scale);
}

auto values(const EquilibratorOptions& options) {
  const auto& [kind, device, tolerance, maximum_iterations, linear_solver, junction] = options;
  return std::tuple_cat(std::tie(kind, device, tolerance, maximum_iterations, linear_solver),
                        values(junction));
}

auto values(const ThresholdOptions& options) {
  const auto& [relative, t1_length, t2_area, alpha] = options;
  return std::tie(relative, t1_length, t2_area, alpha);
}

auto values(const CoarseningOptions& options) {
  const auto& [time_step, permeability, thresholds, two_sided_bubbles, topological_algorithm,
               equilibrator] = options;
  return std::tuple_cat(std::tie(time_step, permeability, two_sided_bubbles, topological_algorithm),
                        values(thresholds), values(equilibrator));
}

} // namespace

void Keyframes::set_limit(std::size_t bytes) {
  limit_ = bytes;
  thin();
}

void Keyframes::insert(int frame, FilmSet films) {
  const std::size_t size = bytes(films);
  if (kept_.emplace(frame, std::move(films)).second) {
    bytes_ += size;
    thin();
  }
}

std::pair<int, const FilmSet&> Keyframes::at_or_before(int frame) const {
  const auto& [found, films] = *std::prev(kept_.upper_bound(frame));
  return {found, films};
}

void Keyframes::thin() {
  while (bytes_ > limit_ && kept_.size() > 1) {
    bool drop = false;
    std::erase_if(kept_, [&](const auto& keyframe) {
      if (drop) {
        bytes_ -= bytes(keyframe.second);
      }
      return std::exchange(drop, !drop);
    });
  }
}

bool operator==(const FoamTimeline::Settings& a, const FoamTimeline::Settings& b) {
  return a.keyframe_interval == b.keyframe_interval && values(a.coarsening) == values(b.coarsening);
}

FoamTimeline::FoamTimeline(FilmSet start, const Settings& settings)
    : start_(std::move(start)), settings_(settings),
      coarsening_(make_coarsening(settings.coarsening)) {
  if (settings.keyframe_interval < 1) {
    fail("KeyframeInterval must be at least 1, but is ", settings.keyframe_interval);
  }
  keyframes_.insert(0, start_);
  begin_at(0, start_);
}

bool FoamTimeline::is_of(const FilmSet& start, const Settings& settings) const {
  return settings == settings_ && same(start, start_);
}

void FoamTimeline::go_to(int frame, const AbortCheck& aborted, const Reached& reached) {
  if (end_ && frame > *end_) {
    show_end(frame);
    return;
  }
  if (interrupted_ || last_ || frame < frame_ || keyframes_.at_or_before(frame).first > frame_) {
    begin_at_keyframe(frame);
  }
  const int first = frame_;
  while (frame_ < frame) {
    advance(aborted);
    if (end_ && frame > *end_) {
      show_end(frame);
      return;
    }
    reached(frame_ - first, frame - first);
  }
}

void FoamTimeline::begin_at(int frame, const FilmSet& films) {
  coarsening_->restart(foam_of(films));
  last_.reset();
  interrupted_ = false;
  frame_ = frame;
}

void FoamTimeline::begin_at_keyframe(int frame) {
  const auto [keyframe, films] = keyframes_.at_or_before(frame);
  begin_at(keyframe, films);
}

void FoamTimeline::advance(const AbortCheck& aborted) {
  interrupted_ = true;
  if (!coarsening_->advance(aborted)) {
    end_ = frame_;
    end_films_ = film_set(coarsening_->foam());
    interrupted_ = false;
    return;
  }
  const int next = frame_ + 1;
  if (next % settings_.keyframe_interval == 0) {
    FilmSet films = film_set(coarsening_->foam());
    begin_at(next, films);
    keyframes_.insert(next, std::move(films));
  }
  frame_ = next;
  interrupted_ = false;
}

void FoamTimeline::show_end(int frame) {
  const auto times = frame_times(end_films_.time, settings_.coarsening.time_step, frame - *end_);
  last_ = foam_of(end_films_);
  last_->time = times.back();
  frame_ = frame;
}

std::vector<double> frame_times(double start, double time_step, int count) {
  std::vector<double> times{start};
  times.reserve(static_cast<std::size_t>(count) + 1);
  for (int k = 0; k < count; ++k) {
    times.push_back(times.back() + time_step);
  }
  return times;
}

} // namespace foam::filters
