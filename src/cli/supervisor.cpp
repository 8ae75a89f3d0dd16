// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/supervisor.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <map>
#include <new>

#include "certificate/sha256.h"
#include "cli/files.h"
#include "report/file.h"

// Nothing that computes can be stopped in the middle and the rest be trusted: libraries of
// numbers hold locks and half-made values, and end the process where there is no memory. So the
// process ends, and another takes its place. What both have to know stands in memory that they
// share: which steps are at work, and which of them ended the process. A handler of a signal
// does no more than to write that down and to end. The steps that are left out are known to the
// next process because it branches off from the one that keeps the list.

namespace seam::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// A step at work.
struct Slot {
  std::atomic<bool> is_taken;
  std::atomic<long> end;  // by the clock, in nanoseconds
  char name[64];          // its hash
};

/// What the program leaves when it ends before its time.
struct Shared {
  enum Cause { none, time, memory };
  std::atomic<int> cause, guilty;
  Slot slots[1024];
};

Shared* shared = nullptr;
pid_t own_process =
    0;  // of the program; those that branch off from it have limits of their own
std::map<std::string, claims::Refusal> refused;
thread_local int own_slot = -1;
thread_local bool has_memory_limit = false;
volatile pid_t program_now = 0;
volatile std::sig_atomic_t passed_on = 0;

long now() {
  return std::chrono::nanoseconds(Clock::now().time_since_epoch()).count();
}

[[noreturn]] void give_up(int slot, Shared::Cause cause) {
  shared->guilty = slot;
  shared->cause = cause;
  _exit(internal);
}

// A signal of a step that is over may come late.
void at_end_of_time(int, siginfo_t* info, void*) {
  const Slot& slot = shared->slots[info->si_value.sival_int];
  if (slot.is_taken && now() >= slot.end) give_up(info->si_value.sival_int, Shared::time);
}

