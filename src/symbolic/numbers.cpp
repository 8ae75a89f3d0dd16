// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/numbers.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "exact/contract.h"
#include "exact/roots.h"
#include "symbolic/expand.h"

// A root is looked for in three places: among the rationals (perfect powers are taken out of
// the radicand's rational content), in the field of the radicand (a linear factor), and, where
// its irreducible factor is of higher degree, in the field extended by it: it becomes a
// generator. Generators that were made apart may depend on each other; the field of both shows
// it, for there the polynomial of the later one is factored again.

namespace seam::symbolic {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::RootInterval;
using exact::Sign;
using exact::Univariate;

namespace {

// "3.2", "about" being said by the caller.
std::string roughly(const Polynomial& number) {
  std::string text = std::to_string(exact::ball(number).middle);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

// The largest t found with t^n a divisor; all prime factors below the bound are found, and a
// power that is left.
Integer power_part(Integer x, int n) {
  constexpr long bound = 100'000;
  Integer result = 1;
  const auto take = [&](const Integer& p) {
    int count = 0;
    for (; x % p == 0; ++count) x /= p;
    for (; count >= n; count -= n) result *= p;
  };
  for (long p = 2; p < bound && p * p <= x; p += p == 2 ? 1 : 2)
    if (x % p == 0) take(p);
  Integer root;
  if (x > 1 && mpz_root(root.get_mpz_t(), x.get_mpz_t(), n) != 0) result *= root;
  return result;
}

Integer pow(const Integer& base, int exponent) {
  Integer result;
  mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
  return result;
}

// x^n - a
bool is_binomial(const Univariate& f) {
  return f.back().rational() == Rational(1) &&
         std::all_of(f.begin() + 1, f.end() - 1,
                     [](const Polynomial& c) { return c.is_zero(); });
}

Integer common_denominator(const Univariate& f) {
  Integer result = 1;
  for (const Polynomial& c : f) result = lcm(result, c.numerators().denominator);
  return result;
}

Formula in_symbol(const Univariate& f, const std::string& name) {
  std::vector<Formula> terms;
  for (int i = exact::degree(f); i >= 0; --i)
    terms.push_back(formula(f[i]) * power(Formula::symbol(name), i));
  return sum(std::move(terms));
}

std::string name_of(const Univariate& f) {
  if (!is_binomial(f)) return "root(" + text(in_symbol(f, "x")) + ")";
  const std::string radicand = "(" + text(formula(-f[0])) + ")";
  switch (exact::degree(f)) {
    case 2:
      return "sqrt" + radicand;
    case 3:
      return "cbrt" + radicand;
    default:
      return "root_" + std::to_string(exact::degree(f)) + radicand;
  }
}

}  // namespace

// All generators, and the fields that were asked for, by the indices of their generators.
struct Numbers::Forest {
  using Support = std::vector<std::size_t>;  // ascending, closed under "is defined by"
  struct Grown {
    Field field;
    std::unique_ptr<Expansion> expansion;
  };
  std::vector<Generator> generators;
  std::vector<Support> supports;  // of each generator, itself the last
  std::map<std::string, std::size_t> index;
  std::map<Support, Grown> fields;
  std::map<std::pair<int, std::string>, Formula> roots;  // by index and radicand
  std::unordered_map<const void*, std::pair<Formula, Support>> known_supports;

