// SPDX-License-Identifier: GPL-3.0-or-later
#include "FoamTimeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "Message.h"
#include "engines/engines.h"

namespace foam::filters {
namespace {

std::size_t bytes(const FilmSet& films) {
  return films.junctions.size() * sizeof(Vec2) + films.films.size() * sizeof(FilmSet::Film) +
         films.tensions.size() * sizeof(double) + films.bubbles.size() * sizeof(FilmSet::Bubble);
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

FoamTimeline::FoamTimeline(FilmSet start, const Settings& settings)
    : start_(std::move(start)), settings_(settings),
      evolution_(make_evolution(settings.evolution)) {
  if (settings.keyframe_interval < 1) {
    fail("KeyframeInterval must be at least 1, but is ", settings.keyframe_interval);
  }
  keyframes_.insert(0, start_);
  begin_at(0, start_);
}

bool FoamTimeline::is_of(const FilmSet& start, const Settings& settings) const {
  return settings == settings_ && start == start_;
}

void FoamTimeline::go_to(int frame, const AbortCheck& aborted, const Reached& reached) {
  frame = end_ ? std::min(frame, *end_) : frame;
  if (interrupted_ || frame < frame_ || keyframes_.at_or_before(frame).first > frame_) {
    begin_at_keyframe(frame);
  }
  const int first = frame_;
  while (frame_ < frame) {
    if (!advance(aborted)) {
      return;
    }
    reached(frame_ - first, frame - first);
  }
}

void FoamTimeline::begin_at(int frame, const FilmSet& films) {
  evolution_->restart(foam_of(films));
  interrupted_ = false;
  frame_ = frame;
}

void FoamTimeline::begin_at_keyframe(int frame) {
  const auto [keyframe, films] = keyframes_.at_or_before(frame);
  begin_at(keyframe, films);
}

bool FoamTimeline::advance(const AbortCheck& aborted) {
  interrupted_ = true;
  if (!evolution_->advance(aborted)) {
    end_ = frame_;
    why_ = evolution_->record().ended;
    interrupted_ = false;
    return false;
  }
  ++frame_;
  if (static_cast<std::size_t>(frame_) == events_until_.size()) {
    std::ranges::copy(evolution_->events(), std::back_inserter(events_));
    events_until_.push_back(events_.size());
  }
  if (frame_ % settings_.keyframe_interval == 0) {
    FilmSet films = film_set(evolution_->foam());
    films.time = time();
    begin_at(frame_, films);
    keyframes_.insert(frame_, std::move(films));
  }
  interrupted_ = false;
  return true;
}

double FoamTimeline::time() const {
  return frame_time(start_.time, time_step(), frame_);
}

FoamRecord FoamTimeline::record() const {
  FoamRecord record = evolution_->record();
  record.time = time();
  record.ended = frame_ == end_ ? why_ : std::nullopt;
  return record;
}

std::span<const TopologicalEvent> FoamTimeline::events() const {
  return {events_.data(), events_until_[static_cast<std::size_t>(frame_)]};
}

SampledFoam FoamTimeline::sample(double chord_error) const {
  SampledFoam sampled = evolution_->sample(chord_error);
  sampled.record = record();
  return sampled;
}

double frame_time(double start, double time_step, int frame) {
  const double first = std::round(start / time_step);
  return first * time_step == start ? (first + frame) * time_step : start + frame * time_step;
}

std::vector<double> frame_times(double start, double time_step, int count) {
  std::vector<double> times(static_cast<std::size_t>(count) + 1);
  for (int k = 0; k <= count; ++k) {
    times[static_cast<std::size_t>(k)] = frame_time(start, time_step, k);
  }
  return times;
}

} // namespace foam::filters
