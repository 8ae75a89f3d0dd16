// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/worker.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "certificate/json.h"
#include "cli/files.h"
#include "cli/forked.h"
#include "cli/outcome.h"
#include "prove/prove.h"

// The statement is in memory already when the process branches off; the evidence comes back
// through a pipe, as the text of a certificate, and is read with all the care that a file
// would be. A search asked to end at its deadline tells what it has; one that does not hear is
// killed soon after.

namespace seam::cli {
namespace {

constexpr std::chrono::seconds grace{2};

[[noreturn]] void work(const certificate::Statement& statement, const VerifyOptions& options,
                       Worker::Clock::time_point deadline, int to) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::set_new_handler([] { _exit(no_memory); });
  if (options.memory > 0) limit_memory(options.memory);
  try {
    write_all(to, certificate::write({"",
                                      false,
                                      certificate::Verdict::undecided,
                                      {},
                                      statement,
                                      prove::prove(statement, {options.effort, deadline})}));
  } catch (const std::bad_alloc&) {
    _exit(no_memory);
  } catch (const std::exception& error) {
    write_all(to, error.what());
    _exit(internal);
  }
  _exit(ok);
}

}  // namespace

Worker::Worker(const certificate::Statement& statement, const VerifyOptions& options)
    : statement_(&statement), start_(Clock::now()), is_limited_(options.memory > 0) {
  const double seconds = std::min(options.timeout, 1e9);
  deadline_ = start_ + std::chrono::milliseconds(static_cast<long>(seconds * 1000));
  end_ = deadline_ + grace;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw Failure{io_error, std::string("no pipe can be made: ") + std::strerror(errno) + "\n"};
  process_ = fork();
  if (process_ == 0) work(statement, options, deadline_, ends[1]);
  close(ends[1]);
  pipe_ = ends[0];
  if (process_ < 0)
    throw Failure{io_error,
                  std::string("no process can be started: ") + std::strerror(errno) + "\n"};
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Worker::~Worker() {
  if (pipe_ >= 0) close(pipe_);
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

bool Worker::has_ended_after_reading() {
  char block[1 << 16];
  for (;;) {
    const ssize_t n = read(pipe_, block, sizeof block);
    if (n > 0) text_.append(block, static_cast<std::size_t>(n));
    if (n > 0 && text_.size() > certificate::max_bytes) kill(process_, SIGKILL);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    if (n > 0) continue;
    waitpid(std::exchange(process_, -1), &status_, 0);
    return true;
  }
}

void Worker::give_up() {
  is_late_ = true;
  kill(process_, SIGKILL);
}

Worker::Left Worker::left() const {
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const auto without = [&](const char* reason, const std::string& detail) {
    return Left{no_evidence(*statement_, reason, detail), {}, false, seconds};
  };
  if (is_late_) return without("time", "the time given was over");
  if (text_.size() > certificate::max_bytes)
    return without("memory", "the evidence is too long for a certificate");
  // Where memory is limited, the libraries of numbers end in more ways than one.
  if ((WIFEXITED(status_) && WEXITSTATUS(status_) == no_memory) ||
      (WIFSIGNALED(status_) && is_limited_))
    return without("memory", "there was not enough memory");
  if (WIFSIGNALED(status_) && WTERMSIG(status_) == SIGKILL)
    return without("memory", "the search was ended by the system");
  if (WIFSIGNALED(status_))
    return without("unsupported", "the search broke off with signal " +
                                      std::to_string(WTERMSIG(status_)) +
                                      ": an internal error");
  if (WEXITSTATUS(status_) != 0)
    return without("unsupported", "the search broke off: an internal error: " + text_);
  try {
    certificate::Certificate read = certificate::read(text_);
    if (read.statement == *statement_)
      return {std::move(read.evidence), text_, now < deadline_, seconds};
  } catch (const certificate::FormatError& error) {
    return without("unsupported",
                   std::string("the evidence cannot be written down: ") + error.what());
  }
  return without("unsupported", "the evidence cannot be written down");
}

}  // namespace seam::cli
