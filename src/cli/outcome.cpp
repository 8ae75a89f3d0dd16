// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outcome.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include "certificate/json.h"
#include "check/judge.h"
#include "claims/latex.h"
#include "symbolic/formula.h"

namespace seam::cli {
namespace {

using certificate::Evidence;
using certificate::Node;
using certificate::Statement;
using certificate::Term;
using certificate::Verdict;
using symbolic::Formula;

// The formula of a node: shared nodes are built once.
class Formulas {
 public:
  Formulas(const Statement& statement, const Evidence& evidence)
      : statement_(statement), evidence_(evidence) {}

  Formula operator()(Term term) {
    if (const auto known = done_.find(term); known != done_.end()) return known->second;
    const auto size = static_cast<Term>(statement_.nodes.size());
    const Node& node = term < size ? statement_.nodes[term] : evidence_.nodes[term - size];
    std::vector<Formula> operands;
    for (const Term operand : node.operands) operands.push_back((*this)(operand));
    Formula result = 0;
    switch (node.kind) {
      case Node::Kind::constant:
        result = Formula(exact::Rational(node.text));
        break;
      case Node::Kind::symbol:
        result = Formula::symbol(node.text);
        break;
      case Node::Kind::sum:
        result = symbolic::sum(std::move(operands));
        break;
      case Node::Kind::product:
        result = symbolic::product(std::move(operands));
        break;
      case Node::Kind::power:
        result = symbolic::power(operands[0], node.exponent);
        break;
    }
    done_.emplace(term, result);
    return result;
  }

