// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <iostream>

namespace seam::cli {
namespace {

// Of the terminal, but for the last, where some would go on to the next line.
std::size_t columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return 79;
  return size.ws_col - 1u;
}

// To so many code points.
std::string shortened(const std::string& text, std::size_t most) {
  std::size_t points = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts_point = (static_cast<unsigned char>(text[i]) & 0xC0) != 0x80;
    if (starts_point && ++points > most) return text.substr(0, i);
  }
  return text;
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) : terminal_(isatty(STDERR_FILENO) != 0 && !quiet) {
  if (!terminal_ && !quiet)
    heartbeat_ = std::jthread([this](const std::stop_token& stop) { beat(stop); });
}

ProgressLine::~ProgressLine() {
  if (terminal_) std::cerr << "\r\x1b[K";
}

void ProgressLine::operator()(int done, int all, const std::string& id) {
  const std::lock_guard lock(mutex_);
  text_ = std::to_string(done) + " of " + std::to_string(all) + ", " +
          std::to_string(all - done) + " left  " + id;
  if (terminal_) std::cerr << "\r\x1b[K" << shortened(text_, columns()) << std::flush;
}

void ProgressLine::beat(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wake_.wait_for(lock, stop, std::chrono::seconds(30), [] { return false; });
    if (!stop.stop_requested()) std::cerr << "… " << text_ << std::endl;
  }
}

}  // namespace seam::cli
