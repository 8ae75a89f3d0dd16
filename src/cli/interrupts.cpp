// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/interrupts.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

// A handler may call next to nothing: it writes a line out of numbers that stand ready, and
// ends the program. Workers end with it. While something is done that must not be cut in two,
// in whatever thread, the signal is remembered.

namespace seam::cli {
namespace {

std::atomic<int> done_now = 0, all_now = 0, kept_now = 0;
std::atomic<int> held = 0, waiting = 0;

class Line {
 public:
  Line& operator<<(const char* text) {
    while (*text) put(*text++);
    return *this;
  }
  Line& operator<<(int number) {
    if (number >= 10) *this << number / 10;
    put(static_cast<char>('0' + number % 10));
    return *this;
  }
  void write() const {
    [[maybe_unused]] const ssize_t n = ::write(STDERR_FILENO, text_, size_);
  }

 private:
  void put(char c) {
    if (size_ < sizeof text_) text_[size_++] = c;
  }
  char text_[256];
  std::size_t size_ = 0;
};

[[noreturn]] void end(int signal) {
  const int done = done_now, all = all_now, kept = kept_now;
  Line line;
  line << "\ninterrupted: ";
  if (all > 0) line << all - done << " of " << all << " statements are left; ";
  if (kept > 0)
    line << kept << " are in the store, and the same command goes on from there\n";
  else
    line << "nothing is in the store\n";
  line.write();
  _exit(128 + signal);
}

void end_or_remember(int signal) {
  waiting = signal;
  if (held == 0) end(signal);
}

}  // namespace

void end_on_signals() {
  struct sigaction action = {};
  action.sa_handler = end_or_remember;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void set_progress(int done, int all, int kept) {
  done_now = done;
  all_now = all;
  kept_now = kept;
}

Uninterrupted::Uninterrupted() {
  ++held;
}

Uninterrupted::~Uninterrupted() {
  if (--held == 0 && waiting != 0) end(waiting);
}

}  // namespace seam::cli
