// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engines/evolution_options.h"
#include "evolution/evolution.h"
#include "mesh/film_set.h"

namespace foam::filters {

/// Frames of a foam that are kept to return to, up to a limit of memory.
class Keyframes {
public:
  /// \param bytes above it every other keyframe is dropped, frame 0 never.
  void set_limit(std::size_t bytes);
  void insert(int frame, FilmSet films);
  /// The keyframe at or before a frame. Frame 0 must have been inserted.
  std::pair<int, const FilmSet&> at_or_before(int frame) const;

private:
  void thin();

  std::map<int, FilmSet> kept_;
  std::size_t bytes_ = 0;
  std::size_t limit_ = 0;
};

/// A foam that evolves and can be asked for any frame, in any order. Composes an Evolution.
///
/// Frame 0 is the foam that it begins with. Going forward advances; going back, or forward over a
/// keyframe, starts from that keyframe and replays. At every interval-th frame the evolution
/// begins anew from the list of its films, whether or not that frame is kept: so a frame has the
/// same bits however it is reached, and also when a run begins with the films of such a frame.
class FoamTimeline {
public:
  struct Settings {
    EvolutionOptions evolution;
    int keyframe_interval = 10; ///< frames, ≥ 1
    friend bool operator==(const Settings& a, const Settings& b) = default;
  };
  /// Told of every frame that has been reached, after `done` of `todo` frames.
  using Reached = std::function<void(int done, int todo)>;

  /// \throws FoamError for settings out of range, or films that are not a foam.
  FoamTimeline(FilmSet start, const Settings& settings);

  /// Whether this is the timeline of these films and settings.
  bool is_of(const FilmSet& start, const Settings& settings) const;
  /// Whether these are its settings.
  bool is_of(const Settings& settings) const { return settings == settings_; }

  void limit_memory(std::size_t bytes) { keyframes_.set_limit(bytes); }

  /// Makes a frame the current one, or the last one, if the foam ends before.
  /// \throws Aborted, or what else went wrong; the current frame is then the last that was
  /// complete.
  void go_to(int frame, const AbortCheck& aborted, const Reached& reached);

  /// Frame 0.
  const FilmSet& start() const { return start_; }
  /// Its time, s.
  double start_time() const { return start_.time; }
  /// Δt, s, the automatic one if that is asked for.
  double time_step() const { return evolution_->frame_time(); }
  int frame() const { return frame_; }
  /// What is known about the foam of the current frame as a whole.
  FoamRecord record() const;
  /// What has happened since frame 0, in its order.
  std::span<const TopologicalEvent> events() const;
  /// The foam of the current frame as it is shown (sampling/sampled_foam.h).
  SampledFoam sample(double chord_error) const;
  /// The last frame, once it is known that the foam cannot go on from it. Its record says why.
  std::optional<int> end() const { return end_; }

private:
  double time() const;
  void begin_at(int frame, const FilmSet& films);
  void begin_at_keyframe(int frame);
  /// \returns false if the foam cannot go on.
  bool advance(const AbortCheck& aborted);

  FilmSet start_;
  Settings settings_;
  std::unique_ptr<Evolution> evolution_;
  Keyframes keyframes_;
  int frame_ = 0;
  std::vector<TopologicalEvent> events_;     ///< of all frames that have been reached
  std::vector<std::size_t> events_until_{0}; ///< how many of them, up to each frame
  bool interrupted_ = false; ///< what the evolution keeps between frames may not be as it was
  std::optional<int> end_;
  std::optional<End> why_; ///< the foam cannot go on from there
};

/// The time (s) of a frame, t₀ + k·Δt. Where t₀ is a multiple of Δt it is one as well, so that a
/// run that is resumed has the times of one that was not stopped.
double frame_time(double start, double time_step, int frame);

/// The times (s) of frames 0 … count.
std::vector<double> frame_times(double start, double time_step, int count);

} // namespace foam::filters
