// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/elimination.h"

#include <memory>
#include <utility>

#include "check/relation.h"
#include "check/rules.h"

// Why a tree that is accepted leaves no other solution.
//
//   Take any point of the domain that meets its conditions and at which the system vanishes.
//   At the root of the tree all that is known holds at it. Where all that is known holds at the
//   point and a step follows:
//
//   product: the combination is 0 there, hence one of the factors is; not one that a condition
//   or
//     trees show to be different from 0. So it is a case: all that is known in that child
//     holds.
//   cases: one of the two children is about it.
//   outside: multiplier * f = 0 + remainder with multiplier > 0, so f has the sign of the
//     remainder and breaks its condition. There is no such point.
//   solution: it is that solution.
//
//   So the point is led down to a leaf `solution`. Each step of the evidence is taken once.
//
// What is known in a child is what was known before and one thing more: a list that shares its
// beginning. Lists are bounded in length, for they are taken apart one by one.

namespace seam::check {
namespace {

using certificate::Combination;
using certificate::Elimination;
using certificate::EliminationFactor;
using certificate::EliminationStep;
using certificate::Relation;
using certificate::SignProof;

constexpr std::size_t most_known = 2000;
constexpr std::size_t most_unbounded = 6;  // take 2^6 trees

// One thing more that is known: an equation, or a condition.
struct Known;
using KnownPtr = std::shared_ptr<const Known>;
struct Known {
  KnownPtr before;
  Condition fact;
};

class Walk {
 public:
  Walk(Context& context, const SystemOfEquations& system)
      : context_(context), system_(system) {}

  void run(const Elimination& elimination) {
    std::vector<KnownPtr> tasks = {nullptr};
    for (const EliminationStep& step : elimination.steps) {
      demand(!tasks.empty(), "the elimination has steps too many");
      const KnownPtr known = std::move(tasks.back());
      tasks.pop_back();
      recall(known);
      const std::vector<Condition> children = take(step);
      for (auto fact = children.rbegin(); fact != children.rend(); ++fact)
        tasks.push_back(std::make_shared<const Known>(Known{known, *fact}));
    }
    demand(tasks.empty(), "the elimination lacks a case");
  }

 private:
  void recall(const KnownPtr& known) {
    std::vector<const Condition*> facts;
    std::size_t held = 0;
    for (const Known* k = known.get(); k != nullptr; k = k->before.get()) {
      facts.push_back(&k->fact);
      demand(facts.size() <= most_known, "effort");
      demand((held += words(k->fact.formula)) <= Meter::max_words, "effort");
    }
    context_.meter().charge(facts.size() + system_.equations.size());
    equations_.clear();
    conditions_.clear();
    for (const Polynomial& f : system_.equations) equations_.push_back(&f);
    for (const Condition& c : system_.domain.where) conditions_.push_back(&c);
    for (auto fact = facts.rbegin(); fact != facts.rend(); ++fact) {
      if ((*fact)->relation == Relation::zero)
        equations_.push_back(&(*fact)->formula);
      else
        conditions_.push_back(*fact);
    }
  }

  // What is known beside in each child.
  std::vector<Condition> take(const EliminationStep& step) {
    switch (step.kind) {
      case EliminationStep::Kind::product:
        return product(step);
      case EliminationStep::Kind::cases: {
        const Polynomial formula = read(step.formula);
        return {{formula, Relation::zero}, {formula, Relation::nonzero}};
      }
      case EliminationStep::Kind::solution:
        verify_solution(step);
        return {};
      case EliminationStep::Kind::outside:
        verify_outside(step);
        return {};
    }
    throw Open("malformed: an unknown kind of step");
  }

  std::vector<Condition> product(const EliminationStep& step) {
    Ring& ring = context_.ring();
    std::vector<Condition> children;
    Polynomial all = constant(1);
    for (const EliminationFactor& factor : step.factors) {
      const Polynomial formula = read(factor.formula);
      all = ring.product(all, ring.power(formula, factor.power));
      if (factor.condition >= 0) {
        const Condition& condition = this->condition(factor.condition);
        demand(!holds(condition.relation, 0) &&
                   ring.difference(condition.formula, formula).is_zero(),
               "no condition says that a factor is not 0");
      } else if (!factor.trees.empty()) {
        verify_trees(formula, Relation::nonzero, factor.trees);
      } else {
        children.push_back({formula, Relation::zero});
      }
    }
    demand(ring.difference(combined(step.combination), all).is_zero(),
           "a combination of equations is not the product it is said to be");
    return children;
  }

