// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify.h"

#include <fnmatch.h>

#include <algorithm>
#include <mutex>

#include "certificate/sha256.h"
#include "claims/latex.h"
#include "claims/rests_on.h"
#include "cli/decide.h"
#include "cli/drawn.h"
#include "cli/files.h"
#include "cli/supervisor.h"
#include "cli/true_digits.h"
#include "cli/warnings.h"
#include "draw/figure_marks.h"
#include "symbolic/second_opinion.h"

namespace seam::cli {
namespace {

using certificate::Certificate;
using certificate::Verdict;
using claims::MeantClaim;

struct Task {
  Question question;
  const claims::Lowered* otherwise = nullptr;  ///< where that cannot be proven
  bool is_otherwise = false;                   ///< it was not: `decided` is about the other
  Decided decided = {};
};

void run(std::vector<Task>& tasks, const claims::Meaning& meaning, const VerifyOptions& options,
         const Progress& progress) {
  std::mutex numbers;
  const NormalForm normal_form = [&](const symbolic::Formula& f) {
    const std::lock_guard lock(numbers);
    return meaning.numbers->normal_form(f);
  };
  std::vector<Question> questions;
  for (const Task& task : tasks) questions.push_back(task.question);
  std::vector<Decided> answers = decide(questions, options, normal_form, progress);
  for (std::size_t i = 0; i < tasks.size(); ++i) tasks[i].decided = std::move(answers[i]);

  std::vector<Task*> again;
  questions.clear();
  for (Task& task : tasks) {
    if (!task.otherwise || task.decided.outcome.verdict == Verdict::proven) continue;
    task.is_otherwise = true;
    again.push_back(&task);
    questions.push_back({task.question.id, task.otherwise, task.question.statement});
  }
  answers = decide(questions, options, normal_form, progress);
  for (std::size_t i = 0; i < again.size(); ++i) {
    answers[i].seconds += again[i]->decided.seconds;
    again[i]->decided = std::move(answers[i]);
  }
}

// Every accepted obligation once more by a third arithmetic, at one point; one after the other.
// One that takes too long is no alarm.
void ask_for_second_opinions(std::vector<Task>& tasks, const claims::Limits& within) {
  for (Task& task : tasks) {
    const claims::Lowered& lowered =
        task.is_otherwise ? *task.otherwise : *task.question.lowered;
    if (!lowered.exported) continue;
    const certificate::Statement& statement = lowered.exported->statement;
    report::Outcome& outcome = task.decided.outcome;
    for (std::size_t i = 0; i < outcome.obligations.size() && outcome.alarm.empty(); ++i) {
      if (outcome.obligations[i].status != report::ObligationRun::Status::holds) continue;
      within("a second opinion on " + std::to_string(i) + " of " + outcome.digest, [&] {
        if (const auto contradiction =
                symbolic::contradiction(statement, statement.obligations[i]))
          outcome.alarm = outcome.obligations[i].kind + ": " + *contradiction;
      });
    }
  }
}

// The claims of a meaning in file order, cells of tables among them.
void each_claim(const claims::Meaning& meaning,
                const std::function<void(const MeantClaim&)>& f) {
  for (const auto& item : meaning.items) {
    if (const auto* claim = std::get_if<MeantClaim>(&item)) f(*claim);
    if (const auto* table = std::get_if<claims::MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const MeantClaim& cell : row.cells) f(cell);
  }
}

std::vector<Task> tasks_of(const claims::Meaning& meaning,
                           const std::vector<std::string>& patterns) {
  std::vector<Task> tasks;
  each_claim(meaning, [&](const MeantClaim& claim) {
    if (!selected(claim.claim.id, patterns)) return;
    tasks.push_back({{claim.claim.id, &claim.printed, &claim.claim.statement}});
    if (claim.corrected)
      tasks.push_back({{claim.claim.id, &*claim.corrected, &*claim.claim.corrected}});
  });
  for (const auto& item : meaning.items)
    if (const auto* ask = std::get_if<claims::MeantAsk>(&item);
        ask && selected(ask->id, patterns))
      tasks.push_back({{ask->id, &ask->statement, &ask->expression},
                       ask->enclosure ? &*ask->enclosure : nullptr});
  return tasks;
}

// A proven claim that rests on one that is not proven is conditional. `using` has no circles.
void mark_conditional(const std::string& id,
                      const std::map<std::string, std::vector<std::string>>& uses,
                      std::map<std::string, Verdict>& verdicts,
                      std::map<std::string, std::string>& because) {
  const auto own = uses.find(id);
  if (own == uses.end() || because.contains(id)) return;
  because[id];
  for (const std::string& used : own->second) {
    mark_conditional(used, uses, verdicts, because);
    const auto verdict = verdicts.find(used);
    if (verdict != verdicts.end() && verdict->second == Verdict::proven) continue;
    auto& mine = verdicts.at(id);
    if (mine == Verdict::proven) mine = Verdict::conditional;
    if (because[id].empty()) because[id] = "rests on '" + used + "', which is not proven";
  }
}

std::string file_name(const std::string& id, bool correction) {
  return certificate_file(id + (correction ? ".corrected" : ""));
}

std::vector<std::string> names_of(const claims::Item& item) {
  return item.names.empty() ? std::vector{item.name} : item.names;
}

report::DefinitionRun definition_run(const claims::Item& item) {
  report::DefinitionRun run{claims::latex(item), item.comments, names_of(item)};
  claims::Item bare = item;
  bare.comments.clear();
  run.text = claims::format(claims::File{nullptr, {std::move(bare)}, {}});
  while (run.text.ends_with('\n')) run.text.pop_back();
  run.is_parameter = item.kind == claims::Item::Kind::param;
  return run;
}

class Assembly {
 public:
  Assembly(std::vector<Task>& tasks, const claims::Meaning& meaning, std::string file)
      : tasks_(tasks), meaning_(meaning), file_(std::move(file)) {
    std::map<std::string, std::vector<std::string>> uses;
    each_claim(meaning, [&](const MeantClaim& claim) {
      uses[claim.claim.id] = claim.claim.using_claims;
    });
    for (const Task& task : tasks)
      verdicts_.emplace(task.question.id, task.decided.outcome.verdict);
    for (const Task& task : tasks)
      mark_conditional(task.question.id, uses, verdicts_, because_);
  }

