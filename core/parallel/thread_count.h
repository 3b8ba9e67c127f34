// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sched.h>

#include <algorithm>
#include <thread>

namespace foam {

/// The threads that a request for so many stands for; 0 stands for one on each core that this
/// process may use. Those are counted once: the operating system takes longer to tell than a small
/// foam to be evaluated.
inline int thread_count(int requested) {
  static const int all = [] {
    cpu_set_t cores; // std::thread::hardware_concurrency() counts those of other processes too
    return sched_getaffinity(0, sizeof cores, &cores) == 0
               ? CPU_COUNT(&cores)
               : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  }();
  return requested > 0 ? requested : all;
}

} // namespace foam