  const Support& support(const Formula&);
  const Grown& grown(const Support&);
  const Grown& field_of(const Formula& f) { return grown(support(f)); }
  Polynomial number(const Formula& f) { return (*field_of(f).expansion)(f); }
  void extend(Grown&, const Generator&);
  Formula root_of(const Grown&, const Univariate& squarefree, RootInterval where);
  Formula power_root(const Grown&, const Polynomial& radicand, int n);
  Formula quadratic_root(const Grown&, const Univariate& irreducible, RootInterval where);
  std::string unused(const std::string& name) const;
};

namespace {

std::vector<std::size_t> united(const std::vector<std::size_t>& a,
                                const std::vector<std::size_t>& b) {
  std::vector<std::size_t> all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

constexpr int max_degree = 64;   // of a field
constexpr int max_search = 160;  // of the norm of a polynomial that is to be factored

void require_small(const exact::RingPtr& ring, int degree, int most = max_degree) {
  if (exact::dimension(ring->tower()) * degree > most)
    throw NumberLimit("numbers of a field of degree over 64 are not covered");
}

}  // namespace

const Numbers::Forest::Support& Numbers::Forest::support(const Formula& f) {
  if (const auto known = known_supports.find(f.identity()); known != known_supports.end())
    return known->second.second;
  Support result;
  if (f.kind() == Formula::Kind::symbol)
    if (const auto found = index.find(f.name()); found != index.end())
      result = supports[found->second];
  for (const Formula& operand : f.operands()) result = united(result, support(operand));
  return known_supports.try_emplace(f.identity(), f, std::move(result)).first->second.second;
}

// The generators one after the other; fields that begin alike share their beginning.
const Numbers::Forest::Grown& Numbers::Forest::grown(const Support& names) {
  if (const auto known = fields.find(names); known != fields.end()) return known->second;
  Grown result;
  if (names.empty()) {
    result.field.ring = exact::Ring::make(nullptr, {});
  } else {
    result.field = grown({names.begin(), names.end() - 1}).field;
    extend(result, generators[names.back()]);
  }
  result.expansion =
      std::make_unique<Expansion>(result.field.ring, Atoms{}, result.field.values);
  return fields.emplace(names, std::move(result)).first->second;
}

void Numbers::Forest::extend(Grown& to, const Generator& generator) {
  Field& field = to.field;
  const std::string& name = generator.name;
  const auto over = exact::Ring::make(field.ring->tower(), {name});
  const Polynomial polynomial = Expansion(over, {}, field.values)(generator.polynomial);
  Univariate f;
  for (const Polynomial& c : exact::univariate(polynomial, 0))
    f.push_back(field.ring->embed(c));
  const RootInterval where{generator.low, generator.high};
  const Univariate factor = exact::irreducible_factor(f, where);
  const auto facts = [&](const Formula& value) -> std::vector<Fact> {
    return {{subst(generator.polynomial, {{name, value}}), Fact::Relation::zero},
            {value - Formula(generator.low), Fact::Relation::nonnegative},
            {Formula(generator.high) - value, Fact::Relation::nonnegative}};
  };
  if (exact::degree(factor) == 1) {
    const Formula value = formula(-factor[0]);
    field.dependent.emplace(name, Formula::known(value, facts(value)));
    field.values.emplace(name, -factor[0]);
    return;
  }
  require_small(field.ring, exact::degree(factor));
  const Univariate cleared = field.ring->constant(common_denominator(factor)) * factor;
  const auto bracket = exact::bracket(factor, where);
  field.generators.push_back({name, in_symbol(cleared, name), bracket.low, bracket.high});
  field.ring = exact::Ring::make(exact::adjoin(factor, name, bracket), {});
  for (auto& value : field.values) value.second = field.ring->embed(value.second);
  field.values.emplace(name, *field.ring->symbol(name));
}

std::string Numbers::Forest::unused(const std::string& name) const {
  std::string result = name;
  for (int i = 2; index.contains(result); ++i) result = name + "(" + std::to_string(i) + ")";
  return result;
}

Formula Numbers::Forest::root_of(const Grown& in, const Univariate& squarefree,
                                 RootInterval where) {
  const exact::RingPtr ring = in.field.ring;
  require_small(ring, exact::degree(squarefree), max_search);
  const Univariate f = exact::irreducible_factor(squarefree, where);
  if (exact::degree(f) == 1) return formula(-f[0]);
  require_small(ring, exact::degree(f));
  const Univariate cleared = ring->constant(common_denominator(f)) * f;
  const auto bracket = exact::bracket(f, where);
  const std::string name = unused(name_of(cleared));
  const Formula polynomial = in_symbol(cleared, name);
  Support own = support(polynomial);
  own.push_back(generators.size());
  known_supports.clear();  // the new symbol was not known as a generator
  index.emplace(name, generators.size());
  generators.push_back({name, polynomial, bracket.low, bracket.high});
  supports.push_back(std::move(own));
  return Formula::symbol(name);
}

// radicand = (a / b) e > 0 with e primitive: its root is t / b times the root of (a b^(n-1) /
// t^n) e.
Formula Numbers::Forest::power_root(const Grown& in, const Polynomial& radicand, int n) {
  const exact::RingPtr ring = in.field.ring;
  const auto [terms, denominator] = radicand.numerators();
  Integer content = 0;
  for (const Integer& c : terms.begin()->second) content = gcd(content, c);
  const Integer whole = content * pow(denominator, n - 1);
  const Integer outside = power_part(whole, n);
  Rational factor(outside, denominator),
      primitive(whole / pow(outside, n) * denominator, content);
  factor.canonicalize();
  primitive.canonicalize();
  const Polynomial inside = primitive * radicand;
  if (inside == ring->constant(1)) return Formula(factor);

  const std::pair<int, std::string> key = {n, text(formula(inside))};
  if (const auto known = roots.find(key); known != roots.end())
    return Formula(factor) * known->second;
  Univariate f(n + 1, ring->constant(0));
  f[0] = -inside;
  f[n] = ring->constant(1);
  const Rational bound = exact::enclosure(inside, 4).high + 1;
  const Formula root = root_of(in, f, {0, bound});
  roots.emplace(key, root);
  return Formula(factor) * root;
}

// x^2 + 2 p x + q: the roots are -p - r and -p + r with r^2 = p^2 - q.
Formula Numbers::Forest::quadratic_root(const Grown& in, const Univariate& f,
                                        RootInterval where) {
  const exact::RingPtr ring = in.field.ring;
  const Polynomial middle = Rational(-1, 2) * f[1];
  const auto side = [&](const Rational& end) {
    return exact::sign(ring->constant(end) - middle);
  };
  while (side(where.low) != side(where.high)) where = exact::halved(f, where);
  const Formula r = power_root(in, middle * middle - f[0], 2), centre = formula(middle);
  return side(where.low) == Sign::positive ? centre + r : centre - r;
}

Numbers::Numbers() : forest_(std::make_unique<Forest>()) {}
Numbers::~Numbers() = default;
Numbers::Numbers(Numbers&&) noexcept = default;
Numbers& Numbers::operator=(Numbers&&) noexcept = default;

Formula Numbers::nth_root(const Formula& radicand, int n) {
  exact::require(n >= 2, "nth_root: n < 2");
  const Forest::Grown& in = forest_->field_of(radicand);
  const Polynomial x = forest_->number(radicand);
  const Sign s = exact::sign(x);
  if (s == Sign::negative && n % 2 == 0)
    throw NumberError(std::string(n == 2 ? "square root" : "even root") +
                      " of a negative number (about " + roughly(x) + ")");
  Formula value = 0;
  if (s == Sign::positive) value = forest_->power_root(in, x, n);
  if (s == Sign::negative) value = -forest_->power_root(in, -x, n);
  std::vector<Fact> facts = {{power(value, n) - radicand, Fact::Relation::zero}};
  if (n % 2 == 0) facts.push_back({value, Fact::Relation::nonnegative});
  return Formula::known(value, std::move(facts));
}

Formula Numbers::root(const Formula& polynomial, const std::string& unknown,
                      const Rational& low, const Rational& high) {
  const std::string where = "[" + low.get_str() + ", " + high.get_str() + "]";
  const Forest::Grown& in = forest_->field_of(polynomial);
  Expansion expansion(exact::Ring::make(in.field.ring->tower(), {unknown}), {},
                      in.field.values);
  const Univariate coefficients = exact::univariate(expansion(polynomial), 0);
  if (coefficients.empty()) throw NumberError("every number is a root of 0");
  Univariate f;
  for (const Polynomial& c : coefficients) f.push_back(in.field.ring->embed(c));
  f = exact::squarefree(f);
  const auto roots = exact::real_roots(f, low, high);
  if (roots.empty()) throw NumberError("no root in " + where);
  if (roots.size() > 1) throw NumberError(std::to_string(roots.size()) + " roots in " + where);
  require_small(in.field.ring, exact::degree(f));
  f = exact::irreducible_factor(f, roots.front());
  const Formula value = exact::degree(f) == 2 ? forest_->quadratic_root(in, f, roots.front())
                                              : forest_->root_of(in, f, roots.front());
  return Formula::known(value, {{subst(polynomial, {{unknown, value}}), Fact::Relation::zero},
                                {value - Formula(low), Fact::Relation::nonnegative},
                                {Formula(high) - value, Fact::Relation::nonnegative}});
}

Formula Numbers::inverse(const Formula& x) {
  const Polynomial number = forest_->number(x);
  if (number.is_zero()) throw NumberError("division by 0");
  const Formula value = formula(exact::inverse(number));
  return Formula::known(value, {{x * value - Formula(1), Fact::Relation::zero}});
}

Sign Numbers::sign(const Formula& number) const {
  return exact::sign(forest_->number(number));
}

bool Numbers::equal(const Formula& a, const Formula& b) const {
  return forest_->number(a - b).is_zero();
}

bool Numbers::equal(const Point& a, const Point& b) const {
  return std::ranges::equal(a, b,
                            [&](const Formula& x, const Formula& y) { return equal(x, y); });
}

std::optional<Rational> Numbers::rational(const Formula& number) const {
  return forest_->number(number).rational();
}

Formula Numbers::normal_form(const Formula& number) const {
  return formula(forest_->number(number));
}

double Numbers::approximate(const Formula& number) const {
  return exact::ball(forest_->number(number)).middle;
}

std::pair<Rational, Rational> Numbers::enclosure(const Formula& number,
                                                 const Rational& width) const {
  exact::require(width > 0, "enclosure: width <= 0");
  const Polynomial x = forest_->number(number);
  for (long bits = 32;; bits *= 2) {
    const auto e = exact::enclosure(x, bits);
    if (e.high - e.low <= width) return {e.low, e.high};
  }
}

// Halves are rounded away from 0. Only a rational number can be an exact half, and it is
// enclosed by itself.
std::string Numbers::decimal(const Formula& number, int digits) const {
  exact::require(digits >= 0, "decimal: a negative number of digits");
  const Polynomial x = forest_->number(number);
  const bool negative = exact::sign(x) == Sign::negative;
  const Polynomial scaled = Rational(pow(10, digits)) * (negative ? -x : x);
  const auto rounded = [](const Rational& r) {
    const Rational shifted = r + Rational(1, 2);
    Integer result;
    mpz_fdiv_q(result.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
    return result;
  };
  Integer result;
  if (const auto exact_value = scaled.rational()) {
    result = rounded(*exact_value);
  } else {
    for (long bits = 32;; bits *= 2) {
      const auto e = exact::enclosure(scaled, bits);
      result = rounded(e.low);
      if (result == rounded(e.high)) break;
    }
  }
  std::string text = result.get_str();
  if (std::ssize(text) <= digits) text.insert(0, digits + 1 - text.size(), '0');
  if (digits > 0) text.insert(text.size() - digits, ".");
  return (negative && result != 0 ? "-" : "") + text;
}

const std::vector<Numbers::Generator>& Numbers::generators() const {
  return forest_->generators;
}

const Numbers::Field& Numbers::field(const std::set<std::string>& symbols) const {
  Forest::Support all;
  for (const std::string& symbol : symbols)
    if (const auto found = forest_->index.find(symbol); found != forest_->index.end())
      all = united(all, forest_->supports[found->second]);
  return forest_->grown(all).field;
}

const Numbers::Field& Numbers::field(const Formula& number) const {
  return forest_->field_of(number).field;
}

}  // namespace seam::symbolic