  std::optional<report::ClaimRun> claim(const MeantClaim& meant) {
    if (next_ >= tasks_.size() || tasks_[next_].question.id != meant.claim.id)
      return std::nullopt;
    report::ClaimRun run;
    run.id = meant.claim.id;
    run.title = meant.claim.title;
    run.at = meant.claim.at;
    run.comments = meant.comments;
    const text::Position place = text::position(*meant.span.source, meant.span.begin);
    run.line = place.line;
    run.column = place.column;
    if (meant.span.source->name != file_) run.included = meant.span.source->name;
    run.using_claims = meant.claim.using_claims;
    run.predicates.assign(meant.printed.predicates.begin(), meant.printed.predicates.end());
    for (const claims::Item* item : claims::rests_on(meaning_, meant.claim))
      for (const std::string& name : names_of(*item)) run.definitions.push_back(name);
    run.expected = meant.corrected || meant.claim.expect == "refuted" ? Verdict::refuted
                   : meant.claim.expect == "undecided"                ? Verdict::undecided
                                                                      : Verdict::proven;
    run.printed = outcome(run, meant.printed, false);
    if (meant.corrected) run.corrected = outcome(run, *meant.corrected, true);
    return run;
  }

  report::AskRun ask(const claims::MeantAsk& meant) {
    report::AskRun run;
    run.id = meant.id;
    run.latex = claims::latex(meant.expression);
    run.text = claims::format(meant.expression);
    const auto task = std::ranges::find_if(
        tasks_, [&](const Task& t) { return t.question.lowered == &meant.statement; });
    if (task == tasks_.end()) return run;
    run.seconds = task->decided.seconds;
    const report::Outcome& outcome = task->decided.outcome;
    run.detail = outcome.detail;
    run.confirmed.alarm = outcome.alarm;
    if (outcome.verdict == Verdict::proven) {
      run.decimal = meant.decimal;
      if (!task->is_otherwise) run.closed_form = meant.closed_form;
      const claims::Lowered& lowered = task->is_otherwise ? *task->otherwise : meant.statement;
      run.confirmed.digest = outcome.digest;
      run.confirmed.certificate = certificate_file(run.id);
      certificates[run.confirmed.certificate] = {run.id,
                                                 false,
                                                 Verdict::proven,
                                                 {},
                                                 lowered.exported->statement,
                                                 task->decided.evidence};
    } else if (run.detail.empty()) {
      run.detail = "the value that was found could not be confirmed";
    }
    return run;
  }