  void verify_solution(const EliminationStep& step) {
    demand(std::cmp_less(step.index, system_.solutions.size()), "a solution that is none");
    const auto& wanted = system_.solutions[static_cast<std::size_t>(step.index)];
    demand(step.equations.size() == wanted.size(), "not one equation for each unknown");
    for (std::size_t j = 0; j < wanted.size(); ++j)
      demand(context_.ring().difference(equation(step.equations[j]), wanted[j]).is_zero(),
             "an equation does not say what an unknown is");
  }

  void verify_outside(const EliminationStep& step) {
    Ring& ring = context_.ring();
    const Condition& condition = this->condition(step.index);
    const Polynomial multiplier = read(step.formula);
    const Polynomial remainder = read(step.remainder);
    const Polynomial right = ring.sum(combined(step.combination), remainder);
    demand(ring.difference(ring.product(multiplier, condition.formula), right).is_zero(),
           "a condition is not the combination it is said to be");
    verify_trees(multiplier, Relation::positive, step.positive);
    verify_trees(remainder, complement(condition.relation), step.broken);
  }

  // From both sides of 0 in each unbounded unknown that the formula holds.
  void verify_trees(const Polynomial& formula, Relation relation,
                    const std::vector<SignProof>& trees) {
    Region whole = {system_.domain.factors, {}};
    int next = context_.free_symbol();
    for (const Factor& factor : whole.factors) next += static_cast<int>(factor.corners.size());
    std::vector<int> halved;
    for (const int x : system_.unbounded)
      if (degree(formula, x) > 0) halved.push_back(x);
    demand(halved.size() <= most_unbounded && trees.size() == std::size_t{1} << halved.size(),
           "not one tree for each side of 0 of each unknown");
    for (std::size_t sides = 0; sides < trees.size(); ++sides) {
      Region region = whole;
      for (std::size_t j = 0; j < halved.size(); ++j) {
        const Polynomial direction = constant((sides >> j & 1) != 0 ? 1 : -1);
        region.factors.push_back(make_factor(
            context_, {halved[j]}, {{constant(1), constant(0)}, {constant(0), direction}},
            {false, false}, next + 2 * static_cast<int>(j)));
      }
      std::set<int> bound = variables(region);
      bound.insert(system_.functions.begin(), system_.functions.end());
      for (const Condition* condition : conditions_)
        if (context_.depends_only_on(condition->formula, bound))
          region.where.push_back(*condition);
      region = with_functions(context_, std::move(region), system_.functions);
      verify(context_, region, formula, relation, trees[sides]);
    }
  }

  Polynomial read(certificate::Term term) {
    Polynomial formula = context_.value(term);
    demand(context_.depends_only_on(formula, system_.variables),
           "a variable outside the system");
    return formula;
  }

  Polynomial combined(const Combination& combination) {
    Polynomial total;
    for (std::size_t i = 0; i < combination.equations.size(); ++i)
      total = context_.ring().sum(
          total, context_.ring().product(context_.value(combination.cofactors[i]),
                                         equation(combination.equations[i])));
    return total;
  }

  const Polynomial& equation(int index) const {
    demand(index >= 0 && std::cmp_less(index, equations_.size()), "an equation that is none");
    return *equations_[static_cast<std::size_t>(index)];
  }
  const Condition& condition(int index) const {
    demand(std::cmp_less(index, conditions_.size()), "a condition that is none");
    return *conditions_[static_cast<std::size_t>(index)];
  }

  Context& context_;
  const SystemOfEquations& system_;
  std::vector<const Polynomial*> equations_;  // known at the present step
  std::vector<const Condition*> conditions_;
};

}  // namespace

void verify(Context& context, const SystemOfEquations& system, const Elimination& elimination) {
  Walk(context, system).run(elimination);
}

}  // namespace seam::check
