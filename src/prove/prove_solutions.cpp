// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "exact/contract.h"
#include "prove/linear.h"
#include "prove/sign.h"
#include "prove/strategies.h"

// The common roots of the coefficients F are the roots of their gcd, which the extended
// Euclidean algorithm writes as a combination of them. Its real roots are isolated by Sturm's
// method; one in the domain that is not claimed refutes. Otherwise subdivision shows that what
// is left has no root.

namespace seam::prove {

using certificate::Nothing;
using certificate::Pieces;
using certificate::Proof;
using certificate::Roots;
using certificate::Term;
using certificate::WrongSolution;
using exact::Polynomial;
using exact::Rational;
using exact::RootInterval;
using exact::Sign;
using exact::Univariate;

namespace {

using Homogeneous = std::vector<Polynomial>;  // (weight, x)

class SolutionsProof {
 public:
  SolutionsProof(Workshop& workshop, const certificate::Solutions& stated)
      : workshop_(workshop), stated_(stated), domain_(make_factor(workshop, stated.domain)) {
    for (const auto& solution : stated.solutions) {
      is_exact_ = is_exact_ && solution.value >= 0;
      if (solution.value >= 0) claimed_.push_back(workshop.number(solution.value));
    }
    read_system();
  }

  Proof prove() {
    if (!is_exact_ && !claimed_.empty())
      return Nothing{"unsupported", "exact solutions beside intervals"};
    if (system_.empty()) return everything_is_a_solution();
    find_divisor();
    return is_exact_ ? exact() : intervals();
  }

 private:
  Polynomial constant(const Rational& value) const {
    return workshop_.numbers()->constant(value);
  }

  Univariate in_unknown(const Polynomial& f, int unknown) const {
    Univariate result;
    for (const Polynomial& c : exact::univariate(f, unknown))
      result.push_back(workshop_.numbers()->embed(c));
    return result;
  }

  void read_system() {
    std::vector<std::string> names = stated_.for_all;
    std::vector<int> bound;
    for (std::size_t i = 0; i < names.size(); ++i) bound.push_back(static_cast<int>(i));
    names.push_back(stated_.unknown);
    for (const Term term : stated_.system)
      for (const auto& [exponents, f] : workshop_.expand(term, names).coefficients(bound))
        system_.push_back(in_unknown(f, static_cast<int>(bound.size())));
  }

  void find_divisor() {
    divisor_ = exact::monic(system_[0]);
    cofactors_ = {{exact::inverse(system_[0].back())}};
    for (std::size_t i = 1; i < system_.size(); ++i) {
      auto [gcd, a, b] = exact::extended_gcd(divisor_, system_[i]);
      for (Univariate& c : cofactors_) c = c * a;
      cofactors_.push_back(std::move(b));
      divisor_ = std::move(gcd);
    }
  }

  Polynomial polynomial(const Univariate& f) const {
    std::map<exact::Exponents, Polynomial> terms;
    for (int i = 0; i <= exact::degree(f); ++i) terms.emplace(exact::Exponents{i}, f[i]);
    return workshop_.ring({stated_.unknown})->polynomial(terms);
  }
  Term write(const Univariate& f) const { return workshop_.write(polynomial(f)); }

  bool is_in_domain(const Polynomial& x) const {
    if (domain_.corners.empty()) return true;
    std::vector<Homogeneous> corners;
    for (const auto& corner : domain_.corners) {
      corners.emplace_back();
      for (const Polynomial& c : corner) corners.back().push_back(x.ring().embed(c));
    }
    const auto l = barycentric(corners, {x.ring().constant(1), x});
    for (std::size_t i = 0; i < l.size(); ++i) {
      const Sign s = exact::sign(l[i]);
      if (s == Sign::negative || (s == Sign::zero && domain_.open[i])) return false;
    }
    return true;
  }

