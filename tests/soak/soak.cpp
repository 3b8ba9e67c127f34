// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs frames of small foams at random (tests/random_runs.h) and counts what goes wrong, by kind,
// with the seeds that show it.
#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <iostream>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "../random_runs.h"
#include "base/error.h"
#include "coarsening/end.h"

namespace {

using namespace foam;
using foam::test::RandomRun;

constexpr int kFramesOfARun = 400;
constexpr double kLeast = 5;  // bubbles at the start
constexpr double kMost = 1e6; // that may be asked for
constexpr double kEver = 1e9; // s

constexpr const char* kUsage = R"(usage: soak [--frames N] [--first SEED] [--slow S] [--most N]
       soak --seed SEED [--slow S] [--most N]

  --frames N    so many frames in all, default 100000
  --first SEED  of the first run, default 1; the others follow
  --seed SEED   this run alone, frame by frame
  --slow S      a frame that takes longer is one that goes wrong, s, default 5
  --most N      bubbles at the start, at most, default 300
)";

struct Arguments {
  std::int64_t frames = 100000;
  std::uint64_t first = 1;
  std::uint64_t seed = 0; ///< 0: many
  double slow = 5;        ///< s
  double most = 300;      ///< bubbles
};

/// What was found, by kind.
class Tally {
public:
  void note(const std::string& kind, std::uint64_t seed) {
    const std::scoped_lock lock(mutex_);
    Entry& entry = entries_[kind];
    ++entry.count;
    if (entry.seeds.size() < 5 && (entry.seeds.empty() || entry.seeds.back() != seed)) {
      entry.seeds.push_back(seed);
    }
  }
  void print() const {
    for (const auto& [kind, entry] : entries_) {
      std::cout << "  " << kind << ": " << entry.count << "  (seeds";
      for (const std::uint64_t seed : entry.seeds) {
        std::cout << ' ' << seed;
      }
      std::cout << ")\n";
    }
  }

private:
  struct Entry {
    std::int64_t count = 0;
    std::vector<std::uint64_t> seeds;
  };
  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
};

double gas(const Foam& foam) {
  double total = 0;
  for (const Bubble b : foam.bubble_slots()) {
    total += foam.has_bubble(b) ? foam.target_area[b] : 0;
  }
  return total;
}

std::string kind_of(const Foam& foam) {
  switch (foam.surroundings.boundary) {
  case Boundary::Free:
    return "free";
  case Boundary::Periodic:
    return "torus";
  case Boundary::Fixed:
  case Boundary::Container:
    break;
  }
  return "container";
}

std::string range_of(Index bubbles) {
  return bubbles <= 8 ? std::to_string(bubbles) : bubbles <= 20 ? "9 to 20" : "more than 20";
}

/// One run.
class Run {
public:
  Run(std::uint64_t seed, const Arguments& arguments, Tally& tally, std::atomic<std::int64_t>& done)
      : seed_(seed), run_(seed, kLeast, arguments.most), arguments_(arguments), tally_(tally),
        done_(done) {}

  void go() {
    try {
      Foam foam = run_.start();
      const auto limit = 0.05 * foam.mean_spacing();
      if (!make_equilibrator(run_.options().equilibrator)->equilibrate(foam, limit, {}).converged) {
        note("start without equilibrium");
        return;
      }
      coarsen(std::move(foam));
    } catch (const std::exception& error) {
      note(std::string("exception: ") + error.what());
    }
  }

private:
  void coarsen(Foam start) {
    const double gas_before = gas(start);
    const auto coarsening = make_coarsening(run_.options());
    coarsening->restart(std::move(start));
    for (int frame = 1; frame <= kFramesOfARun; ++frame) {
      const auto begin = std::chrono::steady_clock::now();
      const bool goes_on = coarsening->advance({});
      const double seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      ++done_;
      const Foam& foam = coarsening->foam();
      if (seconds > arguments_.slow) {
        note("frame that took long", foam);
      }
      if (!goes_on) {
        note_end(foam);
        return;
      }
      if (arguments_.seed != 0) {
        std::cout << "frame " << frame << ": " << foam.bubble_count() << " bubbles, residual "
                  << foam.report.residual << ", " << foam.report.iterations << " iterations, "
                  << foam.t1_count << ' ' << foam.t2_count << ' ' << foam.t3_count << ", "
                  << seconds << " s\n";
      }
      check(foam, gas_before);
    }
  }

  void check(const Foam& foam, double gas_before) {
    if (!foam.report.converged) {
      note("not converged", foam);
    }
    if (!(foam.energy() > 0) || !std::isfinite(foam.energy())) {
      note("no finite energy", foam);
    }
    if (!validate(foam).empty()) {
      note("mesh not valid", foam);
    } else if (!validate_geometry(foam).empty()) {
      note("geometry not valid", foam);
    }
    if (outlives_its_end(foam)) {
      note("bubble that outlives the T2 area", foam);
    }
    if (foam.surroundings.closed() && std::abs(gas(foam) / gas_before - 1) > 1e-9) {
      note("gas lost", foam);
    }
  }