// The libraries of numbers end the process where memory is at an end. That is the fault of the
// step if the limit was its own.
void at_abort(int signal) {
  if (has_memory_limit) give_up(own_slot, Shared::memory);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void at_end_of_memory() {
  if (has_memory_limit) give_up(own_slot, Shared::memory);
  throw std::bad_alloc();
}

void pass_on(int signal) {
  const int error = errno;
  passed_on = signal;
  if (program_now > 0) kill(program_now, signal);
  errno = error;
}

// No more than the user's own limit. Whether it is less.
bool limit_memory(rlim_t bytes) {
  static const rlimit users = [] {
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    return limit;
  }();
  const rlimit limit{std::min(bytes, users.rlim_cur), users.rlim_max};
  setrlimit(RLIMIT_AS, &limit);
  return limit.rlim_cur < users.rlim_cur;
}

rlim_t memory_now() {
  char text[32] = {};
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  [[maybe_unused]] const ssize_t n = ::read(file, text, sizeof text - 1);
  ::close(file);
  return std::strtoul(text, nullptr, 10) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

class Step {
 public:
  Step(const std::string& name, const VerifyOptions& options) : memory_(options.memory) {
    while (shared->slots[slot_ = next++ % std::size(shared->slots)].is_taken.exchange(true)) {
    }
    Slot& slot = shared->slots[slot_];
    name.copy(slot.name, sizeof slot.name);
    const std::chrono::duration<double> given(std::min(options.timeout, 1e9));
    const long length = std::chrono::duration_cast<std::chrono::nanoseconds>(given).count();
    slot.end = now() + length;
    own_slot = static_cast<int>(slot_);
    if (memory_ > 0)
      has_memory_limit = limit_memory(memory_now() + (static_cast<rlim_t>(memory_) << 20) *
                                                         static_cast<rlim_t>(++limited));
    sigevent event = {};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    event.sigev_value.sival_int = own_slot;
    if (timer_create(CLOCK_MONOTONIC, &event, &timer_) != 0)
      throw Failure{io_error, std::string("no timer can be set: ") + std::strerror(errno)};
    const itimerspec when{{0, 0}, {length / 1'000'000'000, length % 1'000'000'000 + 1}};
    timer_settime(timer_, 0, &when, nullptr);
  }
  ~Step() {
    timer_delete(timer_);
    has_memory_limit = false;
    if (memory_ > 0 && --limited == 0) limit_memory(RLIM_INFINITY);
    own_slot = -1;
    shared->slots[slot_].is_taken = false;
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

 private:
  static inline std::atomic<std::size_t> next = 0;
  static inline std::atomic<int> limited = 0;
  long memory_;
  std::size_t slot_ = 0;
  timer_t timer_ = {};
};

void handle(int signal, void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

void prepare_program() {
  struct sigaction action = {};
  action.sa_sigaction = at_end_of_time;
  action.sa_flags = SA_RESTART | SA_SIGINFO;
  sigemptyset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
  handle(SIGABRT, at_abort);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is one that cannot be written
  std::set_new_handler(at_end_of_memory);
}

// The step that ended the program, if it is known: the one that says so, or the only one.
int guilty_step() {
  if (shared->cause != Shared::none) return shared->guilty;
  int only = -1;
  for (int i = 0; i < std::ssize(shared->slots); ++i) {
    if (!shared->slots[i].is_taken) continue;
    if (only >= 0) return -1;
    only = i;
  }
  return only;
}

claims::Refusal refusal(int status) {
  if (shared->cause == Shared::time) return {"time", "the time given was over"};
  if (shared->cause == Shared::memory) return {"memory", "there was not enough memory"};
  const int signal = WTERMSIG(status);
  if (signal == SIGKILL) return {"memory", "the system ended it"};
  return {"unsupported",
          "it broke off with signal " + std::to_string(signal) + ": an internal error"};
}

// Whether the program is to start again. What breaks off again and again, without a limit that
// was reached, does so for a reason that is not a step's.
bool leaves_out_one_more(int status) {
  static int left = 20;
  static const int by_others[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT};
  if (shared->cause == Shared::none &&
      (!WIFSIGNALED(status) ||
       std::ranges::find(by_others, WTERMSIG(status)) != std::end(by_others) || left-- == 0))
    return false;
  const int step = guilty_step();
  if (step < 0) return false;
  return refused
      .emplace(std::string(shared->slots[step].name, sizeof shared->slots[step].name),
               refusal(status))
      .second;
}

int end_like(int status) {
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  const int signal = WTERMSIG(status);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  return internal;
}

}  // namespace

int supervised(const std::function<int()>& program) {
  void* const memory =
      mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Failure{io_error, "no memory can be shared\n"};
  shared = new (memory) Shared;
  const pid_t supervisor = getpid();
  sigset_t passed, before;
  sigemptyset(&passed);
  sigaddset(&passed, SIGINT);
  sigaddset(&passed, SIGTERM);
  for (;;) {
    sigprocmask(SIG_BLOCK, &passed, &before);
    const pid_t process = fork();
    if (process < 0)
      throw Failure{io_error,
                    std::string("no process can be started: ") + std::strerror(errno) + "\n"};
    if (process == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (getppid() != supervisor) _exit(internal);
      for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
      own_process = getpid();
      report::write_for(supervisor);
      prepare_program();
      sigprocmask(SIG_SETMASK, &before, nullptr);
      return program();
    }
    program_now = process;
    for (const int signal : {SIGINT, SIGTERM}) handle(signal, pass_on);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    program_now = 0;
    if (!leaves_out_one_more(status)) return end_like(status);
    if (passed_on != 0) return 128 + passed_on;
    shared = new (memory) Shared;
  }
}

claims::Limits limits(const VerifyOptions& options, const std::string& file) {
  return
      [options, file](const std::string& step,
                      const std::function<void()>& action) -> std::optional<claims::Refusal> {
        if (getpid() != own_process) {
          action();
          return std::nullopt;
        }
        const std::string name = certificate::sha256(file + "\n" + step);
        if (const auto known = refused.find(name); known != refused.end()) return known->second;
        const Step at_work(name, options);
        action();
        return std::nullopt;
      };
}

}  // namespace seam::cli
