// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/limit.h"

#include <algorithm>
#include <unordered_map>

#include "claims/elementary.h"
#include "symbolic/coefficients.h"

// With n = 1/h the expression becomes a quotient of functions of h > 0. Each is written as
// h^low (c0 + c1 h + ...), a power of h times a function that is analytic at 0: so are sums,
// products, quotients by such with c0 != 0, and exp, sin, cos, log (of c0 > 0) and roots (of c0
// > 0) of such with low = 0 (a root: low a multiple of its index), by the series of these
// functions around c0. A function that is analytic at 0 is continuous there; so the limit is 0
// for low > 0, c0 for low = 0, and there is none for low < 0 and c0 != 0.
//
// As many coefficients are kept as could be needed to see through cancellations; if all that
// are known vanish, nothing is said. That those left out are 0 is stated.
//
// The limit rests on every c0 that was divided by, whatever became of the quotient: another c0
// may make it grow faster. It also rests on what the expression rests on for large n: a divisor
// is not 0 there if its c0 is not, a radicand not negative if its c0 is positive. What has no
// expansion has no limit here, even multiplied by 0.

namespace seam::claims {
namespace {

using exact::Rational;
using symbolic::Fact;

constexpr std::size_t most_terms = 14;

struct Series {
  int low = 0;
  std::vector<Scalar> c;  // those that are known; not empty
};

class Expanding {
 public:
  Expanding(Evaluator& evaluator, std::string unknown)
      : evaluator_(evaluator), numbers_(evaluator.numbers), unknown_(std::move(unknown)) {}

  Scalar limit(const Scalar& x) {
    Scalar result(0);
    if (!symbolic::vanishes(x.numerator, numbers_)) {
      const Series whole =
          times(lead(expanded(x.numerator)), inverse(lead(expanded(x.denominator))));
      if (whole.low < 0) throw Unsupported("a limit that is not finite");
      if (whole.low == 0) result = whole.c.front();
    }
    for (const Formula& divisor : x.divisors) not_zero(divisor);
    for (const Formula& radicand : x.radicands) not_negative(radicand);
    return result + rest_;
  }

 private:
  // A limit has no value where s has none.
  void rest_on(const Scalar& s) {
    Scalar nil(0);
    nil.divisors = s.divisors;
    nil.radicands = s.radicands;
    rest_ = rest_ + nil;
  }
  Scalar reciprocal(const Scalar& c) {
    Scalar result = divide(Scalar(1), c, numbers_);
    rest_on(result);
    return result;
  }
  void not_zero(const Formula& divisor) {
    if (holds_unknown(divisor))
      reciprocal(lead(expanded(divisor)).c.front());
    else
      rest_.divisors.push_back(divisor);
  }
  void not_negative(const Formula& radicand) {
    if (holds_unknown(radicand))
      positive(lead(expanded(radicand)).c.front());
    else
      rest_.radicands.push_back(radicand);
  }
  // Also in what it rests on.
  bool holds_unknown(const Formula& f) {
    if (f.kind() == Formula::Kind::symbol) return f.name() == unknown_;
    if (f.is_constant()) return false;
    if (const auto known = holds_.find(f.identity()); known != holds_.end())
      return known->second;
    bool holds = std::ranges::any_of(
        f.operands(), [this](const Formula& operand) { return holds_unknown(operand); });
    for (const Fact& fact : f.facts()) holds = holds || holds_unknown(fact.formula);
    return holds_[f.identity()] = holds;
  }

  static Series constant(const Scalar& value) {
    Series result{0, std::vector<Scalar>(most_terms, Scalar(0))};
    result.c.front() = value;
    return result;
  }

  // Begins with a coefficient that is not 0, as far as is seen.
  Series lead(Series s) {
    while (symbolic::vanishes(s.c.front().numerator, numbers_)) {
      const Formula& nothing = s.c.front().numerator;
      if (!nothing.is(0))
        evaluator_.sides.push_back(
            symbolic::atom(symbolic::Zero{nothing}, "a coefficient of an expansion is 0"));
      s.c.erase(s.c.begin());
      ++s.low;
      if (s.c.empty()) throw Unsupported("a limit of which no term of the expansion is known");
    }
    return s;
  }