  std::map<std::string, Certificate> certificates;

 private:
  report::Outcome outcome(report::ClaimRun& run, const claims::Lowered& lowered,
                          bool correction) {
    Task& task = tasks_[next_++];
    report::Outcome result = task.decided.outcome;
    run.seconds += task.decided.seconds;
    result.is_stored = task.decided.origin == Decided::Origin::stored;
    const auto reason = because_.find(run.id);
    if (result.verdict == Verdict::proven && reason != because_.end() &&
        !reason->second.empty()) {
      result.verdict = Verdict::conditional;
      result.reason = "assumption";
      result.detail = reason->second;
    }
    if (lowered.exported) {
      result.certificate = file_name(run.id, correction);
      certificates[result.certificate] = {run.id,
                                          correction,
                                          result.verdict,
                                          run.using_claims,
                                          lowered.exported->statement,
                                          task.decided.evidence};
    }
    return result;
  }

  std::vector<Task>& tasks_;
  const claims::Meaning& meaning_;
  std::string file_;  ///< its own, as it was asked for
  std::size_t next_ = 0;
  std::map<std::string, Verdict> verdicts_;
  std::map<std::string, std::string> because_;
};

}  // namespace

std::string certificate_file(std::string name) {
  std::ranges::replace(name, ':', '=');  // no colon in file names
  return "certificates/" + name + ".json";
}

bool selected(const std::string& id, const std::vector<std::string>& patterns) {
  return patterns.empty() || std::ranges::any_of(patterns, [&](const std::string& pattern) {
           return pattern == id || fnmatch(pattern.c_str(), id.c_str(), 0) == 0;
         });
}

Verified verify(const std::filesystem::path& file, const VerifyOptions& options,
                const Progress& progress) {
  const claims::Limits within = limits(options, file.string());
  const claims::Meaning meaning = meant(file, within);
  std::vector<Task> tasks = tasks_of(meaning, options.claims);
  run(tasks, meaning, options, progress);
  ask_for_second_opinions(tasks, within);

  Assembly assembly(tasks, meaning, file.string());
  Verified result;
  if (!options.claims.empty()) result.extent = Verified::Extent::selection;
  result.run.file = file.filename().string();
  result.run.path = file.string();
  result.run.paper = meaning.paper;
  result.run.by = meaning.by;
  result.run.source = meaning.source;
  result.run.year = meaning.year;
  result.run.sha256 = certificate::sha256(open(file)->bytes);
  for (const auto& item : meaning.items) {
    if (const auto* section = std::get_if<claims::MeantSection>(&item)) {
      result.run.items.push_back(report::SectionRun{section->title});
    } else if (const auto* definition = std::get_if<claims::MeantDefinition>(&item)) {
      result.run.items.push_back(definition_run(definition->item));
    } else if (const auto* claim = std::get_if<MeantClaim>(&item)) {
      if (auto run = assembly.claim(*claim)) result.run.items.push_back(std::move(*run));
    } else if (const auto* table = std::get_if<claims::MeantTable>(&item)) {
      report::TableRun run{table->heading.id, table->heading.title, table->heading.at,
                           table->labels,     table->comments,      {}};
      for (const auto& row : table->rows) {
        run.rows.push_back({row.label, claims::latex(row.value), {}, {}});
        for (const MeantClaim& cell : row.cells) {
          auto cell_run = assembly.claim(cell);
          if (!cell_run) continue;
          run.rows.back().cells.push_back(std::move(*cell_run));
          run.rows.back().printed.push_back(claims::format(cell.printed_value()));
        }
      }
      result.run.items.push_back(std::move(run));
    } else if (const auto* ask = std::get_if<claims::MeantAsk>(&item)) {
      if (selected(ask->id, options.claims)) result.run.items.push_back(assembly.ask(*ask));
    } else if (const auto* figure = std::get_if<claims::MeantFigure>(&item)) {
      result.run.items.push_back(
          drawn(*figure, *meaning.numbers, result.run.items.size(), within));
    }
  }
  result.certificates = std::move(assembly.certificates);
  result.run.warnings = warnings_of(file, meaning, result.run);
  add_true_digits(result, meaning, file, options);
  draw::mark_refutations(result.run, meaning);
  return result;
}

}  // namespace seam::cli
