// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/refutation.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace seam::cli {
namespace {

using certificate::Evidence;
using certificate::Statement;
using symbolic::Formula;

const char* negated_sign(certificate::Relation relation) {
  static const char* const signs[] = {"<= 0", "< 0", "!= 0", "= 0", "> 0", ">= 0"};
  return signs[static_cast<int>(relation)];
}

// The obligations under an odd number of negations.
void collect_denied(const certificate::Goal& goal, bool is_denied,
                    std::vector<const certificate::Goal*>& result) {
  if (goal.kind == certificate::Goal::Kind::obligation && is_denied) result.push_back(&goal);
  const bool negates = goal.kind == certificate::Goal::Kind::negation;
  for (const certificate::Goal& part : goal.parts)
    collect_denied(part, is_denied != negates, result);
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

}  // namespace

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

}  // namespace seam::cli
