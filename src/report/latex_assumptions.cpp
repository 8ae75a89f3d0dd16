// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_assumptions.h"

#include <vector>

#include "report/assumptions.h"
#include "report/escape.h"
#include "report/latex_claim.h"
#include "report/latex_graph.h"
#include "report/latex_macro.h"
#include "report/mathematics.h"
#include "report/obligation_groups.h"

namespace seam::report {
namespace {

std::string counted(int n, const std::string& one, const std::string& several) {
  return std::to_string(n) + " " + (n == 1 ? one : several);
}

std::string marked(const ClaimRun& claim) {
  return "\\SeamMark{" + std::string(word(claim.printed.verdict)) + "}" +
         latex_claim_link(claim);
}

std::string parameters(const Assumptions& all) {
  std::string result;
  for (const auto& [definition, count] : all.parameters)
    result += latex_call("SeamFormula",
                         {mathematics(definition->latex) + "\\qquad\\text{\\SeamQuiet{in " +
                          counted(count, "claim", "claims") + "}}"});
  if (result.empty()) return "";
  return "Parameters: a claim holds for all that they may be.\\par\\nobreak\n"
         "\\begin{SeamIndent}\n" +
         result + "\\end{SeamIndent}\n";
}

std::string guards(const Assumptions& all) {
  std::string others;
  for (const auto& [claim, guard] : all.guards_not_proven)
    others += latex_call(
        "SeamObligation",
        {name(guard->status),
         latex_claim_link(*claim) + "\\quad " +
             escape(guard->about.empty() ? guard->text : guard->about + ": " + guard->text),
         ""});
  std::string result;
  if (all.guards_proven > 0)
    result +=
        counted(all.guards_proven, "condition under which the formulas mean something was",
                "conditions under which the formulas mean something were") +
        " proven with the claims: divisors that are not 0, radicands that are not negative, "
        "what the numbers are.\\par\n";
  if (!others.empty())
    result +=
        "These were not, and what rests on them is not decided:\\par\\nobreak\n"
        "\\begin{SeamConditions}\n" +
        others + "\\end{SeamConditions}\n";
  return result;
}

std::string uses(const FileRun& file, const Assumptions& all) {
  std::string result;
  for (const Assumptions::Use& use : all.uses) {
    std::vector<std::string> used;
    for (const auto& [id, claim] : use.rests_on)
      used.push_back(claim ? marked(*claim) : "\\texttt{" + escape(id) + "}");
    result += marked(*use.claim) + " \\SeamQuiet{rests on} " + joined(used, ", ") + "\\par\n";
  }
  if (result.empty()) return "";
  return "Claims that rest on others; where one of those is not proven, they are at best "
         "conditional.\\par\\nobreak\n\\begin{SeamIndent}\\raggedright\n" +
         result + "\\end{SeamIndent}\n" + latex_graph(file);
}

}  // namespace

std::string latex_assumptions(const FileRun& file) {
  const Assumptions all = assumptions(file);
  return all.empty() ? ""
                     : latex_heading(assumptions_title) + parameters(all) + guards(all) +
                           uses(file, all);
}

}  // namespace seam::report
