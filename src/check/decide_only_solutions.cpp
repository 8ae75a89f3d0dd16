// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <algorithm>

#include "check/elimination.h"
#include "check/point.h"
#include "check/rules.h"
#include "check/system.h"

// Functions are further coordinates of a point, and its values of them are the roots that they
// are. A point of the domain that meets the conditions, solves the system and is none of the
// solutions refutes; an elimination proves.

namespace seam::check {
namespace {

using certificate::OnlySolutions;

SystemOfEquations read(Context& context, const OnlySolutions& stated) {
  std::vector<certificate::Term> terms = stated.system;
  for (const auto& condition : stated.domain.where) terms.push_back(condition.formula);
  for (const auto& [numerators, denominators] : stated.solutions)
    for (const auto* held : {&numerators, &denominators})
      terms.insert(terms.end(), held->begin(), held->end());
  SystemOfEquations system;
  system.functions = context.functions(std::move(terms));
  system.domain = make_region(context, {stated.domain.factors, {}}, {});
  // Throws where a function is of other variables than the domain's.
  std::set<int> parameters =
      variables(with_functions(context, system.domain, system.functions));
  system.variables = parameters;
  demand(!context.variables(stated.unknowns).empty(), "degenerate: no unknown");
  for (const std::string& name : stated.unknowns) {
    const int unknown = context.variable(name);
    if (system.variables.insert(unknown).second) system.unbounded.push_back(unknown);
    parameters.erase(unknown);
  }
  for (const auto& [formula, relation] : stated.domain.where) {
    system.domain.where.push_back({context.value(formula), relation});
    demand(context.depends_only_on(system.domain.where.back().formula, system.variables),
           "degenerate: a variable outside the domain");
  }
  system.equations = read_system(context, stated.system, stated.for_all, system.variables);
  for (const auto& [numerators, denominators] : stated.solutions) {
    auto& solution = system.solutions.emplace_back();
    for (std::size_t j = 0; j < numerators.size(); ++j) {
      const Polynomial numerator = context.value(numerators[j]);
      const Polynomial denominator = context.value(denominators[j]);
      demand(context.depends_only_on(numerator, parameters) &&
                 context.depends_only_on(denominator, parameters),
             "degenerate: a solution holds more than parameters");
      const Polynomial x = symbol(context.variable(stated.unknowns[j]));
      solution.push_back(
          context.ring().difference(context.ring().product(denominator, x), numerator));
    }
  }
  return system;
}

bool refutes(Context& context, const SystemOfEquations& system, const Point& point) {
  const auto sign_at = [&](const Polynomial& formula) {
    return context.tower().sign(value_at(context, formula, point));
  };
  demand_inside(context, system.domain, system.functions, point);
  return std::ranges::all_of(system.equations,
                             [&](const Polynomial& f) { return sign_at(f) == 0; }) &&
         std::ranges::all_of(system.solutions, [&](const std::vector<Polynomial>& solution) {
           return std::ranges::any_of(solution,
                                      [&](const Polynomial& f) { return sign_at(f) != 0; });
         });
}

}  // namespace

bool decide(Context& context, const OnlySolutions& stated, const certificate::Proof& proof) {
  const SystemOfEquations system = read(context, stated);
  if (const auto* witness = std::get_if<certificate::Witness>(&proof)) {
    demand(refutes(context, system, read_point(context, witness->point)),
           "the witness is no solution, or one of those that are stated");
    return false;
  }
  const auto* elimination = std::get_if<certificate::Elimination>(&proof);
  demand(elimination != nullptr, "evidence of a kind that says nothing of solutions");
  verify(context, system, *elimination);
  return true;
}

}  // namespace seam::check
