// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_assumptions.h"

#include <algorithm>
#include <vector>

#include "report/escape.h"
#include "report/latex_claim.h"
#include "report/latex_graph.h"
#include "report/latex_macro.h"
#include "report/mathematics.h"

namespace seam::report {
namespace {

std::string counted(int n, const std::string& one, const std::string& several) {
  return std::to_string(n) + " " + (n == 1 ? one : several);
}

bool speaks_of(const ClaimRun& claim, const DefinitionRun& definition) {
  return std::ranges::any_of(definition.names, [&](const std::string& name) {
    return std::ranges::find(claim.definitions, name) != claim.definitions.end();
  });
}

// Each parameter, and how many claims hold for all that it may be.
std::string parameters(const FileRun& file) {
  const std::vector<const ClaimRun*> all = claims(file);
  std::string result;
  for (const ItemRun& item : file.items) {
    const auto* definition = std::get_if<DefinitionRun>(&item);
    if (!definition || !definition->is_parameter) continue;
    const auto count = std::ranges::count_if(
        all, [&](const ClaimRun* claim) { return speaks_of(*claim, *definition); });
    if (count == 0) continue;
    result += latex_call("SeamFormula",
                         {mathematics(definition->latex) + "\\qquad\\text{\\SeamQuiet{in " +
                          counted(static_cast<int>(count), "claim", "claims") + "}}"});
  }
  if (result.empty()) return "";
  return "Parameters: a claim holds for all that they may be.\\par\\nobreak\n"
         "\\begin{SeamIndent}\n" +
         result + "\\end{SeamIndent}\n";
}

// Guards by what became of them; those that do not hold with their claims.
std::string guards(const FileRun& file) {
  int proven = 0;
  std::string others;
  for (const ClaimRun* claim : claims(file))
    for (const Outcome* outcome :
         {&claim->printed, claim->corrected ? &*claim->corrected : nullptr}) {
      if (!outcome) continue;
      for (const ObligationRun& guard : outcome->obligations) {
        if (!guard.guard) continue;
        if (guard.status == ObligationRun::Status::holds) {
          ++proven;
          continue;
        }
        const bool fails = guard.status == ObligationRun::Status::fails;
        others += latex_call(
            "SeamObligation",
            {fails ? "fails" : "open",
             latex_claim_link(*claim) + "\\quad " +
                 escape(guard.about.empty() ? guard.text : guard.about + ": " + guard.text),
             ""});
      }
    }
  if (proven == 0 && others.empty()) return "";
  std::string result =
      counted(proven, "condition under which the formulas mean something was",
              "conditions under which the formulas mean something were") +
      " proven with the claims: divisors that are not 0, radicands that are not negative, what "
      "the numbers are.\\par\n";
  if (!others.empty())
    result +=
        "These were not, and what rests on them is not decided:\\par\\nobreak\n"
        "\\begin{SeamConditions}\n" +
        others + "\\end{SeamConditions}\n";
  return result;
}

std::string uses(const FileRun& file) {
  const std::vector<const ClaimRun*> all = claims(file);
  std::string result;
  for (const ClaimRun* claim : all) {
    std::vector<std::string> used;
    for (const std::string& id : claim->using_claims) {
      const auto found = std::ranges::find(all, id, &ClaimRun::id);
      used.push_back(found == all.end()
                         ? "\\texttt{" + escape(id) + "}"
                         : "\\SeamMark{" + std::string(word((*found)->printed.verdict)) + "}" +
                               latex_claim_link(**found));
    }
    if (!used.empty())
      result += "\\SeamMark{" + std::string(word(claim->printed.verdict)) + "}" +
                latex_claim_link(*claim) + " \\SeamQuiet{rests on} " + joined(used, ", ") +
                "\\par\n";
  }
  if (result.empty()) return "";
  return "Claims that rest on others; where one of those is not proven, they are at best "
         "conditional.\\par\\nobreak\n\\begin{SeamIndent}\\raggedright\n" +
         result + "\\end{SeamIndent}\n" + latex_graph(file);
}

}  // namespace

std::string latex_assumptions(const FileRun& file) {
  const std::string all = parameters(file) + guards(file) + uses(file);
  return all.empty() ? "" : latex_heading("What the verdicts rest on") + all;
}

}  // namespace seam::report
