// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace seam::cli {

/// From now on SIGINT and SIGTERM end the program, with 128 + the number of the signal, once it
/// has said on standard error what is left. What is in the store stays there.
void end_on_signals();

/// What will be said: so many statements of so many are decided, so many of them in the store.
void set_progress(int done, int all, int kept);

/// While it lives signals wait: nothing is left half done.
class Uninterrupted {
 public:
  Uninterrupted();
  ~Uninterrupted();
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;
};

}  // namespace seam::cli
