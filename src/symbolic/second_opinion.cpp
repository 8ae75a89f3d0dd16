// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/second_opinion.h"

#include <ginac/ginac.h>

#include <map>
#include <set>
#include <sstream>

// A third arithmetic beside the prover's and the checker's, on purpose a simple-minded one:
// every node of the program is evaluated at one point. A slip that prover and checker share (in
// the reading of a domain, say) shows here if it changes a sign at that point.

namespace seam::symbolic {
namespace {

using certificate::Domain;
using certificate::Elementary;
using certificate::Node;
using certificate::Relation;
using certificate::Simplex;
using certificate::Statement;
using certificate::Term;
using GiNaC::numeric;

constexpr long digits = 100;

class Evaluation {
 public:
  explicit Evaluation(const Statement& statement) : statement_(statement) {
    GiNaC::Digits = digits;
    for (const auto& generator : statement.generators) {
      if (generator.function == Elementary::pi)
        place(generator.name, in_digits(GiNaC::Pi));
      else if (generator.function != Elementary::none)
        place(generator.name, value(generator.function, at(generator.argument)));
      else
        place_root(generator);
    }
  }

  void place(const std::string& name, const numeric& value) {
    values_[name] = value;
    done_.clear();
  }
  bool has(const std::string& name) const { return values_.contains(name); }

  // Once the variables have values. A function whose radicand is negative has none.
  void place_functions() {
    for (const auto& function : statement_.functions) {
      lacks_value_ = false;
      const numeric radicand = at(function.operand);
      if (!function.is_root()) {
        const bool has_value =
            !lacks_value_ && (function.elementary != Elementary::log || radicand.is_positive());
        if (!has_value) without_value_.insert(function.name);
        place(function.name, has_value ? value(function.elementary, radicand) : numeric(0));
        continue;
      }
      const bool is_zero = GiNaC::abs(radicand) <= rounding();
      if (lacks_value_ || (radicand.is_negative() && !is_zero))
        without_value_.insert(function.name);
      place(function.name,
            is_zero || radicand.is_negative() ? numeric(0) : root(radicand, function.degree));
    }
    lacks_value_ = false;
  }
  // Whether something that was evaluated since has no value.
  bool lacks_value() const { return lacks_value_; }

  // The largest size met on the way bounds what rounding can have done.
  numeric rounding() const { return size_ * numeric(10).power(-digits + 20); }

  numeric at(Term term) {
    if (const auto known = done_.find(term); known != done_.end()) return known->second;
    const Node& node = statement_.nodes[term];
    numeric result = 0;
    switch (node.kind) {
      case Node::Kind::constant:
        result = numeric(node.text.c_str());
        break;
      case Node::Kind::symbol:
        result = values_.contains(node.text) ? values_.at(node.text) : numeric(0);
        lacks_value_ = lacks_value_ || without_value_.contains(node.text);
        break;
      case Node::Kind::sum:
        for (const Term operand : node.operands) result += at(operand);
        break;
      case Node::Kind::product:
        result = 1;
        for (const Term operand : node.operands) result *= at(operand);
        break;
      case Node::Kind::power:
        result = at(node.operands[0]).power(node.exponent);
        break;
    }
    if (GiNaC::abs(result) > size_) size_ = GiNaC::abs(result);
    done_.emplace(term, result);
    return result;
  }

 private:
  static numeric in_digits(const GiNaC::ex& x) { return GiNaC::ex_to<numeric>(x.evalf()); }

  static numeric root(const numeric& radicand, int degree) {
    return GiNaC::exp(GiNaC::log(in_digits(radicand)) / degree);
  }

  static numeric value(Elementary function, const numeric& operand) {
    const numeric x = in_digits(operand);
    switch (function) {
      case Elementary::exp:
        return GiNaC::exp(x);
      case Elementary::log:
        return GiNaC::log(x);
      case Elementary::sin:
        return GiNaC::sin(x);
      default:
        return GiNaC::cos(x);
    }
  }

  // Bisection to far below the working precision.
  void place_root(const certificate::Generator& generator) {
    numeric low(generator.low.c_str()), high(generator.high.c_str());
    const auto value = [&](const numeric& x) {
      place(generator.name, x);
      return at(generator.polynomial);
    };
    const bool rises = value(high).is_positive();
    for (int step = 0; step < 4 * digits; ++step) {
      const numeric middle = (low + high) / 2;
      (value(middle).is_positive() == rises ? high : low) = middle;
    }
    place(generator.name, GiNaC::ex_to<numeric>(GiNaC::ex(low).evalf()));
    size_ = 1;
  }

  const Statement& statement_;
  std::map<std::string, numeric> values_;
  std::map<Term, numeric> done_;
  numeric size_ = 1;
  std::set<std::string> without_value_;
  bool lacks_value_ = false;
};

bool agrees(Relation relation, const numeric& value, const numeric& rounding) {
  const bool zero = GiNaC::abs(value) <= rounding;
  switch (relation) {
    case Relation::positive:
      return zero || value.is_positive();
    case Relation::nonnegative:
      return zero || value.is_positive();
    case Relation::zero:
      return zero;
    case Relation::nonzero:
      return true;
    case Relation::nonpositive:
      return zero || value.is_negative();
    case Relation::negative:
      return zero || value.is_negative();
  }
  return true;
}

// A point with barycentric weights 3, 2, 2, ...: inside, and on no axis of symmetry.
void place_inside(const Simplex& simplex, Evaluation& evaluation) {
  numeric weight = 0;
  std::vector<numeric> sum(simplex.variables.size(), numeric(0));
  for (std::size_t corner = 0; corner < simplex.corners.size(); ++corner) {
    const numeric share = corner == 0 ? 3 : 2;
    weight += share * evaluation.at(simplex.corners[corner][0]);
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += share * evaluation.at(simplex.corners[corner][i + 1]);
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    evaluation.place(simplex.variables[i], sum[i] / weight);
}

std::optional<std::string> objection(Evaluation& evaluation, Term formula, Relation relation) {
  evaluation.place_functions();
  const numeric value = evaluation.at(formula);
  if (evaluation.lacks_value() || agrees(relation, value, evaluation.rounding()))
    return std::nullopt;
  std::ostringstream sentence;
  GiNaC::Digits = 10;
  sentence << "evaluation at a point gives " << GiNaC::ex(value).evalf();
  GiNaC::Digits = digits;
  return sentence.str();
}

}  // namespace

std::optional<std::string> contradiction(const Statement& statement,
                                         const certificate::Obligation& obligation) {
  Evaluation evaluation(statement);
  if (const auto* zero = std::get_if<certificate::Zero>(&obligation)) {
    long k = 2;
    for (const Node& node : statement.nodes)
      if (node.kind == Node::Kind::symbol && !evaluation.has(node.text)) {
        evaluation.place(node.text, numeric(k) / numeric(k + 3));
        k += 3;
      }
    return objection(evaluation, zero->formula, Relation::zero);
  }
  if (const auto* sign = std::get_if<certificate::Sign>(&obligation)) {
    if (!sign->domain.where.empty()) return std::nullopt;
    for (const Simplex& factor : sign->domain.factors) place_inside(factor, evaluation);
    return objection(evaluation, sign->formula, sign->relation);
  }
  return std::nullopt;
}

}  // namespace seam::symbolic
