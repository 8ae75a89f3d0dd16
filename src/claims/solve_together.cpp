// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/solving.h"

// Each claimed solution solves the system and meets the conditions, for all values of the
// parameters: that is said by putting it in. That there is no other is one obligation, and one
// for each choice of sides of 0 of the parameters without a set.

namespace seam::claims {
namespace {

using symbolic::Constraint;
using symbolic::Simplex;
using Tuple = std::vector<Scalar>;

bool same(const Scalar& a, const Scalar& b) {
  return a.numerator.same(b.numerator) && a.denominator.same(b.denominator);
}

class Together {
 public:
  explicit Together(const Solving& solving) : solving_(solving), stating_(solving.stating) {}

  Proposition state() {
    read_sets();
    read_conditions();
    if (solving_.at.text == "one") return one();
    for (const Expression& solution : solving_.solutions()) read(solution);
    std::vector<Proposition> parts;
    for (std::size_t k = 0; k < tuples_.size(); ++k) put_in(k, parts);
    no_other(parts);
    return symbolic::all(std::move(parts));
  }

 private:
  void read_sets() {
    context_ = solving_.around;
    for (std::size_t j = 0; j < solving_.unknowns.size(); ++j) {
      const std::string& unknown = solving_.unknowns[j];
      if (!solving_.sets[j]) {
        context_.lines.push_back(unknown);
        continue;
      }
      factors_.push_back(
          solving_.evaluator().continuous_set(*solving_.sets[j], {unknown}, solving_.scope));
      context_.factors.push_back(factors_.back());
      bound(unknown, factors_.back());
    }
  }

  // Where the unknown lies, as conditions to be met by what is put in for it: it is at one side
  // of each end.
  void bound(const std::string& unknown, const Simplex& set) {
    const Formula x = Formula::symbol(unknown);
    for (const int side : {0, 1}) {
      const auto &corner = set.corners[side], &other = set.corners[1 - side];
      if (corner[0].is(0)) continue;
      const Formula end = corner[1], towards = other[1] - other[0] * end;
      const bool rising = solving_.evaluator().numbers.sign(towards) == exact::Sign::positive;
      const bool open = set.open[1 - side];  // facet i lies opposite corner i
      bounds_.push_back(
          {rising ? x - end : end - x, open ? Relation::positive : Relation::nonnegative});
    }
  }

  void read_conditions() {
    equations_ = solving_.equations;
    for (const Expression* condition : solving_.conditions) {
      const auto where = stating_.constraints(*condition, solving_.scope, context_, true);
      if (!where)
        throw Unsupported("a condition of 'solve' that is no conjunction of comparisons");
      for (const Constraint& c : *where)
        if (c.relation == Relation::zero)
          equations_.push_back(c.formula);
        else
          conditions_.push_back(c);
    }
  }

  Proposition one() {
    if (factors_.size() != solving_.unknowns.size())
      throw Unsupported("'gives one' where an unknown ranges over all reals");
    symbolic::OneSolution stated{
        equations_, solving_.unknowns, solving_.for_all, {factors_, conditions_}, {}};
    std::set<std::string> parameters;
    for (const Formula& f : equations_) parameters.merge(symbolic::variables(f));
    for (const Constraint& c : conditions_) parameters.merge(symbolic::variables(c.formula));
    for (const auto* bound : {&solving_.unknowns, &solving_.for_all})
      for (const std::string& symbol : *bound) parameters.erase(symbol);
    if (!parameters.empty() || !solving_.around.where.empty())
      throw Unsupported("'gives one' with parameters");
    if (solving_.solutions().empty())
      throw Unsupported("'gives one' without a printed value ('gives one ~ 0.617')");
    const Expression& printed = solving_.solutions().front();
    if (solving_.unknowns.size() == 1) {
      stated.near.push_back(printed_range(printed));
    } else {
      if (printed.kind != Expression::Kind::tuple ||
          printed.children.size() != solving_.unknowns.size())
        fail(printed, "a solution has one value for each unknown, here " +
                          std::to_string(solving_.unknowns.size()));
      for (const Expression& entry : printed.children)
        stated.near.push_back(printed_range(entry));
    }
    return symbolic::atom(std::move(stated), "this solution and no other");
  }