  // Surely outside: quickly seen, so that no number has to be made for such a root.
  bool is_far_outside(const RootInterval& root) const {
    if (domain_.corners.empty()) return false;
    std::vector<std::vector<double>> corners;
    for (const auto& corner : domain_.corners)
      corners.push_back({exact::ball(corner[0]).middle, exact::ball(corner[1]).middle});
    const auto l = barycentric(corners, std::vector{1.0, root.low.get_d()});
    const double total = 1 + root.low.get_d();
    return !l.empty() && total != 0 && std::ranges::min(l) * (total > 0 ? 1 : -1) < -1e-6;
  }

  bool is_claimed(const Polynomial& x) const {
    for (const auto& solution : stated_.solutions) {
      if (solution.value >= 0) {
        if (x == x.ring().embed(workshop_.number(solution.value))) return true;
      } else if (exact::sign(x - x.ring().constant(Rational(solution.low))) != Sign::negative &&
                 exact::sign(x.ring().constant(Rational(solution.high)) - x) !=
                     Sign::negative) {
        return true;
      }
    }
    return false;
  }

  Proof missing(const Polynomial& x) const { return WrongSolution{workshop_.write(x), -1}; }

  Proof everything_is_a_solution() const {
    for (int i = 1; i < 1000; ++i) {
      Polynomial x = constant(i);
      if (!domain_.corners.empty()) {
        Homogeneous l = {constant(i), constant(1)};
        x = point(domain_, l).front();
      }
      if (is_in_domain(x) && !is_claimed(x)) return missing(x);
    }
    return Nothing{"unsupported", "every number of the domain is a solution"};
  }

  // A root of f in the domain that is not claimed.
  std::optional<Polynomial> unclaimed_root(const Univariate& f) const {
    const Univariate simple = exact::squarefree(f);
    for (RootInterval root : exact::real_roots(simple)) {
      while (root.high - root.low > Rational(1, 1L << 40)) root = exact::halved(simple, root);
      if (is_far_outside(root)) continue;
      Univariate lifted;
      for (const Polynomial& c : simple) lifted.push_back(workshop_.numbers()->embed(c));
      const Polynomial x = workshop_.adjoin(lifted, root);
      if (is_in_domain(x) && !is_claimed(x)) return x;
    }
    return std::nullopt;
  }

  // f != 0 on the domain, or the reason why that stays open.
  std::variant<Pieces, Nothing> nonzero(const Univariate& f, const Factor& domain) const {
    Nothing nothing;
    for (const int side : {1, -1}) {
      const Polynomial g = Rational(side) * polynomial(f);
      Answer answer = decide(workshop_, {{domain}, g, true, {}});
      if (answer.kind == Answer::Kind::yes) {
        answer.pieces.side =
            side > 0 ? certificate::Relation::positive : certificate::Relation::negative;
        return answer.pieces;
      }
      nothing = answer.kind == Answer::Kind::neither
                    ? answer.nothing
                    : Nothing{"unsupported", "a root was not found as a number"};
    }
    return nothing;
  }

  Factor segment(Homogeneous low, Homogeneous high, bool open_low, bool open_high) const {
    Factor result{{stated_.unknown}, {}, {open_high, open_low}, 0};
    if (low[0].is_zero()) result.infinite |= 1U;
    if (high[0].is_zero()) result.infinite |= 2U;
    result.corners = {std::move(low), std::move(high)};
    return result;
  }
  Homogeneous finite(const Rational& x) const { return {constant(1), constant(x)}; }
  Homogeneous infinity(int side) const { return {constant(0), constant(side)}; }

  // The whole line takes two trees.
  std::vector<Factor> whole_domain() const {
    if (!domain_.corners.empty()) return {domain_};
    return {segment(finite(0), infinity(1), false, false),
            segment(infinity(-1), finite(0), false, false)};
  }

  Roots start() const {
    Roots roots;
    roots.divisor = write(divisor_);
    for (std::size_t i = 0; i < system_.size(); ++i) {
      roots.cofactors.push_back(write(cofactors_[i]));
      roots.quotients.push_back(write(exact::divide(system_[i], divisor_).quotient));
    }
    return roots;
  }

