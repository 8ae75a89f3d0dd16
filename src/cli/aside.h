// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace seam::cli {

/// What a process of its own left.
struct Aside {
  enum class End {
    done,    ///< `text` is what the work returned
    time,    ///< the time was over
    memory,  ///< the memory was
    failed   ///< it broke off: an internal error
  };
  End end = End::failed;
  std::string text = {};
};

struct AsideLimits {
  int jobs = 1;
  double seconds = 60;
  long memory = 0;  ///< MiB beyond what the program has; 0: any
};

/// Does pieces of work, each in a process of its own, so many at a time: whatever happens to
/// one happens to nothing else. Results are in order; `done` is told how many there are. No
/// thread of oneTBB may have been started. Throws `Failure` (74) where no process can be
/// started.
std::vector<Aside> do_aside(std::size_t count,
                            const std::function<std::string(std::size_t)>& work,
                            const AsideLimits&, const std::function<void(std::size_t)>& done);

}  // namespace seam::cli
