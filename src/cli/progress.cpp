// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.h"

#include <unistd.h>

#include <chrono>
#include <iostream>

namespace seam::cli {

ProgressLine::ProgressLine(bool quiet) : terminal_(isatty(STDERR_FILENO) != 0 && !quiet) {
  if (!terminal_ && !quiet)
    heartbeat_ = std::jthread([this](const std::stop_token& stop) { beat(stop); });
}

ProgressLine::~ProgressLine() {
  if (terminal_) std::cerr << "\r\x1b[K";
}

void ProgressLine::operator()(int done, int all, const std::string& id) {
  const std::lock_guard lock(mutex_);
  text_ = std::to_string(done) + " of " + std::to_string(all) + "  " + id;
  if (terminal_) std::cerr << "\r\x1b[K" << text_ << std::flush;
}

void ProgressLine::beat(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wake_.wait_for(lock, stop, std::chrono::seconds(30), [] { return false; });
    if (!stop.stop_requested()) std::cerr << "… " << text_ << std::endl;
  }
}

}  // namespace seam::cli
