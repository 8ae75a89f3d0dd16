// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_assumptions.h"

#include "report/assumptions.h"
#include "report/html_escape.h"
#include "report/html_parts.h"

namespace seam::report {
namespace {

std::string counted(int n, const std::string& one, const std::string& several) {
  return std::to_string(n) + " " + (n == 1 ? one : several);
}

std::string listed(const std::string& words, const std::string& items) {
  return items.empty() ? "" : html_element("p", words) + html_element("ul", items) + "\n";
}

std::string parameters(const Assumptions& all) {
  std::string items;
  for (const auto& [definition, claims] : all.parameters)
    items += html_element("li", html_formula(definition->latex) +
                                    html_element("span class=\"quiet\"",
                                                 "in " + counted(claims, "claim", "claims")));
  return listed("Parameters: a claim holds for all that they may be.", items);
}

std::string guards(const Assumptions& all) {
  std::string items;
  for (const auto& [claim, guard] : all.guards_not_proven)
    items +=
        html_element("li", html_link(claim->id) + " " +
                               html_escape(guard->about.empty() ? "" : guard->about + ": ") +
                               html_code(guard->text));
  const std::string proven =
      all.guards_proven == 0
          ? ""
          : html_element(
                "p", counted(all.guards_proven,
                             "condition under which the formulas mean something was",
                             "conditions under which the formulas mean something were") +
                         " proven with the claims: divisors that are not 0, radicands that are "
                         "not negative, what the numbers are.");
  return proven + listed("These were not, and what rests on them is not decided:", items);
}

std::string uses(const Assumptions& all) {
  std::string items;
  for (const Assumptions::Use& use : all.uses) {
    std::vector<std::string> used;
    for (const auto& [id, claim] : use.rests_on)
      used.push_back(claim ? html_mark(claim->printed.verdict) + " " + html_link(id)
                           : html_code(id));
    items += html_element("li", html_mark(use.claim->printed.verdict) + " " +
                                    html_link(use.claim->id) + " rests on " + html_list(used));
  }
  return listed(
      "Claims that rest on others; where one of those is not proven, they are at best "
      "conditional:",
      items);
}

}  // namespace

std::string html_assumptions(const FileRun& file) {
  const Assumptions all = assumptions(file);
  return all.empty() ? ""
                     : html_section("assumptions", assumptions_title,
                                    parameters(all) + guards(all) + uses(all));
}

}  // namespace seam::report
