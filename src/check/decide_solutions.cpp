// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <algorithm>
#include <optional>
#include <utility>

#include "check/point.h"
#include "check/relation.h"
#include "check/rules.h"
#include "check/system.h"

// Why the roots in the domain are those claimed.
//
//   For a real x every formula of the system vanishes for all real values of `for_all` exactly
//   when all its coefficients F with respect to these variables do. The F are multiples of the
//   divisor, and it is a combination of them: x is a solution exactly when it is a root of the
//   divisor.
//
//   Exact solutions: divisor = rest * product (x - s)^m with rest != 0 on the domain.
//   Intervals: the divisor has opposite strict signs at the ends of each, and its derivative
//   does not vanish in between: one root. The rest of the domain consists of the parts between
//   and beside them, on which the divisor is not 0.

namespace seam::check {
namespace {

using certificate::Pieces;
using certificate::Relation;
using certificate::Roots;
using certificate::Solution;
using certificate::Solutions;
using certificate::Term;
using certificate::WrongSolution;

// The system as polynomials in the unknown, and the domain of the unknown.
struct Problem {
  int unknown;
  std::vector<Polynomial> system;  // F1, F2, ...
  std::optional<Factor> domain;    // none: every real number
};

// An end of the domain, and whether it is left out.
struct End {
  Coordinates corner;
  bool open;
};

Coordinates at(const Polynomial& x) {
  return {constant(1), x};
}
Coordinates at_infinity(int direction) {
  return {constant(0), constant(direction)};
}

// det ((w0, x0), (w1, x1)) = w0 x1 - x0 w1 > 0 says that corner 0 is the left one; facet i is
// the end opposite to corner i.
std::pair<End, End> ends(const Problem& problem) {
  if (!problem.domain) return {{at_infinity(-1), false}, {at_infinity(1), false}};
  const Factor& domain = *problem.domain;
  const std::size_t left = domain.orientation > 0 ? 0 : 1;
  const std::size_t right = 1 - left;
  return {{domain.corners[left], domain.open[right]},
          {domain.corners[right], domain.open[left]}};
}

Problem read_problem(Context& context, const Solutions& stated) {
  Problem problem{context.variable(stated.unknown), {}, {}};
  demand(stated.domain.variables == std::vector{stated.unknown},
         "degenerate: the domain is not one of the unknown");
  if (!stated.domain.corners.empty())
    problem.domain = make_region(context, {{stated.domain}, {}}).factors.front();
  demand(context.functions(stated.system).empty(), "unsupported: a system with functions");
  problem.system = read_system(context, stated.system, stated.for_all, {problem.unknown});
  return problem;
}

bool is_in_domain(Context& context, const Problem& problem, const Polynomial& x) {
  return !problem.domain || contains(context, *problem.domain, {x});
}

bool is_solution(Context& context, const Problem& problem, const Polynomial& x) {
  return std::ranges::all_of(problem.system, [&](const Polynomial& f) {
    return context.tower().sign(context.ring().substitute(f, problem.unknown, x)) == 0;
  });
}

Polynomial read_divisor(Context& context, const Problem& problem, const Roots& roots) {
  Ring& ring = context.ring();
  demand(roots.cofactors.size() == problem.system.size() &&
             roots.quotients.size() == problem.system.size(),
         "not one cofactor and quotient for each coefficient of the system");
  Polynomial divisor = context.value(roots.divisor);
  demand(context.depends_only_on(divisor, {problem.unknown}),
         "a divisor in other variables than the unknown");
  Polynomial combination;
  for (std::size_t i = 0; i < problem.system.size(); ++i) {
    const Polynomial cofactor = context.value(roots.cofactors[i]);
    const Polynomial quotient = context.value(roots.quotients[i]);
    demand(context.depends_only_on(cofactor, {problem.unknown}) &&
               context.depends_only_on(quotient, {problem.unknown}),
           "a cofactor or quotient in other variables than the unknown");
    combination = ring.sum(combination, ring.product(cofactor, problem.system[i]));
    demand(ring.difference(ring.product(quotient, divisor), problem.system[i]).is_zero(),
           "a coefficient of the system is not its quotient times the divisor");
  }
  demand(ring.difference(combination, divisor).is_zero(),
         "the divisor is not the combination it is said to be");
  return divisor;
}

// Proves `formula` != 0 from one end to another.
void verify_between(Context& context, const Problem& problem, const Polynomial& formula,
                    const End& low, const End& high, const Pieces& pieces) {
  const Region segment{{make_factor(context, {problem.unknown}, {low.corner, high.corner},
                                    {high.open, low.open}, context.free_symbol())},
                       {}};
  verify(context, segment, formula, Relation::nonzero, pieces);
}

void verify_exact(Context& context, const Problem& problem, const Polynomial& divisor,
                  const std::vector<Solution>& solutions, const Roots& roots) {
  Ring& ring = context.ring();
  demand(roots.multiplicities.size() == solutions.size(), "not one multiplicity for each root");
  demand(roots.inside.empty() && roots.outside.size() == (problem.domain ? 1u : 2u),
         "exact roots take one tree, or two over all numbers");
  const Polynomial rest = context.value(roots.rest);
  demand(context.depends_only_on(rest, {problem.unknown}),
         "a rest in other variables than the unknown");
  Polynomial product = rest;
  std::vector<Polynomial> known;
  for (std::size_t j = 0; j < solutions.size(); ++j) {
    const Polynomial x = context.number(solutions[j].value);
    demand(is_in_domain(context, problem, x), "a root lies outside the domain");
    for (const Polynomial& other : known)
      demand(context.tower().sign(ring.difference(x, other)) != 0, "two roots are one");
    known.push_back(x);
    demand(roots.multiplicities[j] >= 1, "a multiplicity below 1");
    product = ring.product(product, ring.power(ring.difference(symbol(problem.unknown), x),
                                               roots.multiplicities[j]));
  }
  demand(ring.difference(product, divisor).is_zero(), "the divisor is not the stated product");
  if (problem.domain) {
    verify(context, {{*problem.domain}, {}}, rest, Relation::nonzero, roots.outside.front());
    return;
  }
  const End zero{at(constant(0)), false};
  verify_between(context, problem, rest, zero, {at_infinity(1), false}, roots.outside[0]);
  verify_between(context, problem, rest, {at_infinity(-1), false}, zero, roots.outside[1]);
}

// A part between two ends that are one point needs no proof: the divisor has a sign there.
void verify_intervals(Context& context, const Problem& problem, const Polynomial& divisor,
                      const std::vector<Solution>& solutions, const Roots& roots) {
  Ring& ring = context.ring();
  demand(
      roots.inside.size() == solutions.size() && roots.outside.size() == solutions.size() + 1,
      "not one tree for each interval and each part between and beside them");
  const Polynomial slope = derivative(divisor, problem.unknown, context.meter());
  const auto sign_at = [&](const Polynomial& x) {
    return context.tower().sign(ring.substitute(divisor, problem.unknown, x));
  };
  const auto verify_part = [&](const End& low, const End& high, const Pieces& pieces) {
    const int order = context.tower().sign(determinant(ring, {low.corner, high.corner}));
    demand(order >= 0, "intervals overlap, or do not ascend");
    if (order > 0) verify_between(context, problem, divisor, low, high, pieces);
  };
  auto [reached, last] = ends(problem);
  for (std::size_t j = 0; j < solutions.size(); ++j) {
    const Polynomial low = context.rational(solutions[j].low);
    const Polynomial high = context.rational(solutions[j].high);
    demand(context.tower().sign(ring.difference(high, low)) > 0, "an interval is empty");
    demand(is_in_domain(context, problem, low) && is_in_domain(context, problem, high),
           "an interval leaves the domain");
    demand(sign_at(low) * sign_at(high) < 0, "no change of sign over an interval");
    verify_part(reached, {at(low), false}, roots.outside[j]);
    verify_between(context, problem, slope, {at(low), false}, {at(high), false},
                   roots.inside[j]);
    reached = {at(high), false};
  }
  verify_part(reached, last, roots.outside.back());
}

bool is_exact(const Solution& solution) {
  return solution.value >= 0;
}

bool is_wrong(Context& context, const Problem& problem, const std::vector<Solution>& solutions,
              const WrongSolution& wrong) {
  if (wrong.claimed >= 0) {
    demand(std::cmp_less(wrong.claimed, solutions.size()), "a claimed solution that is none");
    const Solution& claimed = solutions[static_cast<std::size_t>(wrong.claimed)];
    demand(is_exact(claimed), "an interval is not refuted by a value");
    const Polynomial x = context.number(claimed.value);
    return !is_in_domain(context, problem, x) || !is_solution(context, problem, x);
  }
  const Polynomial x = context.number(wrong.value);
  const auto sign_of_difference = [&](const Polynomial& other) {
    return context.tower().sign(context.ring().difference(x, other));
  };
  return is_in_domain(context, problem, x) && is_solution(context, problem, x) &&
         std::ranges::all_of(solutions, [&](const Solution& claimed) {
           if (is_exact(claimed)) return sign_of_difference(context.number(claimed.value)) != 0;
           return sign_of_difference(context.rational(claimed.low)) < 0 ||
                  sign_of_difference(context.rational(claimed.high)) > 0;
         });
}

}  // namespace

bool decide(Context& context, const Solutions& stated, const certificate::Proof& proof) {
  const Problem problem = read_problem(context, stated);
  const auto& solutions = stated.solutions;
  if (const auto* wrong = std::get_if<WrongSolution>(&proof)) {
    demand(is_wrong(context, problem, solutions, *wrong), "no solution is wrong or missing");
    return false;
  }
  const auto* roots = std::get_if<Roots>(&proof);
  demand(roots != nullptr, "evidence of a kind that says nothing of solutions");
  const Polynomial divisor = read_divisor(context, problem, *roots);
  if (std::ranges::all_of(solutions, is_exact)) {
    verify_exact(context, problem, divisor, solutions, *roots);
  } else {
    demand(std::ranges::none_of(solutions, is_exact),
           "unsupported: exact solutions beside intervals");
    verify_intervals(context, problem, divisor, solutions, *roots);
  }
  return true;
}

}  // namespace seam::check
