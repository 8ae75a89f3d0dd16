// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/judge.h"

#include <algorithm>
#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "certificate/fault.h"
#include "check/rules.h"

// A finding is `holds` or `fails` only where a rule says so. The goal is evaluated in
// three values: what is open stays open unless the rest decides.

namespace seam::check {
namespace {

using certificate::Evidence;
using certificate::Goal;
using certificate::Proof;
using certificate::Statement;
using certificate::Verdict;
using Kind = Finding::Kind;

// Whatever goes wrong within shows nothing, and is no reason to stop.
template <typename Result, typename Action>
std::optional<Result> attempt(std::string& reason, const Action& action) {
  try {
    return action();
  } catch (const Open& open) {
    reason = open.what();
  } catch (const std::bad_alloc&) {
    reason = "memory";
  } catch (const std::exception& error) {
    reason = error.what();
  }
  return std::nullopt;
}

Finding find(Context& context, const certificate::Obligation& obligation, const Proof& proof) {
  if (const auto* nothing = std::get_if<certificate::Nothing>(&proof))
    return {Kind::open, nothing->reason + ": " + nothing->detail};
  Finding finding;
  const auto decided = attempt<bool>(finding.reason, [&] {
    return std::visit([&](const auto& stated) { return decide(context, stated, proof); },
                      obligation);
  });
  if (decided) finding.kind = *decided ? Kind::holds : Kind::fails;
  const std::string place = std::exchange(context.failed_at, {});
  if (finding.kind == Kind::fails) finding.reason = place;
  return finding;
}

std::vector<Finding> find_all(const Statement& statement, const Evidence& evidence,
                              long effort) {
  Meter meter(effort);
  std::string reason;
  const auto found = attempt<std::vector<Finding>>(reason, [&] {
    Context context(statement, evidence, meter);
    std::vector<Finding> findings;
    for (std::size_t i = 0; i < statement.obligations.size(); ++i)
      findings.push_back(find(context, statement.obligations[i], evidence.proofs[i]));
    return findings;
  });
  if (found) return *found;
  return std::vector<Finding>(statement.obligations.size(), {Kind::open, reason});
}

// Recursion is bounded: a deeper goal has a fault.
Kind value(const Goal& goal, const std::vector<Finding>& findings) {
  if (goal.kind == Goal::Kind::obligation)
    return findings[static_cast<std::size_t>(goal.obligation)].kind;
  if (goal.kind == Goal::Kind::negation) {
    const Kind inner = value(goal.parts.front(), findings);
    if (inner == Kind::open) return Kind::open;
    return inner == Kind::holds ? Kind::fails : Kind::holds;
  }
  if (goal.kind == Goal::Kind::suffices)
    return value(goal.parts.front(), findings) == Kind::holds ? Kind::holds : Kind::open;
  const Kind deciding = goal.kind == Goal::Kind::all ? Kind::fails : Kind::holds;
  Kind result = goal.kind == Goal::Kind::all ? Kind::holds : Kind::fails;
  for (const Goal& part : goal.parts) {
    const Kind kind = value(part, findings);
    if (kind == deciding) return deciding;
    if (kind == Kind::open) result = Kind::open;
  }
  return result;
}

// Of an open goal: the reason of the first part that left it open.
std::string open_reason(const Goal& goal, const std::vector<Finding>& findings) {
  if (goal.kind == Goal::Kind::obligation)
    return findings[static_cast<std::size_t>(goal.obligation)].reason;
  for (const Goal& part : goal.parts)
    if (value(part, findings) == Kind::open) return open_reason(part, findings);
  return "what would suffice fails, which refutes nothing";
}

}  // namespace

Judgement judge(const Statement& statement, const Evidence& evidence, long effort) {
  Judgement judgement;
  judgement.reason = certificate::fault(statement, evidence);
  if (!judgement.reason.empty()) {
    judgement.reason = "malformed: " + judgement.reason;
    judgement.findings.resize(statement.obligations.size(), {Kind::open, judgement.reason});
    return judgement;
  }
  judgement.findings = find_all(statement, evidence, effort);
  for (const int guard : statement.guards) {
    const Finding& finding = judgement.findings[static_cast<std::size_t>(guard)];
    if (finding.kind == Kind::holds) continue;
    judgement.reason = finding.kind == Kind::fails
                           ? "degenerate: a condition for the claim to have a meaning fails"
                           : finding.reason;
    return judgement;
  }
  const Kind kind = value(statement.goal, judgement.findings);
  if (kind == Kind::open)
    judgement.reason = open_reason(statement.goal, judgement.findings);
  else
    judgement.verdict = kind == Kind::holds ? Verdict::proven : Verdict::refuted;
  return judgement;
}

}  // namespace seam::check
