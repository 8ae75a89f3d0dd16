// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/induction.h"

#include <algorithm>
#include <utility>

#include "claims/parameters.h"
#include "symbolic/coefficients.h"

// A statement S(n) for every integer n from a on is
//
//   S(a), ..., S(m)                              each for itself, the base, and
//   for all n >= m: S(n) implies S(n + 1)        the step.
//
// In the step n is any real number >= m, a power p^n any number >= p^m, and the value of a
// sequence at n any real number at all: more than there is, so the step may fail where the
// statement holds. Hence it suffices, and refutes nothing; one of S(a), ..., S(m) that fails
// does. Of S(n), where it is a conjunction of comparisons, inequalities are conditions of the
// step; an equation gives the value of a sequence, which is put in, or is not used. Using less
// is always right.
//
// With an upper end alone, or none, the step goes downwards too. Other integer parameters are
// numbers in the base, in turn, and in the step any real number of their range: if it holds
// for each of them, S(n, k) implies S(n + 1, k) for each k. A condition that holds both
// says another thing of k at n and at n + 1; then S(n) is not used.

namespace seam::claims {
namespace {

using symbolic::Constraint;

constexpr long base_size = 8;        // instances before the step
constexpr long inner_base_size = 3;  // of a parameter inside that of another

// Puts the words in front of what each part is about.
void prefix(Proposition& p, const std::string& words) {
  if (!p.about.empty()) p.about = words + ": " + p.about;
  for (Proposition& part : p.parts) prefix(part, words);
}
void label(Proposition& p, const std::string& words) {
  prefix(p, words);
  if (p.about.empty()) p.about = words;
}

class Induction {
 public:
  Induction(Evaluator& evaluator, const Expression& statement, const Scope& scope,
            std::string parameter)
      : evaluator_(evaluator),
        statement_(statement),
        scope_(scope),
        parameter_(std::move(parameter)),
        range_(integer_range(evaluator, parameter_)),
        size_(evaluator.integers.values.empty() ? base_size : inner_base_size) {}

  Stated run() {
    if (range_.low && range_.high) {
      long& room = evaluator_.integers.room;
      const long size = std::max(1L, *range_.high - *range_.low + 1);
      if (size > room)
        throw Unsupported("integer parameters with more than a thousand values in all");
      const long outer = std::exchange(room, room / size);
      for (long i = *range_.low; i <= *range_.high; ++i) instance(i, "");
      room = outer;
    } else {
      const long first = range_.low ? *range_.low : range_.high ? *range_.high : 0;
      if (range_.low || !range_.high) ascend(first, 1);
      if (!range_.low) ascend(range_.high ? first : -1, -1);
    }
    if (!met_) throw Unsupported("no integer was found that meets the condition");
    result_.goal = symbolic::all(std::move(parts_));
    return std::move(result_);
  }

 private:
  std::string at(long i) const { return parameter_ + " = " + std::to_string(i); }

  bool meets(long i) const {
    return std::ranges::all_of(range_.rest, [&](const Constraint& c) {
      const Formula value = symbolic::subst(c.formula, {{parameter_, Formula(i)}});
      if (!symbolic::is_number(value))
        throw Unsupported("a condition with several integer parameters");
      return claims::meets(evaluator_.numbers.sign(value), c.relation);
    });
  }

  void instance(long i, const std::string& words) {
    if (!meets(i)) return;
    met_ = true;
    const Assigned value(evaluator_, parameter_, Scalar(i));
    Stated here;
    try {
      here = range_.others.empty()
                 ? state(evaluator_, statement_, scope_)
                 : for_every_integer(evaluator_, statement_, scope_, *range_.others.begin());
    } catch (const Problem& problem) {
      throw Unsupported("for " + at(i) + ": " + problem.what());
    }
    label(here.goal, words + at(i));
    for (Proposition& guard : here.guards) label(guard, words + at(i));
    parts_.push_back(std::move(here.goal));
    std::ranges::move(here.guards, std::back_inserter(result_.guards));
    result_.predicates.merge(here.predicates);
  }

  // Nothing in it is another for another value of the parameter.
  bool is_free(const Proposition& p) const {
    if (p.kind != Proposition::Kind::atom)
      return std::ranges::all_of(p.parts, [this](const auto& part) { return is_free(part); });
    if (std::holds_alternative<symbolic::Solutions>(p.atom) ||
        std::holds_alternative<symbolic::OneSolution>(p.atom))
      return false;
    return std::ranges::none_of(variables_of(p), [this](const std::string& v) {
      return v == parameter_ || v.ends_with("^" + parameter_) ||
             evaluator_.integers.opaque.contains(v);
    });
  }

  // What comes out the same for every value from the first on needs no induction here.
  bool state_at_large(long first) {
    const Assigned any(evaluator_, parameter_, Scalar(0));
    const std::set<std::string> bound = evaluator_.bound_symbols();
    generalise(evaluator_, parameter_, {first, true});
    Stated stated;
    try {
      stated = stated_under(evaluator_, statement_, scope_, {});
    } catch (const Unsupported&) {
      evaluator_.bind_only(bound);
      return false;
    } catch (const Problem&) {
      evaluator_.bind_only(bound);
      return false;
    }
    const auto free = [this](const Proposition& p) { return is_free(p); };
    if (!free(stated.goal) || !std::ranges::all_of(stated.guards, free)) return false;
    parts_.push_back(std::move(stated.goal));
    std::ranges::move(stated.guards, std::back_inserter(result_.guards));
    result_.predicates.merge(stated.predicates);
    return met_ = true;
  }