  void read(const Expression& solution) {
    const Value value = solving_.evaluator().evaluate(solution, solving_.scope);
    Tuple tuple;
    if (solving_.unknowns.size() == 1 && value.as<Scalar>())
      tuple = {*value.as<Scalar>()};
    else
      tuple = as_vector(solving_.evaluator(), value, solution);
    if (tuple.size() != solving_.unknowns.size())
      fail(solution, "a solution has one value for each unknown, here " +
                         std::to_string(solving_.unknowns.size()));
    for (const Scalar& entry : tuple)
      for (const Formula& f : {entry.numerator, entry.denominator})
        for (const std::string& v : symbolic::variables(f))
          if (std::ranges::find(solving_.unknowns, v) != solving_.unknowns.end())
            fail(solution, "a solution cannot hold an unknown");
    for (const Tuple& other : tuples_)
      if (std::ranges::equal(tuple, other, same))
        fail(solution, "this solution is given twice");
    tuples_.push_back(std::move(tuple));
  }

  void put_in(std::size_t k, std::vector<Proposition>& parts) {
    const Expression& at = solving_.solutions()[k];
    std::map<std::string, Scalar> values;
    for (std::size_t j = 0; j < solving_.unknowns.size(); ++j)
      values.emplace(solving_.unknowns[j], tuples_[k][j]);
    Context with_lines = solving_.around;
    with_lines.lines.insert(with_lines.lines.end(), solving_.for_all.begin(),
                            solving_.for_all.end());
    const auto demand = [&](const Formula& f, Relation relation, const Context& context,
                            const char* about) {
      Numbers& numbers = solving_.evaluator().numbers;
      const Scalar value = substitute(scalar_of(f, numbers), values, numbers);
      const Constraint c = stating_.related(value, relation, context, at);
      parts.push_back(stating_.holds(c.formula, c.relation, context, at, about));
    };
    for (const Formula& f : equations_)
      demand(f, Relation::zero, with_lines, "it solves the system");
    for (const Constraint& c : conditions_)
      demand(c.formula, c.relation, solving_.around, "it meets the conditions");
    for (const Constraint& c : bounds_)
      demand(c.formula, c.relation, solving_.around, "it lies in the domain");
    // What is divided by, also where the system does not hold the unknown.
    for (const Scalar& entry : tuples_[k]) stating_.guard(entry, solving_.around, at);
  }

  void no_other(std::vector<Proposition>& parts) {
    symbolic::OnlySolutions only{equations_, solving_.unknowns, solving_.for_all, {}, {}};
    std::set<std::string> parameters;
    const auto mention = [&](const Formula& f) { parameters.merge(symbolic::variables(f)); };
    std::ranges::for_each(equations_, mention);
    for (const Constraint& c : conditions_) mention(c.formula);
    for (const Tuple& tuple : tuples_) {
      auto& solution = only.solutions.emplace_back();
      for (const Scalar& entry : tuple) {
        solution.emplace_back(entry.numerator, entry.denominator);
        mention(entry.numerator);
        mention(entry.denominator);
      }
    }
    for (const auto* bound : {&solving_.unknowns, &solving_.for_all})
      for (const std::string& symbol : *bound) parameters.erase(symbol);
    for (symbolic::Domain& domain :
         stating_.domains(parameters, solving_.around, solving_.at)) {
      domain.factors.insert(domain.factors.end(), factors_.begin(), factors_.end());
      domain.where.insert(domain.where.end(), conditions_.begin(), conditions_.end());
      only.domain = std::move(domain);
      parts.push_back(symbolic::atom(only, "these solutions and no other"));
    }
  }

  const Solving& solving_;
  Stating& stating_;
  Context context_;  // of the unknowns
  std::vector<Simplex> factors_;
  std::vector<Constraint> bounds_, conditions_;
  std::vector<Formula> equations_;
  std::vector<Tuple> tuples_;
};

}  // namespace

Proposition solved_together(const Solving& solving) {
  return Together(solving).state();
}

}  // namespace seam::claims
