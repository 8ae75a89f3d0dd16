// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace seam::cli {

/// Says on standard error how far a run has come: on a terminal in a line that is written over;
/// elsewhere with a sign of life every 30 seconds. Nothing where `quiet`.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// From any thread: so many statements of so many are done, and the id of the last.
  void operator()(int done, int all, const std::string& id);

 private:
  void beat(const std::stop_token&);

  bool terminal_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::string text_ = "reading";
  std::jthread heartbeat_;
};

}  // namespace seam::cli
