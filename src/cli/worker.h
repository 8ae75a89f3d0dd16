// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>

#include "certificate/evidence.h"
#include "cli/verify.h"

namespace seam::cli {

/// A process of its own that searches for the evidence of one statement. Whatever happens to
/// it, time-out, lack of memory or a crash, happens to nothing else.
class Worker {
 public:
  using Clock = std::chrono::steady_clock;

  /// Starts it. The statement has to live as long as it. Throws `Failure` (74) where no process
  /// can be started.
  Worker(const certificate::Statement&, const VerifyOptions&);
  ~Worker();  ///< ends it
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  int pipe() const { return pipe_; }              ///< readable when there is something to read
  Clock::time_point end() const { return end_; }  ///< when it will be given up

  /// Takes what it has written; whether it has ended.
  bool has_ended_after_reading();

  /// Ends it: it had its time.
  void give_up();

  /// What it left. `text` is the certificate that it wrote, as it wrote it.
  struct Left {
    certificate::Evidence evidence;
    std::string text;
    bool is_repeatable = false;  ///< the next search would find the same
    double seconds = 0;
  };
  Left left() const;

 private:
  const certificate::Statement* statement_;
  Clock::time_point start_, deadline_, end_;
  pid_t process_ = -1;
  int pipe_ = -1;
  int status_ = 0;
  bool is_limited_ = false, is_late_ = false;
  std::string text_;
};

}  // namespace seam::cli