  Series plus(const Series& a, const Series& b) const {
    const Series &first = a.low <= b.low ? a : b, &second = a.low <= b.low ? b : a;
    const auto shift = static_cast<std::size_t>(second.low - first.low);
    const std::size_t known = std::min(first.c.size(), shift + second.c.size());
    Series result{first.low, {first.c.begin(), first.c.begin() + static_cast<long>(known)}};
    for (std::size_t i = shift; i < known; ++i)
      result.c[i] = tidy(result.c[i] + second.c[i - shift]);
    return result;
  }

  Series times(const Series& a, const Series& b) const {
    Series result{a.low + b.low, {}};
    for (std::size_t k = 0; k < std::min(a.c.size(), b.c.size()); ++k) {
      Scalar sum(0);
      for (std::size_t i = 0; i <= k; ++i)
        if (!a.c[i].numerator.is(0) && !b.c[k - i].numerator.is(0))
          sum = sum + a.c[i] * b.c[k - i];
      result.c.push_back(tidy(sum));
    }
    return result;
  }

  Series scaled(const Scalar& factor, Series s) const {
    for (Scalar& c : s.c) c = tidy(factor * c);
    return s;
  }

  // c0 is not 0: 1/s = (1/c0) (1 + u + u^2 + ...), u = 1 - s/c0.
  Series inverse(const Series& s) {
    const Scalar first = reciprocal(s.c.front());
    Series u = scaled(Scalar(-1) * first, s);
    u.low = 0;
    u.c.front() = Scalar(0);
    Series result = scaled(first, composed(u, [](std::size_t) { return Rational(1); }));
    result.low = -s.low;
    return result;
  }

  // sum a(k) u^k, u without a constant term.
  template <typename Coefficient>
  Series composed(const Series& u, const Coefficient& a) const {
    Series result = constant(Scalar(0));
    for (std::size_t k = most_terms; k-- > 0;)
      result = plus(times(result, u), constant(Scalar(Formula(a(k)))));
    return result;
  }

  static Rational factorial(std::size_t k) {
    exact::Integer result;
    mpz_fac_ui(result.get_mpz_t(), k);
    return Rational(result);
  }

  Series expanded(const Formula& f) {
    if (!holds_unknown(f)) {
      const Scalar value = scalar_of(f, numbers_);
      rest_on(value);
      return constant(value);
    }
    if (const auto known = done_.find(f.identity()); known != done_.end()) return known->second;
    Series result = compute(f);
    done_.emplace(f.identity(), result);
    return result;
  }

  Series compute(const Formula& f) {
    const auto& operands = f.operands();
    switch (f.kind()) {
      case Formula::Kind::symbol: {
        Series n = constant(Scalar(1));
        n.low = -1;
        return n;
      }
      case Formula::Kind::sum: {
        Series total = expanded(operands[0]);
        for (std::size_t i = 1; i < operands.size(); ++i)
          total = plus(total, expanded(operands[i]));
        return total;
      }
      case Formula::Kind::product: {
        Series total = expanded(operands[0]);
        for (std::size_t i = 1; i < operands.size(); ++i)
          total = times(total, expanded(operands[i]));
        return total;
      }
      case Formula::Kind::power: {
        const Series base = expanded(operands[0]);
        Series total = constant(Scalar(1));
        for (int i = 0; i < f.exponent(); ++i) total = times(total, base);
        return total;
      }
      case Formula::Kind::inverse:
        return inverse(lead(expanded(operands[0])));
      case Formula::Kind::root:
        return root(lead(expanded(operands[0])), f.exponent());
      case Formula::Kind::applied:
        return applied(f.name(), expanded(operands[0]));
      default:
        for (const Fact& fact : f.facts()) {
          if (fact.relation == Fact::Relation::nonzero) not_zero(fact.formula);
          if (fact.relation == Fact::Relation::nonnegative) not_negative(fact.formula);
        }
        return expanded(operands[0]);
    }
  }

