// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/aside.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <list>
#include <new>

#include "cli/files.h"
#include "cli/forked.h"

// Each process ends with the one that started it, so nothing is left when this one is ended.

namespace seam::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Work = std::function<std::string(std::size_t)>;

[[noreturn]] void work_alone(const Work& work, std::size_t i, long memory, int to) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::set_new_handler([] { _exit(no_memory); });
  if (memory > 0) limit_memory(memory);
  try {
    write_all(to, work(i));
  } catch (const std::bad_alloc&) {
    _exit(no_memory);
  } catch (const std::exception& error) {
    write_all(to, error.what());
    _exit(internal);
  }
  _exit(ok);
}

class Running {
 public:
  Running(std::size_t i, const Work& work, const AsideLimits& limits)
      : index(i), is_limited_(limits.memory > 0) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail("no pipe can be made");
    end = Clock::now() + std::chrono::milliseconds(static_cast<long>(limits.seconds * 1000));
    process_ = fork();
    if (process_ == 0) work_alone(work, i, limits.memory, ends[1]);
    close(ends[1]);
    pipe = ends[0];
    if (process_ < 0) fail("no process can be started");
    fcntl(pipe, F_SETFL, O_NONBLOCK);
  }
  ~Running() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    if (pipe >= 0) close(pipe);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  bool has_ended_after_reading() {
    char block[1 << 16];
    for (;;) {
      const ssize_t n = read(pipe, block, sizeof block);
      if (n > 0) text_.append(block, static_cast<std::size_t>(n));
      if (n == 0) return true;
      if (n < 0 && errno != EINTR) return false;
    }
  }

  Aside result() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == ok)
      return {Aside::End::done, std::move(text_)};
    // Where memory is limited, the libraries of numbers end in more ways than one.
    const bool is_short = (WIFEXITED(status) && WEXITSTATUS(status) == no_memory) ||
                          (WIFSIGNALED(status) && (is_limited_ || WTERMSIG(status) == SIGKILL));
    if (is_short) return {Aside::End::memory};
    if (WIFSIGNALED(status)) text_ = "signal " + std::to_string(WTERMSIG(status));
    return {Aside::End::failed, std::move(text_)};
  }

  std::size_t index;
  int pipe = -1;
  Clock::time_point end;

 private:
  [[noreturn]] static void fail(const char* what) {
    throw Failure{io_error, std::string(what) + ": " + std::strerror(errno) + "\n"};
  }

  pid_t process_ = -1;
  bool is_limited_;
  std::string text_;
};

// Until one has something to say, or had its time.
void wait_for(const std::list<Running>& running) {
  std::vector<pollfd> pipes;
  Clock::time_point first = Clock::now() + std::chrono::hours(1);
  for (const Running& one : running) {
    pipes.push_back({one.pipe, POLLIN, 0});
    first = std::min(first, one.end);
  }
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count();
  poll(pipes.data(), pipes.size(), static_cast<int>(std::max<long>(left + 1, 0)));
}

}  // namespace

std::vector<Aside> do_aside(std::size_t count, const Work& work, const AsideLimits& limits,
                            const std::function<void(std::size_t)>& done) {
  std::vector<Aside> results(count);
  std::list<Running> running;
  std::size_t next = 0, finished = 0;
  while (next < count || !running.empty()) {
    for (; next < count && std::ssize(running) < std::max(1, limits.jobs); ++next)
      running.emplace_back(next, work, limits);
    wait_for(running);
    for (auto it = running.begin(); it != running.end();) {
      const bool has_ended = it->has_ended_after_reading();
      if (!has_ended && Clock::now() < it->end) {
        ++it;
        continue;
      }
      results[it->index] = has_ended ? it->result() : Aside{Aside::End::time};
      it = running.erase(it);
      done(++finished);
    }
  }
  return results;
}

}  // namespace seam::cli