  /// Whether a bubble of up to three sides was at its end in the frame before already. One at a
  /// wall on which films are pinned may grow.
  bool outlives_its_end(const Foam& foam) {
    constexpr double kRounding = 1e-9;
    const double t2_area = thresholds(foam, run_.options().thresholds).t2_area;
    const Field<Bubble, double> rates = area_rates(foam, run_.options().permeability);
    const auto shrinks = [&](Bubble b) {
      return -rates[b] * run_.options().time_step > kRounding * foam.target_area[b];
    };
    std::vector<Bubble> at_end;
    for (const Bubble b : foam.bubble_slots()) {
      if (foam.has_bubble(b) && foam.sides[b] <= 3 && foam.target_area[b] < t2_area && shrinks(b)) {
        at_end.push_back(b);
      }
    }
    std::swap(at_end, at_end_);
    return std::ranges::find_first_of(at_end, at_end_) != at_end.end();
  }

  void note_end(const Foam& foam) {
    const End end = foam.ended.value();
    const std::array causes{"last two", "all vanish", "cannot vanish", "no equilibrium"};
    if (arguments_.seed != 0) {
      std::cout << "ended at " << foam.time << " s: " << reason(end) << '\n';
    }
    note(std::string("end, ") + causes[static_cast<std::size_t>(end.cause)], foam);
  }

  void note(const std::string& kind) { tally_.note(kind, seed_); }
  void note(const std::string& kind, const Foam& foam) {
    note(kind + ", " + kind_of(foam) + ", " +
         (run_.options().stepping == Stepping::Events ? "Events" : "FixedSteps") + ", " +
         range_of(foam.bubble_count()) + " bubbles");
  }

  std::uint64_t seed_;
  RandomRun run_;
  std::vector<Bubble> at_end_; ///< in the last frame
  const Arguments& arguments_;
  Tally& tally_;
  std::atomic<std::int64_t>& done_;
};

/// \throws FoamError unless the text is a number from `least` to `most`
double number_of(const std::string& name, std::string_view text, double least, double most) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end) {
    throw FoamError(name + " wants a number, not '" + std::string(text) + "'");
  }
  require(value >= least && value <= most, name, number(least) + " to " + number(most), value);
  return value;
}

template <class Whole> Whole whole_of(const std::string& name, std::string_view text) {
  constexpr double kLargestInteger = 9007199254740992; // that a double tells from the next
  const double value = number_of(name, text, 1, kLargestInteger);
  require(value == std::trunc(value), name, "a whole number", value);
  return static_cast<Whole>(value);
}

/// \throws FoamError naming the first that is none
Arguments arguments_of(std::span<char* const> words) {
  Arguments arguments;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const std::string name = words[i];
    const std::string_view text = i + 1 < words.size() ? words[i + 1] : "";
    if (name == "--frames") {
      arguments.frames = whole_of<std::int64_t>(name, text);
    } else if (name == "--first") {
      arguments.first = whole_of<std::uint64_t>(name, text);
    } else if (name == "--seed") {
      arguments.seed = whole_of<std::uint64_t>(name, text);
    } else if (name == "--slow") {
      arguments.slow = number_of(name, text, 0, kEver);
    } else if (name == "--most") {
      arguments.most = number_of(name, text, kLeast, kMost);
    } else {
      throw FoamError("unknown argument '" + name + "'");
    }
  }
  return arguments;
}

void soak(const Arguments& arguments) {
  Tally tally;
  std::atomic<std::int64_t> done = 0;
  if (arguments.seed != 0) {
    std::cout << RandomRun(arguments.seed, kLeast, arguments.most).text() << '\n';
    Run(arguments.seed, arguments, tally, done).go();
  } else {
    std::atomic<std::uint64_t> next = arguments.first;
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
      threads.emplace_back([&] {
        while (done < arguments.frames) {
          Run(next++, arguments, tally, done).go();
        }
      });
    }
    threads.clear();
    std::cout << next - arguments.first << " runs, ";
  }
  std::cout << done << " frames\n";
  tally.print();
}

} // namespace

int main(int argc, char** argv) {
  const std::span<char* const> words(argv + 1, argv + argc);
  if (std::ranges::find(words, std::string_view("--help")) != words.end()) {
    std::cout << kUsage;
    return 0;
  }
  try {
    soak(arguments_of(words));
  } catch (const FoamError& error) {
    std::cerr << "soak: " << error.what() << "; --help says what there is\n";
    return 2;
  }
}
