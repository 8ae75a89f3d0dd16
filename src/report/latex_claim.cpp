// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_claim.h"

#include <algorithm>

#include "report/escape.h"
#include "report/latex_macro.h"
#include "report/mathematics.h"
#include "report/obligation_groups.h"
#include "report/witness.h"

namespace seam::report {
namespace {

constexpr std::size_t longest_obligation = 1500;  // bytes; beyond, the certificate has it
constexpr std::size_t longest_line = 70;          // that stands beside its mark
constexpr std::size_t most_evidence = 3;  // different lines of evidence shown for a group

std::string evidence_of(const ObligationGroup& group) {
  std::vector<std::string> shown;
  for (const std::string& line : group.evidence)
    if (shown.size() < most_evidence) shown.push_back(escape(line));
  if (group.evidence.size() > most_evidence)
    shown.push_back("and " + std::to_string(group.evidence.size() - most_evidence) +
                    " other proofs of this kind");
  return joined(shown, "; ");
}

std::string latex_group(const ObligationGroup& group) {
  const ObligationRun& first = *group.first;
  // What is about nothing in particular says itself what it is, if it is short.
  const bool is_shown = first.about.empty() && first.latex.empty() && !first.text.empty() &&
                        first.text.size() <= longest_line && group.count == 1;
  std::string words =
      is_shown ? "{\\small\\texttt{" + escape(first.text) + "}}" : escape(about(first));
  if (first.guard) words += " \\SeamQuiet{(so that the formulas mean something)}";
  if (group.count > 1)
    words += " \\SeamQuiet{--- " + std::to_string(group.count) + " of this kind}";
  std::string result =
      latex_call("SeamObligation", {name(first.status), words, evidence_of(group)});
  if (is_shown) return result;
  const std::string shown = first.latex.empty() ? first.text : first.latex;
  if (shown.size() > longest_obligation)
    return result + latex_call("SeamTrace", {"its formula is long; the certificate holds it"});
  if (group.count > 1 && !shown.empty())
    result += latex_call("SeamTrace", {"the first of them:"}) + "\\nobreak\n";
  if (!first.latex.empty())
    result += latex_call("SeamFormula", {mathematics(first.latex)});
  else if (!first.text.empty())
    result += latex_call("SeamSource", {escape(first.text)});
  return result;
}

std::string latex_obligations(const std::vector<ObligationRun>& obligations) {
  if (obligations.empty()) return "";
  std::string result = "\\begin{SeamObligations}\n";
  for (const ObligationGroup& group : grouped(obligations)) result += latex_group(group);
  return result + "\\end{SeamObligations}\n";
}

std::string latex_trace(const Outcome& outcome, const std::vector<std::string>& using_claims) {
  const auto labelled = [](const std::string& label, const std::string& text) {
    return text.empty() ? "" : label + " \\texttt{" + escape(text) + "}";
  };
  std::vector<std::string> methods;
  for (const std::string& method : outcome.method) methods.push_back(escape(method));
  const std::string trace =
      joined({joined(methods, ", "), labelled("rests on", joined(using_claims, ", ")),
              labelled("certificate", outcome.certificate)},
             " $\\cdot$ ");
  return trace.empty() ? "" : latex_call("SeamTrace", {trace});
}

std::string latex_outcome(const Outcome& outcome,
                          const std::vector<std::string>& using_claims) {
  std::string result = latex_call("SeamFormula", {mathematics(outcome.latex)});
  if (!outcome.alarm.empty())
    result += latex_call("SeamAlarm", {"The checker objects: " + escape(outcome.alarm)});
  if (!outcome.witness.empty())
    result += latex_call("SeamLine", {"witness", escape(readable_witness(outcome.witness))});
  const std::string reason = joined({escape(outcome.reason), escape(outcome.detail)}, ": ");
  if (!reason.empty()) result += latex_call("SeamLine", {"reason", reason});
  if (const ObligationRun* closest = closest_to_failing(outcome))
    result += latex_call("SeamTrace", {"slack " + escape(in_words(closest->slack))});
  return result + latex_obligations(outcome.obligations) + latex_trace(outcome, using_claims);
}

}  // namespace

std::string latex_anchor(const ClaimRun& claim) {
  std::string anchor = "claim.";
  for (const char c : claim.id) anchor += std::to_string(static_cast<unsigned char>(c)) + ".";
  return anchor;
}

std::string latex_claim_link(const ClaimRun& claim) {
  return "\\SeamLink{" + latex_anchor(claim) + "}{\\texttt{" + escape(claim.id) + "}}";
}

std::string latex_claim(const ClaimRun& claim) {
  std::string result =
      latex_call("SeamClaim", {word(claim.printed.verdict), latex_anchor(claim),
                               escape(claim.id), escape(claim.title), escape(claim.at)});
  result += "\\begin{SeamIndent}\n";
  result += latex_note(claim.comments);
  if (claim.printed.verdict != claim.expected)
    result +=
        latex_call("SeamLine", {"expected", latex_call("SeamVerdict", {word(claim.expected)})});
  result += latex_outcome(claim.printed, claim.using_claims);
  if (!claim.true_digits.empty())
    result += latex_call("SeamLine", {"true digits", escape(claim.true_digits)});
  if (claim.corrected) {
    result += latex_call(
        "SeamLine", {"corrected", latex_call("SeamVerdict", {word(claim.corrected->verdict)})});
    result += latex_outcome(*claim.corrected, {});
  }
  return result + "\\end{SeamIndent}\n";
}

}  // namespace seam::report