 private:
  const Statement& statement_;
  const Evidence& evidence_;
  std::map<Term, Formula> done_;
};

// `u~` and `v~` are the parameters of a patch: a reader calls them u and v. The value of an
// arbitrary function is called `x'{t}`.
std::string readable(std::string text) {
  std::erase(text, '~');
  std::ranges::replace(text, '{', '(');
  std::ranges::replace(text, '}', ')');
  return text;
}

// `x0` and 2 of `x0[2]`; 0 of a name without an index.
std::pair<std::string, int> indexed(const std::string& name) {
  const std::size_t at = name.rfind('[');
  if (at == std::string::npos || name.back() != ']' || name.size() - at > 5) return {name, 0};
  const std::string digits = name.substr(at + 1, name.size() - at - 2);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
    return {name, 0};
  return {name.substr(0, at), std::stoi(digits)};
}

// The coordinates of a vector stand together, once all are there.
std::string point_text(const certificate::Point& point, Formulas& formulas) {
  std::map<std::string, std::map<int, std::string>> values;
  std::vector<std::string> order;
  for (std::size_t i = 0; i < point.variables.size(); ++i) {
    const auto [name, index] = indexed(point.variables[i]);
    if (!values.contains(name)) order.push_back(name);
    values[name].emplace(index, symbolic::text(formulas(point.values[i]), 60));
  }
  std::string result;
  for (const std::string& name : order) {
    const auto& entries = values[name];
    const bool is_vector = entries.size() > 1 && entries.begin()->first == 1 &&
                           entries.rbegin()->first == std::ssize(entries);
    std::string tuple;
    for (const auto& [index, value] : entries) {
      if (is_vector)
        tuple += (tuple.empty() ? "" : ", ") + value;
      else
        result += (result.empty() ? "" : ", ") + name +
                  (index > 0 ? "[" + std::to_string(index) + "]" : "") + " = " + value;
    }
    if (is_vector) result += (result.empty() ? "" : ", ") + name + " = (" + tuple + ")";
  }
  return readable(result);
}

const char* negated_sign(certificate::Relation relation) {
  static const char* const signs[] = {"<= 0", "< 0", "!= 0", "= 0", "> 0", ">= 0"};
  return signs[static_cast<int>(relation)];
}

std::string kind_of(const certificate::Obligation& obligation) {
  static const char* const names[] = {"zero",      "sign",   "solutions", "solutions",
                                      "solutions", "gluing", "distinct",  "mesh"};
  return names[obligation.index()];
}

struct Summary {
  std::string method, line;
};

Summary summary_of(const certificate::Obligation& obligation, const certificate::Proof& proof,
                   Formulas& formulas) {
  if (const auto* nothing = std::get_if<certificate::Nothing>(&proof))
    return {"", nothing->reason + ": " + nothing->detail};
  if (std::holds_alternative<certificate::Computation>(proof)) {
    if (std::holds_alternative<certificate::Zero>(obligation))
      return {"normal form", "the normal form is 0"};
    if (std::holds_alternative<certificate::Sign>(obligation))
      return {"enclosure", "the number is computed"};
    return {"count", "counted"};
  }
  if (const auto* pieces = std::get_if<certificate::Pieces>(&proof)) {
    const auto leaves = std::ranges::count_if(
        pieces->steps, [](const auto& s) { return s.kind != certificate::Step::Kind::split; });
    const std::string square = pieces->square >= 0 ? "a square factor taken out; " : "";
    return {"subdivision", square + "subdivision, " + std::to_string(leaves) +
                               (leaves == 1 ? " piece" : " pieces")};
  }
  if (std::holds_alternative<certificate::Reduction>(proof))
    return {"reduction", "reduced to other signs, then subdivision"};
  if (const auto* witness = std::get_if<certificate::Witness>(&proof))
    return {"witness", "witness " + point_text(witness->point, formulas)};
  if (std::holds_alternative<certificate::Roots>(proof))
    return {"roots", "greatest common divisor and its roots"};
  if (std::holds_alternative<certificate::Isolation>(proof))
    return {"isolation", "a box that holds a solution"};
  if (const auto* elimination = std::get_if<certificate::Elimination>(&proof))
    return {"elimination", "elimination, " + std::to_string(elimination->steps.size()) +
                               (elimination->steps.size() == 1 ? " step" : " steps")};
  return {"witness", "a wrong solution"};
}

// The obligations under an odd number of negations.
void collect_denied(const certificate::Goal& goal, bool is_denied,
                    std::vector<const certificate::Goal*>& result) {
  if (goal.kind == certificate::Goal::Kind::obligation && is_denied) result.push_back(&goal);
  const bool negates = goal.kind == certificate::Goal::Kind::negation;
  for (const certificate::Goal& part : goal.parts)
    collect_denied(part, is_denied != negates, result);
}

// The obligations that stand under an odd number of negations and nowhere else: the claim gains
// where they fail.
std::set<int> only_denied(const Statement& statement) {
  std::vector<const certificate::Goal*> denied, others;
  collect_denied(statement.goal, false, denied);
  collect_denied(statement.goal, true, others);
  std::set<int> elsewhere(statement.guards.begin(), statement.guards.end()), result;
  for (const certificate::Goal* goal : others) elsewhere.insert(goal->obligation);
  for (const certificate::Goal* goal : denied)
    if (!elsewhere.contains(goal->obligation)) result.insert(goal->obligation);
  return result;
}

// The obligations that stand elsewhere than under what merely suffices: they can refute.
void collect_deciding(const certificate::Goal& goal, std::set<std::size_t>& result) {
  if (goal.kind == certificate::Goal::Kind::suffices) return;
  if (goal.kind == certificate::Goal::Kind::obligation)
    result.insert(static_cast<std::size_t>(goal.obligation));
  for (const certificate::Goal& part : goal.parts) collect_deciding(part, result);
}

// What an isolation refutes by: where a solution is that is not in the box of the statement.
std::string isolated(const certificate::OneSolution& stated,
                     const certificate::Isolation& found) {
  if (found.inner.low.empty()) return "there is no solution";
  std::string result;
  for (std::size_t j = 0; j < stated.unknowns.size(); ++j) {
    std::ostringstream ends;
    ends << std::fixed << std::setprecision(6)
         << std::floor(exact::Rational(found.inner.low[j]).get_d() * 1e6) / 1e6 << ", "
         << std::ceil(exact::Rational(found.inner.high[j]).get_d() * 1e6) / 1e6;
    result += (j == 0 ? "" : ", ") + stated.unknowns[j] + " in [" + ends.str() + "]";
  }
  return "a solution with " + result;
}

// What was counted on a mesh, for a claim that is wrong about it.
std::string counted_of(const Statement& statement, const check::Judgement& judgement,
                       const claims::Exported& exported) {
  std::string result;
  for (const int guard : statement.guards)
    if (std::holds_alternative<certificate::Mesh>(statement.obligations[guard]) &&
        judgement.findings[guard].kind == check::Finding::Kind::holds)
      result += (result.empty() ? "" : "; ") + exported.text[guard];
  return result.size() > 300 ? std::string() : result;
}

// What refutes: the point of the first obligation that fails by one, and the relation that
// holds there instead.
std::string witness_of(const Statement& statement, const Evidence& evidence,
                       const check::Judgement& judgement, const claims::Exported& exported,
                       Formulas& formulas, const NormalForm& normal_form) {
  // Numbers that the evidence brings along are unknown to the file.
  const auto number_text = [&](const Formula& f, std::size_t most) {
    const bool known = evidence.generators.empty() && symbolic::is_number(f);
    return readable(symbolic::text(known ? normal_form(f) : f, most));
  };
  const std::string counted = counted_of(statement, judgement, exported);
  std::set<std::size_t> deciding;
  collect_deciding(statement.goal, deciding);
  for (const std::size_t i : deciding) {
    if (judgement.findings[i].kind != check::Finding::Kind::fails) continue;
    if (const auto* wrong = std::get_if<certificate::WrongSolution>(&evidence.proofs[i])) {
      const std::string value = number_text(formulas(wrong->value), 200);
      return wrong->claimed < 0 ? value + " is a solution too" : value + " is no solution";
    }
    if (const auto* box = std::get_if<certificate::Isolation>(&evidence.proofs[i]))
      return isolated(std::get<certificate::OneSolution>(statement.obligations[i]), *box);
    if (const auto* witness = std::get_if<certificate::Witness>(&evidence.proofs[i])) {
      if (std::holds_alternative<certificate::OnlySolutions>(statement.obligations[i]))
        return point_text(witness->point, formulas) + " is a solution too";
      if (witness->point.variables.empty() && !counted.empty()) return counted;
      const auto* sign = std::get_if<certificate::Sign>(&statement.obligations[i]);
      const Formula formula = formulas(
          sign ? sign->formula : std::get<certificate::Zero>(statement.obligations[i]).formula);
      std::map<std::string, Formula> values;
      for (std::size_t k = 0; k < witness->point.variables.size(); ++k)
        values.emplace(witness->point.variables[k], formulas(witness->point.values[k]));
      std::string value = number_text(symbolic::subst(formula, values), 60);
      if (value.ends_with("...")) value = "the difference";
      const std::string there = point_text(witness->point, formulas);
      const std::string about = exported.about[i].empty() ? "" : " (" + exported.about[i] + ")";
      return (there.empty() ? "" : there + ": ") + value + " " +
             (sign ? negated_sign(sign->relation) : "!= 0") + about;
    }
  }
  for (const std::size_t i : deciding)
    if (judgement.findings[i].kind == check::Finding::Kind::fails &&
        !judgement.findings[i].reason.empty())
      return judgement.findings[i].reason;
  if (!counted.empty()) return counted;
  for (const std::size_t i : deciding)
    if (judgement.findings[i].kind == check::Finding::Kind::fails)
      return "not: " + readable(exported.text[i]) +
             (exported.about[i].empty() ? "" : " (" + exported.about[i] + ")");
  // What was denied may hold.
  std::vector<const certificate::Goal*> denied;
  collect_denied(statement.goal, false, denied);
  for (const certificate::Goal* goal : denied) {
    const int i = goal->obligation;
    if (judgement.findings[i].kind != check::Finding::Kind::holds) continue;
    const bool is_guard = std::ranges::find(statement.guards, i) != statement.guards.end();
    return "holds: " + readable(exported.text[i]) +
           (is_guard && !exported.about[i].empty() ? " (" + exported.about[i] + ")" : "");
  }
  return "sizes or shapes differ";
}

bool is_elementary(const Statement& statement) {
  return std::ranges::any_of(statement.generators,
                             [](const auto& number) {
                               return number.function != certificate::Elementary::none;
                             }) ||
         !std::ranges::all_of(statement.functions, [](const auto& f) { return f.is_root(); });
}

// The prover works with numbers near transcendental ones. What it found and the checker did not
// accept is taken back: it was a guess.
bool withdraw_guesses(const Statement& statement, Evidence& evidence,
                      const check::Judgement& judgement) {
  if (!is_elementary(statement)) return false;
  bool changed = false;
  for (std::size_t i = 0; i < evidence.proofs.size(); ++i) {
    if (judgement.findings[i].kind != check::Finding::Kind::open ||
        std::holds_alternative<certificate::Nothing>(evidence.proofs[i]))
      continue;
    std::string reason = judgement.findings[i].reason;
    if (reason.starts_with("effort: ")) reason.erase(0, 8);
    evidence.proofs[i] = certificate::Nothing{"effort", reason};
    changed = true;
  }
  return changed;
}

}  // namespace

Decided judged(const claims::Lowered& lowered, const claims::Expression& statement,
               Evidence evidence, const NormalForm& normal_form) {
  Decided result;
  report::Outcome& outcome = result.outcome;
  outcome.text = claims::format(statement);
  outcome.latex = claims::latex(statement);
  if (!lowered.exported) {
    outcome.reason = "unsupported";
    outcome.detail = lowered.unsupported;
    return result;
  }
  const Statement& claimed = lowered.exported->statement;
  outcome.digest = certificate::digest(claimed);
  result.evidence = std::move(evidence);
  check::Judgement judgement = check::judge(claimed, result.evidence);
  if (withdraw_guesses(claimed, result.evidence, judgement))
    judgement = check::judge(claimed, result.evidence);
  outcome.verdict = judgement.verdict;

  Formulas formulas(claimed, result.evidence);
  const std::set<int> denied = only_denied(claimed);
  for (std::size_t i = 0; i < claimed.obligations.size(); ++i) {
    const certificate::Proof& proof = result.evidence.proofs[i];
    const check::Finding& finding = judgement.findings[i];
    const Summary summary = summary_of(claimed.obligations[i], proof, formulas);
    report::ObligationRun run;
    run.about = lowered.exported->about[i];
    if (denied.contains(static_cast<int>(i)))
      run.about += run.about.empty() ? "shown if this fails" : ", shown if this fails";
    run.kind = kind_of(claimed.obligations[i]);
    run.text = readable(lowered.exported->text[i]);
    run.guard = std::ranges::find(claimed.guards, static_cast<int>(i)) != claimed.guards.end();
    run.status = static_cast<report::ObligationRun::Status>(finding.kind);
    run.evidence = summary.line;
    outcome.obligations.push_back(std::move(run));
    if (!summary.method.empty() &&
        std::ranges::find(outcome.method, summary.method) == outcome.method.end())
      outcome.method.push_back(summary.method);
    const bool offered = !std::holds_alternative<certificate::Nothing>(proof);
    if (offered && finding.kind == check::Finding::Kind::open &&
        !finding.reason.starts_with("effort") && outcome.alarm.empty())
      outcome.alarm = run.kind + ": " + finding.reason;
  }
  if (outcome.verdict == Verdict::refuted)
    outcome.witness = witness_of(claimed, result.evidence, judgement, *lowered.exported,
                                 formulas, normal_form);
  if (outcome.verdict != Verdict::undecided) return result;

  // The prover says best why it found nothing; else a guard failed, or the checker gave up.
  for (std::size_t i = 0; i < result.evidence.proofs.size(); ++i) {
    const auto* nothing = std::get_if<certificate::Nothing>(&result.evidence.proofs[i]);
    if (!nothing || nothing->reason.empty() ||
        judgement.findings[i].kind != check::Finding::Kind::open)
      continue;
    outcome.reason = nothing->reason;
    outcome.detail = nothing->detail;
    return result;
  }
  outcome.reason = judgement.reason.starts_with("degenerate") ? "degenerate" : "effort";
  outcome.detail = judgement.reason;
  for (const auto& run : outcome.obligations)
    if (run.guard && run.status == report::ObligationRun::Status::fails) {
      outcome.detail = "what the claim rests on does not hold: " +
                       (run.about.empty() ? run.text : run.about);
      break;
    }
  return result;
}

}  // namespace seam::cli