  Proof exact() {
    Roots roots = start();
    Univariate rest = divisor_;
    for (std::size_t j = 0; j < claimed_.size(); ++j) {
      const Polynomial& x = claimed_[j];
      const auto wrong = WrongSolution{stated_.solutions[j].value, static_cast<int>(j)};
      if (!is_in_domain(x) || !exact::value(divisor_, x).is_zero()) return wrong;
      int multiplicity = 0;
      for (; exact::degree(rest) > 0; ++multiplicity) {
        auto [quotient, remainder] = exact::divide(rest, {-x, constant(1)});
        if (!remainder.empty()) break;
        rest = std::move(quotient);
      }
      if (multiplicity == 0) return Nothing{"unsupported", "two of the solutions are equal"};
      roots.multiplicities.push_back(multiplicity);
    }
    if (const auto x = unclaimed_root(rest)) return missing(*x);
    roots.rest = write(rest);
    return finish(std::move(roots), rest, whole_domain());
  }

  Proof finish(Roots roots, const Univariate& f, const std::vector<Factor>& parts) const {
    for (const Factor& part : parts) {
      if (is_one_point(part)) {
        roots.outside.emplace_back();
        continue;
      }
      auto pieces = nonzero(f, part);
      if (const auto* nothing = std::get_if<Nothing>(&pieces)) return *nothing;
      roots.outside.push_back(std::get<Pieces>(std::move(pieces)));
    }
    return roots;
  }

  bool is_one_point(const Factor& part) const {
    const auto entry = [&](int i, int j) {
      return workshop_.numbers()->embed(part.corners[i][j]);
    };
    return (entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0)).is_zero();
  }

  Proof intervals() {
    if (const auto x = unclaimed_root(divisor_)) return missing(*x);
    const Univariate simple = exact::squarefree(divisor_);
    const Univariate slope = exact::derivative(divisor_);
    Roots roots = start();
    roots.rest = write(divisor_);
    Homogeneous reached = infinity(-1), end = infinity(1);
    bool open = false, open_end = false;
    if (!domain_.corners.empty()) {
      const auto& c = domain_.corners;
      const bool rising = exact::sign(c[0][0] * c[1][1] - c[0][1] * c[1][0]) == Sign::positive;
      reached = c[rising ? 0 : 1];
      end = c[rising ? 1 : 0];
      open = domain_.open[rising ? 1 : 0];
      open_end = domain_.open[rising ? 0 : 1];
    }
    std::vector<Factor> parts;
    for (const auto& solution : stated_.solutions) {
      const Rational low(solution.low), high(solution.high);
      const auto count = exact::real_roots(simple, low, high).size();
      if (count != 1 || exact::degree(slope) < 0)
        return Nothing{"unsupported", std::to_string(count) + " roots between " + solution.low +
                                          " and " + solution.high + ", where one was claimed"};
      auto pieces = nonzero(slope, segment(finite(low), finite(high), false, false));
      if (const auto* nothing = std::get_if<Nothing>(&pieces)) return *nothing;
      roots.inside.push_back(std::get<Pieces>(std::move(pieces)));
      parts.push_back(segment(reached, finite(low), open, false));
      reached = finite(high);
      open = false;
    }
    parts.push_back(segment(reached, end, open, open_end));
    return finish(std::move(roots), divisor_, parts);
  }

  Workshop& workshop_;
  const certificate::Solutions& stated_;
  Factor domain_;
  bool is_exact_ = true;
  std::vector<Polynomial> claimed_;
  std::vector<Univariate> system_;
  Univariate divisor_;
  std::vector<Univariate> cofactors_;
};

}  // namespace

Proof prove_solutions(Workshop& workshop, const certificate::Solutions& stated) {
  return SolutionsProof(workshop, stated).prove();
}

}  // namespace seam::prove
