// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

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
    names_ = variables(factors_);
    term_ = sign.formula;
    where_ = sign.domain.where;
  }

  Polynomial f() { return workshop_.expand(term_, names_); }

  Proof prove(Relation relation) {
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

 private:
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
  std::vector<std::string> names_;
  certificate::Term term_ = 0;
  std::vector<certificate::Constraint> where_;
};

}  // namespace

Proof SignProver::prove(const certificate::Sign& sign) {
  if (sign.domain.factors.empty()) return certificate::Computation{};
  SignProof proof(*workshop_, sign);
  const Polynomial f = proof.f();
  for (const Settled& s : settled_)
    if (s.sign.relation == sign.relation && s.sign.domain == sign.domain &&
        s.f.ring().tower() == f.ring().tower() && s.f == f)
      return s.proof;
  settled_.push_back({sign, f, proof.prove(sign.relation)});
  return settled_.back().proof;
}

}  // namespace seam::prove
