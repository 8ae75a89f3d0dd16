// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "prove/derive.h"
#include "prove/failing_point.h"
#include "prove/identities.h"
#include "prove/sign.h"
#include "prove/strategies.h"

namespace seam::prove {

using certificate::Nothing;
using certificate::Proof;
using certificate::Relation;
using exact::Polynomial;
using exact::Sign;

namespace {

class SignProof {
 public:
  SignProof(Workshop& workshop, const certificate::Sign& sign) : workshop_(workshop) {
    for (const auto& simplex : sign.domain.factors)
      factors_.push_back(make_factor(workshop, simplex));
    term_ = sign.formula;
    where_ = sign.domain.where;
    std::vector<certificate::Term> terms = {term_};
    for (const auto& condition : where_) terms.push_back(condition.formula);
    functions_ = workshop.functions(terms);
    names_ = variables(factors_);
    const std::set<std::string> bounded(names_.begin(), names_.end());
    std::set<std::string> free;
    for (const certificate::Term term : terms) free.merge(workshop.variables(term));
    for (const std::string& name : free)
      if (!bounded.contains(name)) names_.push_back(name);
    has_lines_ = names_.size() > bounded.size();
    for (const auto* function : functions_) names_.push_back(function->name);
  }

  bool is_about_a_number() const { return factors_.empty() && !has_lines_; }

  Polynomial f() { return workshop_.expand(term_, names_); }

  Proof prove(Relation relation) {
    if (has_lines_) return by_identities(relation);
    const bool has_equation =
        std::ranges::any_of(where_, [](const auto& c) { return c.relation == Relation::zero; });
    const bool is_plain = !has_equation && functions_.empty();
    if (!where_.empty() && functions_.empty() && is_unbounded())
      if (auto shown = by_conditions(relation)) return *shown;
    Proof proof = is_plain ? by_subdivision(relation) : by_derivation(relation);
    if (!std::holds_alternative<Nothing>(proof)) return proof;
    if (is_plain && !where_.empty()) proof = by_derivation(relation);
    if (is_plain && where_.empty())
      if (auto point = at_a_sample(relation)) return certificate::Witness{*point, {}};
    if (has_equation && functions_.empty()) proof = by_subdivision(relation);
    if (!std::holds_alternative<Nothing>(proof) || where_.empty() || !functions_.empty())
      return proof;
    Proof other = by_identities(relation);
    return std::holds_alternative<Nothing>(other) ? proof : other;
  }

 private:
  static Proof of(certificate::SignProof shown) {
    return std::visit([](auto&& value) { return Proof(std::move(value)); }, std::move(shown));
  }

  // Where several coordinates go to infinity no splits part them.
  bool is_unbounded() const {
    return std::ranges::any_of(factors_, [](const Factor& f) { return f.infinite != 0; });
  }
  std::optional<Proof> by_conditions(Relation relation) {
    Derivation derivation(workshop_, make_region(workshop_, factors_, where_, functions_));
    auto shown = derivation.combine(f(), relation);
    return shown ? std::optional(of(std::move(*shown))) : std::nullopt;
  }

  std::optional<certificate::Point> at_a_sample(Relation relation) {
    Derivation derivation(workshop_, make_region(workshop_, factors_, where_, functions_));
    return derivation.refute(f(), relation);
  }

  Proof by_identities(Relation relation) {
    if (!functions_.empty())
      return Nothing{"unsupported", "roots of functions of more than four unbounded variables"};
    std::vector<Condition> where;
    for (const auto& condition : where_)
      where.push_back({workshop_.expand(condition.formula, names_), condition.relation});
    if (auto point = failing_point(workshop_, factors_, where, f(), relation))
      return certificate::Witness{*point, {}};
    Identities identities(workshop_, factors_, names_, std::move(where));
    if (auto shown = identities.show(f(), relation)) return of(std::move(*shown));
    if (workshop_.late()) return Nothing{"time", "the time given was over"};
    return Nothing{"effort", "neither a proof by identities nor a point was found"};
  }

