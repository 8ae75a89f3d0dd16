// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/decide.h"

#include <poll.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <list>
#include <mutex>
#include <optional>

#include "certificate/json.h"
#include "cli/interrupts.h"
#include "cli/store.h"
#include "cli/supervisor.h"
#include "cli/worker.h"

// First what the store has, then a worker for each statement that is left, as many at a time as
// there are jobs. Only this process judges, and it judges all evidence in the same way. What
// the store has and the checker objects to is searched for anew, so that nobody can raise an
// alarm by a file. Results go to places fixed beforehand, so the order does not show.

namespace seam::cli {
namespace {

using certificate::Evidence;
using Clock = Worker::Clock;

/// A search at work.
struct Running {
  Running(std::size_t i, const certificate::Statement& statement, const VerifyOptions& options)
      : question(i), worker(statement, options) {}
  std::size_t question;
  Worker worker;
};

class Decisions {
 public:
  Decisions(const std::vector<Question>& questions, const VerifyOptions& options,
            const NormalForm& normal_form, const Progress& progress)
      : questions_(questions),
        options_(options),
        normal_form_(normal_form),
        progress_(progress),
        limits_(limits(options, {})),
        store_(options.store, options.effort),
        answers_(questions.size()),
        evidence_(questions.size()) {}

  std::vector<Decided> all() {
    std::vector<std::size_t> indices(questions_.size());
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
    judge(indices, [&](std::size_t i) { return take_from_store(i); });
    std::vector<std::size_t> open;
    for (const std::size_t i : indices)
      if (!answers_[i]) open.push_back(i);
    search(open);
    judge(open, [](std::size_t) { return true; });
    std::vector<Decided> result;
    for (auto& answer : answers_) result.push_back(std::move(*answer));
    return result;
  }

 private:
  const certificate::Statement& statement(std::size_t i) const {
    return questions_[i].lowered->exported->statement;
  }

  // The name of judging it.
  std::string step(std::size_t i, Decided::Origin origin) const {
    if (!questions_[i].lowered->exported) return "nothing to judge";
    return (origin == Decided::Origin::stored ? "judging stored evidence of "
                                              : "judging evidence of ") +
           certificate::digest(statement(i));
  }

  bool take_from_store(std::size_t i) {
    if (!questions_[i].lowered->exported) return true;
    auto found = store_.find(statement(i));
    if (!found) return false;
    evidence_[i] = {std::move(*found), Decided::Origin::stored, 0};
    return true;
  }

  // Those of which there is evidence, or none is needed.
  void judge(const std::vector<std::size_t>& indices,
             const std::function<bool(std::size_t)>& is_ready) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    std::max(1, options_.jobs));
    tbb::parallel_for(std::size_t{0}, indices.size(), [&](std::size_t k) {
      const std::size_t i = indices[k];
      const auto start = Clock::now();
      if (!is_ready(i)) return;
      Found& found = evidence_[i];
      const Decided::Origin origin = found.origin;
      const claims::Lowered& lowered = *questions_[i].lowered;
      Decided answer;
      const auto refusal = limits_(step(i, origin), [&] {
        answer =
            judged(lowered, *questions_[i].statement, std::move(found.evidence), normal_form_);
      });
      if (origin == Decided::Origin::stored && (refusal || !answer.outcome.alarm.empty()))
        return;
      if (refusal) answer = not_judged(lowered, *questions_[i].statement, *refusal);
      answer.origin = origin;
      answer.seconds =
          found.seconds + std::chrono::duration<double>(Clock::now() - start).count();
      answers_[i] = std::move(answer);
      if (origin == Decided::Origin::stored) tell(i, true);
    });
  }

  void search(const std::vector<std::size_t>& open) {
    std::list<Running> running;
    std::size_t next = 0;
    while (next < open.size() || !running.empty()) {
      for (; next < open.size() && std::ssize(running) < std::max(1, options_.jobs); ++next)
        running.emplace_back(open[next], statement(open[next]), options_);
      wait_for(running);
      for (auto it = running.begin(); it != running.end();) {
        if (Clock::now() >= it->worker.end()) it->worker.give_up();
        if (!it->worker.has_ended_after_reading()) {
          ++it;
          continue;
        }
        finish(it->question, it->worker.left());
        it = running.erase(it);
      }
    }
  }

  // Until one has something to say, or had its time.
  static void wait_for(const std::list<Running>& running) {
    std::vector<pollfd> pipes;
    Clock::time_point first = Clock::now() + std::chrono::hours(1);
    for (const Running& search : running) {
      pipes.push_back({search.worker.pipe(), POLLIN, 0});
      first = std::min(first, search.worker.end());
    }
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count();
    poll(pipes.data(), pipes.size(), static_cast<int>(std::max<long>(left + 1, 0)));
  }

  void finish(std::size_t i, Worker::Left left) {
    bool is_kept = false;
    if (left.is_repeatable) {
      const Uninterrupted whole;
      is_kept = store_.keep(statement(i), left.text);
    }
    evidence_[i] = {std::move(left.evidence), Decided::Origin::searched, left.seconds};
    tell(i, is_kept);
  }

  void tell(std::size_t i, bool is_kept) {
    const std::lock_guard lock(telling_);
    ++done_;
    if (is_kept) ++kept_;
    if (!progress_) return;
    set_progress(done_, static_cast<int>(questions_.size()), kept_);
    progress_(done_, static_cast<int>(questions_.size()), questions_[i].id);
  }

  struct Found {
    Evidence evidence;
    Decided::Origin origin = Decided::Origin::searched;
    double seconds = 0;
  };

  const std::vector<Question>& questions_;
  const VerifyOptions& options_;
  const NormalForm& normal_form_;
  const Progress& progress_;
  const claims::Limits limits_;
  Store store_;
  std::vector<std::optional<Decided>> answers_;
  std::vector<Found> evidence_;
  std::mutex telling_;
  int done_ = 0, kept_ = 0;
};

}  // namespace

std::vector<Decided> decide(const std::vector<Question>& questions,
                            const VerifyOptions& options, const NormalForm& normal_form,
                            const Progress& progress) {
  return Decisions(questions, options, normal_form, progress).all();
}

}  // namespace seam::cli