  // c > 0: seen of a number, of others stated.
  Scalar positive(const Scalar& c) {
    if (is_number(c) && numbers_.sign(c.numerator) != exact::Sign::positive)
      throw Unsupported("a limit with a root or logarithm of what is not seen to be positive");
    reciprocal(c);
    if (!is_number(c)) rest_.radicands.push_back(c.numerator * c.denominator);
    return c;
  }

  // (c0 h^low)^(1/n) (1 + u)^(1/n)
  Series root(const Series& s, int n) {
    if (s.low % n != 0) throw Unsupported("a limit with a root that grows by a fraction");
    const Scalar first = positive(s.c.front());
    Series u = scaled(reciprocal(first), s);
    u.low = 0;
    u.c.front() = Scalar(0);
    Series result = scaled(nth_root(first, n, numbers_), composed(u, [n](std::size_t k) {
                             Rational binomial = 1;
                             for (std::size_t i = 0; i < k; ++i)
                               binomial *= (Rational(1, n) - Rational(static_cast<long>(i))) /
                                           Rational(static_cast<long>(i + 1));
                             return binomial;
                           }));
    result.low = s.low / n;
    return result;
  }

  Series applied(const std::string& function, const Series& operand) {
    if (!symbolic::is_elementary(function)) throw Unsupported("a limit of '" + function + "'");
    Series u = plus(operand, constant(Scalar(0)));
    while (u.low < 0) {
      const bool is_there = !symbolic::vanishes(u.c.front().numerator, numbers_);
      if (is_there || u.c.size() == 1)
        throw Unsupported("a limit with a function of what is not bounded");
      u.c.erase(u.c.begin());
      ++u.low;
    }
    const Scalar first = u.c.front();
    u.c.front() = Scalar(0);
    const auto at = [&](const char* name) { return elementary(name, first, numbers_); };
    if (function == "exp")
      return scaled(at("exp"), composed(u, [](std::size_t k) { return 1 / factorial(k); }));
    if (function == "log") {
      const Series ratio = scaled(reciprocal(positive(first)), u);
      return plus(constant(at("log")), composed(ratio, [](std::size_t k) {
                    if (k == 0) return Rational(0);
                    return Rational(k % 2 == 1 ? 1 : -1, static_cast<long>(k));
                  }));
    }
    const auto part = [](std::size_t parity) {
      return [parity](std::size_t k) {
        if (k % 2 != parity) return Rational(0);
        return Rational((k / 2 % 2 == 0 ? 1 : -1) / factorial(k));
      };
    };
    const Series cos = composed(u, part(0)), sin = composed(u, part(1));
    if (function == "cos")
      return plus(scaled(at("cos"), cos), scaled(Scalar(-1) * at("sin"), sin));
    return plus(scaled(at("sin"), cos), scaled(at("cos"), sin));
  }

  // Numbers in normal form, so that they do not grow.
  Scalar tidy(const Scalar& c) const {
    return is_number(c) ? Scalar(numbers_.normal_form(c.numerator)) : c;
  }

  Evaluator& evaluator_;
  Numbers& numbers_;
  std::string unknown_;
  Scalar rest_;
  std::unordered_map<const void*, Series> done_;
  std::unordered_map<const void*, bool> holds_;
};

}  // namespace

Value limit(const Call& call) {
  if (call[0].kind != Expression::Kind::limit)
    fail(call.at, "expected 'limit(E for n -> infinity)'");
  if (call[0].children[1].kind != Expression::Kind::infinity)
    throw Unsupported("limits other than for n -> infinity");
  Evaluator& evaluator = call.evaluator;
  const std::string symbol = evaluator.bind(call[0].text);
  Scope inner{&call.scope, {}};
  inner.values[call[0].text] = {Scalar(Formula::symbol(symbol))};
  const Value value = evaluator.evaluate(call[0].children[0], inner);
  evaluator.release(symbol);
  Expanding expanding(evaluator, symbol);
  if (const auto* scalar = value.as<Scalar>()) return {expanding.limit(*scalar)};
  Vector result;
  for (const Scalar& entry : as_vector(evaluator, value, call[0]))
    result.push_back(expanding.limit(entry));
  return {result};
}

}  // namespace seam::claims