  void ascend(long first, long direction) {
    if (direction > 0 && range_.low && range_.rest.empty() && range_.others.empty() &&
        state_at_large(first))
      return;
    const long last = first + direction * (size_ - 1);
    for (long i = first; i != last + direction; i += direction) instance(i, "base: ");
    parts_.push_back(symbolic::suffices(step(last, direction)));
  }

  void begin(long first, long direction) {
    generalise(evaluator_, parameter_, {first, direction > 0});
    evaluator_.integers.relaxed = true;
  }

  Proposition step(long from, long direction) {
    const std::string bound = direction > 0 ? " >= " : " <= ";
    const std::string next = parameter_ + (direction > 0 ? " + 1" : " - 1");
    if (range_.rest.empty()) {
      const Assigned any(evaluator_, parameter_, Scalar(0));
      const std::size_t before = evaluator_.parameters.size();
      begin(from, direction);
      Stating stating(evaluator_);
      evaluator_.sides.clear();
      const auto known = hypothesis(stating);
      std::vector<Proposition> sides = std::move(evaluator_.sides);
      const bool apart = std::all_of(evaluator_.parameters.begin() + static_cast<long>(before),
                                     evaluator_.parameters.end(),
                                     [](const Parameter& p) { return p.where.empty(); });
      if (known && apart) {
        std::ranges::move(sides, std::back_inserter(stating.guards));
        return stated(*known, direction, std::move(stating.guards),
                      "step: from " + parameter_ + " to " + next + ", " + parameter_ + bound +
                          std::to_string(from));
      }
    }
    const Assigned any(evaluator_, parameter_, Scalar(0));
    begin(from + (range_.rest.empty() ? 0 : direction), direction);
    for (Parameter& p : evaluator_.parameters)
      if (p.name == parameter_) p.where = range_.rest;
    return stated({}, range_.rest.empty() ? direction : 0, {},
                  "every real " + parameter_ + bound + std::to_string(from + direction));
  }

  // The statement one step on.
  Proposition stated(const std::vector<Constraint>& known, long direction,
                     std::vector<Proposition> guards, const std::string& words) {
    evaluator_.integers.values[parameter_] =
        Scalar(Formula::symbol(parameter_)) + Scalar(direction);
    evaluator_.integers.lets.clear();
    evaluator_.integers.steps.clear();
    Stated next = stated_under(evaluator_, statement_, scope_, known);
    std::ranges::move(next.guards, std::back_inserter(guards));
    guards.push_back(std::move(next.goal));
    result_.predicates.merge(next.predicates);
    Proposition all = symbolic::all(std::move(guards));
    label(all, words);
    return all;
  }

  // What the statement says at n: inequalities; equations are put in where they can be.
  std::optional<std::vector<Constraint>> hypothesis(Stating& stating) {
    std::optional<std::vector<Constraint>> all;
    try {
      all = stating.constraints(statement_, scope_, {}, true);
    } catch (const Unsupported&) {
    }
    if (!all) return std::nullopt;
    for (const Constraint& c : *all)
      if (c.relation == Relation::zero) put_in(c.formula);
    std::vector<Constraint> result;
    for (const Constraint& c : *all) {
      if (c.relation == Relation::zero) continue;
      const Scalar value = present(c.formula);
      if (!symbolic::is_number(value.numerator))
        result.push_back(stating.related(value, c.relation, {}, statement_));
    }
    return result;
  }

  Scalar present(const Formula& f) {
    return substitute(scalar_of(f, evaluator_.numbers), evaluator_.integers.replaced,
                      evaluator_.numbers);
  }

  // a s + b = 0 gives s = -b/a for an unknown value s.
  void put_in(const Formula& equation) {
    Scalar rests_on = present(equation);
    const Formula f = rests_on.numerator;
    rests_on.numerator = rests_on.denominator = 1;
    if (!f.is_polynomial()) return;
    auto& replaced = evaluator_.integers.replaced;
    const std::set<std::string> variables = symbolic::variables(f);
    for (const std::string& s : evaluator_.integers.opaque) {
      if (!variables.contains(s) || replaced.contains(s)) continue;
      const auto parts = symbolic::coefficients(f, {s}, evaluator_.numbers);
      if (parts.empty() || parts.rbegin()->first[0] != 1) continue;
      const auto rest = parts.find({0});
      const Scalar b = rest == parts.end() ? Scalar(0) : Scalar(rest->second);
      const Scalar a = scalar_of(parts.rbegin()->second, evaluator_.numbers);
      const Scalar value = rests_on * divide(-b, a, evaluator_.numbers);
      for (auto& [name, other] : replaced)
        other = substitute(other, {{s, value}}, evaluator_.numbers);
      replaced.emplace(s, value);
      return;
    }
  }

  Evaluator& evaluator_;
  const Expression& statement_;
  const Scope& scope_;
  std::string parameter_;
  IntegerRange range_;
  long size_;
  bool met_ = false;
  Stated result_;
  std::vector<Proposition> parts_;
};

}  // namespace

Stated for_every_integer(Evaluator& evaluator, const Expression& statement, const Scope& scope,
                         const std::string& parameter) {
  return Induction(evaluator, statement, scope, parameter).run();
}

}  // namespace seam::claims
