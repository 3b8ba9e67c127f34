// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <thread>

namespace foam {

/// The threads that a request for so many stands for; 0 stands for all that the processor has.
/// Those are counted once: the operating system takes longer to tell than a small foam to be
/// evaluated.
inline int thread_count(int requested) {
  static const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return requested > 0 ? requested : all;
}

} // namespace foam