  Proof by_derivation(Relation relation) {
    if (f().is_zero() && holds(relation, Sign::zero)) return certificate::Computation{};
    Derivation derivation(workshop_, make_region(workshop_, factors_, where_, functions_));
    if (auto point = derivation.refute(f(), relation)) return certificate::Witness{*point, {}};
    if (auto shown = derivation.show(f(), relation)) return of(std::move(*shown));
    if (auto point = derivation.refute(f(), relation)) return certificate::Witness{*point, {}};
    if (workshop_.late()) return Nothing{"time", "the time given was over"};
    if (std::ranges::any_of(functions_, [](const auto* function) {
          return function->elementary == certificate::Elementary::log;
        }))
      return Nothing{"unsupported", "an inequality of a logarithm of a variable"};
    return Nothing{"effort",
                   "neither a proof by multipliers, cases and subdivision nor a "
                   "point was found"};
  }

  Proof by_subdivision(Relation relation) {
    switch (relation) {
      case Relation::positive:
        return by_question(1, true);
      case Relation::nonnegative:
        return by_question(1, false);
      case Relation::negative:
        return by_question(-1, true);
      case Relation::nonpositive:
        return by_question(-1, false);
      case Relation::zero:
        return zero();
      case Relation::nonzero:
        return nonzero();
    }
    return Nothing{"unsupported", "no such relation"};
  }

  Question question(Polynomial f, bool strict) {
    Question result{factors_, std::move(f), strict, {}};
    for (const auto& condition : where_)
      result.where.push_back({workshop_.expand(condition.formula, names_), condition.relation});
    return result;
  }
  Proof witness(const Place& place) {
    return certificate::Witness{write_point(workshop_, factors_, place), {}};
  }

  Proof by_question(int side, bool strict) {
    const Answer answer = decide(workshop_, question(exact::Rational(side) * f(), strict));
    switch (answer.kind) {
      case Answer::Kind::yes: {
        certificate::Pieces pieces = answer.pieces;
        // The question was about -f = square^2 * cofactor.
        if (side < 0 && pieces.cofactor >= 0)
          pieces.cofactor = workshop_.negated(pieces.cofactor);
        return pieces;
      }
      case Answer::Kind::no:
        return witness(answer.place);
      case Answer::Kind::neither:
        return answer.nothing;
    }
    return answer.nothing;
  }

  // A place where f is not 0 is one where -f^2 >= 0 fails.
  Proof zero() {
    if (f().is_zero()) return certificate::Computation{};
    const Answer answer = decide(workshop_, question(-(f() * f()), false));
    if (answer.kind == Answer::Kind::no) return witness(answer.place);
    if (answer.kind == Answer::Kind::neither) return answer.nothing;
    return Nothing{"unsupported", "the formula vanishes on the domain, but not identically"};
  }

  Proof nonzero() {
    const Answer above = decide(workshop_, question(f(), true));
    if (above.kind == Answer::Kind::yes) return sided(above, Relation::positive);
    if (above.kind == Answer::Kind::no && above.sign == Sign::zero) return witness(above.place);
    const Answer below = decide(workshop_, question(-f(), true));
    if (below.kind == Answer::Kind::yes) return sided(below, Relation::negative);
    if (below.kind == Answer::Kind::no && below.sign == Sign::zero) return witness(below.place);
    if (above.kind == Answer::Kind::neither) return above.nothing;
    if (below.kind == Answer::Kind::neither) return below.nothing;
    if (!where_.empty())
      return Nothing{"unsupported", "the formula changes sign on a domain with conditions"};
    return certificate::Witness{write_point(workshop_, factors_, above.place),
                                {write_point(workshop_, factors_, below.place)}};
  }

  static Proof sided(const Answer& answer, Relation side) {
    certificate::Pieces pieces = answer.pieces;
    pieces.side = side;
    return pieces;
  }

  Workshop& workshop_;
  Factors factors_;
  std::vector<const certificate::Function*> functions_;
  std::vector<std::string> names_;
  bool has_lines_ = false;  ///< variables that belong to no factor
  certificate::Term term_ = 0;
  std::vector<certificate::Constraint> where_;
};

}  // namespace

Proof SignProver::prove(const certificate::Sign& sign) {
  SignProof proof(*workshop_, sign);
  if (proof.is_about_a_number()) return certificate::Computation{};
  const Polynomial f = proof.f();
  for (const Settled& s : settled_)
    if (s.sign.relation == sign.relation && s.sign.domain == sign.domain &&
        s.f.ring().tower() == f.ring().tower() &&
        s.f.ring().variables() == f.ring().variables() && s.f == f)
      return s.proof;
  settled_.push_back({sign, f, proof.prove(sign.relation)});
  return settled_.back().proof;
}

}  // namespace seam::prove
