// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "claims/variable.h"
#include "symbolic/coefficients.h"

// What is read off a polynomial that was multiplied out (its degree, its coefficients in the
// power or the Bernstein basis) rests on the identity "polynomial = sum of coefficient times
// basis function", which is stated beside it.

namespace seam::claims {
namespace {

using symbolic::Coefficients;

// The components of a value whose Bernstein coefficients are wanted.
Vector components_of(const Call& call, const Value& value) {
  if (const auto* scalar = value.as<Scalar>()) return {*scalar};
  if (const auto* field = value.as<Field>()) return field->components;
  return as_vector(call.evaluator, value, call[0]);
}

int degree_of(const Coefficients& coefficients) {
  int degree = 0;
  for (const auto& entry : coefficients) {
    int total = 0;
    for (const int exponent : entry.first) total += exponent;
    degree = std::max(degree, total);
  }
  return degree;
}

Formula monomial(const std::vector<std::string>& variables, const std::vector<int>& exponents) {
  Formula result = 1;
  for (std::size_t i = 0; i < variables.size(); ++i)
    result *= symbolic::power(Formula::symbol(variables[i]), exponents[i]);
  return result;
}

Coefficients expanded(const Call& call, const Formula& f,
                      const std::vector<std::string>& variables) {
  Coefficients coefficients = symbolic::coefficients(f, variables, call.evaluator.numbers);
  // For single integers it could be 0.
  if (!coefficients.empty() &&
      holds_integer(call.evaluator, Scalar(coefficients.rbegin()->second)))
    throw Unsupported("a polynomial whose leading coefficient holds an integer parameter");
  Formula rebuilt = 0;
  for (const auto& [exponents, coefficient] : coefficients)
    rebuilt += coefficient * monomial(variables, exponents);
  call.evaluator.sides.push_back(
      symbolic::atom(symbolic::Zero{f - rebuilt}, "the polynomial has these coefficients"));
  return coefficients;
}

// The true degree: the leading coefficient is stated not to be 0.
Value degree(const Call& call) {
  const Value first = call.count() == 1 ? call.value(0) : Value{};
  if (call.count() == 1) {
    if (const auto* patch = first.as<geometry::Patch>()) {
      if (patch->shape() == geometry::Patch::Shape::triangle)
        return {Scalar(static_cast<long>(patch->degree_u()))};
      return {Vector{Scalar(static_cast<long>(patch->degree_u())),
                     Scalar(static_cast<long>(patch->degree_v()))}};
    }
    if (const auto* curve = first.as<geometry::Curve>())
      return {Scalar(static_cast<long>(curve->degree()))};
    fail(call.at, "expected a patch or a curve, or a variable as the second argument");
  }
  const Variable variable(call, call[1]);
  const Value value = call.evaluator.evaluate(call[0], variable.scope());
  Vector components;
  if (value.as<Vector>())
    components = *value.as<Vector>();
  else
    components = {as_scalar(call.evaluator, value, call[0])};
  int highest = 0;
  Formula leading = 0;
  for (const Scalar& component : components) {
    const Formula f = as_formula(call.evaluator, {component}, call[0]);
    const Coefficients coefficients = expanded(call, f, {variable.symbol()});
    const int d = degree_of(coefficients);
    if (!coefficients.empty() && (d > highest || leading.is(0))) {
      highest = d;
      leading = coefficients.at({d});
    }
  }
  if (!symbolic::is_number(leading))
    throw Unsupported("a degree whose leading coefficient holds a variable");
  leading = scalar_of(leading, call.evaluator.numbers).numerator;
  if (!leading.is_constant())
    return {Scalar(
        Formula::known(Formula(highest), {{leading, symbolic::Fact::Relation::nonzero}}))};
  return {Scalar(static_cast<long>(highest))};
}

// How many coefficients there are must be certain: different monomials may be dependent where
// they hold functions or numbers that are not algebraic.
void require_nonzero(const Formula& leading, Numbers& numbers) {
  const Formula f = scalar_of(leading, numbers).numerator;
  const bool is_certain =
      symbolic::is_number(f)
          ? numbers.sign(f) != exact::Sign::zero
          : !symbolic::vanishes(f, numbers) &&
                ((f.is_polynomial() && numbers.field(f).transcendental.empty()) ||
                 symbolic::monomials(f, numbers).size() == 1);
  if (!is_certain) throw Unsupported("coefficients of which the last may be 0");
}

Value coefficients(const Call& call) {
  const Variable variable(call, call[1]);
  const Value value = call.evaluator.evaluate(call[0], variable.scope());
  const Formula f = as_formula(call.evaluator, value, call[0]);
  const Coefficients found = expanded(call, f, {variable.symbol()});
  if (const int d = degree_of(found); d > 0)
    require_nonzero(found.at({d}), call.evaluator.numbers);
  List list;
  for (int d = 0; d <= degree_of(found); ++d) {
    const auto entry = found.find({d});
    const Formula coefficient = entry == found.end() ? Formula(0) : entry->second;
    list.items.push_back({scalar_of(coefficient, call.evaluator.numbers)});
  }
  return {list};
}

exact::Rational multinomial(int n, const std::vector<int>& parts) {
  exact::Integer value, below;
  mpz_fac_ui(value.get_mpz_t(), n);
  for (const int part : parts) {
    mpz_fac_ui(below.get_mpz_t(), part);
    mpz_divexact(value.get_mpz_t(), value.get_mpz_t(), below.get_mpz_t());
  }
  return value;
}

// The Bernstein coefficients of one polynomial in `variables` on a simplex, at degree n: for
// each exponent vector (the last entry fills up to n), rows by the second variable, the first
// one fastest.
std::vector<Formula> simplex_coefficients(const Coefficients& power_basis,
                                          std::size_t dimension, int n) {
  std::vector<Formula> result;
  std::vector<int> index(dimension, 0);
  const auto coefficient = [&] {
    Formula total = 0;
    for (const auto& [exponents, c] : power_basis) {
      std::vector<int> above = index, full = index;
      int used = 0, sum = 0;
      bool inside = true;
      for (std::size_t i = 0; i < dimension; ++i) {
        above[i] -= exponents[i];
        inside = inside && above[i] >= 0;
        used += exponents[i];
        sum += index[i];
      }
      if (!inside || used > n) continue;
      full.push_back(n - sum);
      above.push_back(n - sum);
      total += Formula(multinomial(n - used, above) / multinomial(n, full)) * c;
    }
    return total;
  };
  const auto run = [&](auto&& self, int k, int left) -> void {
    for (index[k] = 0; index[k] <= left; ++index[k]) {
      if (k == 0)
        result.push_back(coefficient());
      else
        self(self, k - 1, left - index[k]);
    }
    index[k] = 0;
  };
  run(run, static_cast<int>(dimension) - 1, n);
  return result;
}

// On the square: tensor product, row by row.
std::vector<Formula> square_coefficients(const Coefficients& power_basis, int m, int n) {
  std::vector<Formula> result;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= m; ++i) {
      Formula total = 0;
      for (const auto& [e, c] : power_basis) {
        if (e[0] > i || e[1] > j) continue;
        const exact::Rational share = multinomial(m - e[0], {i - e[0], m - i}) *
                                      multinomial(n - e[1], {j - e[1], n - j}) /
                                      (multinomial(m, {i, m - i}) * multinomial(n, {j, n - j}));
        total += Formula(share) * c;
      }
      result.push_back(std::move(total));
    }
  return result;
}

int wanted_degree(const Call& call, int least) {
  if (call.count() < 3) return least;
  const long degree = call.integer(2);
  if (degree < least || degree > 200)
    fail(call[2], "expected a degree from " + std::to_string(least) + " (its own) to 200");
  return static_cast<int>(degree);
}

Formula reduced(const Call& call, const Formula& f) {
  return symbolic::is_number(f) ? call.evaluator.numbers.normal_form(f) : f;
}

Value on_region(const Call& call, const Region& region) {
  if (region.square && call.count() > 2)
    throw Unsupported("Bernstein coefficients on a square at a degree other than their own");
  std::vector<std::unique_ptr<Variable>> bound;
  std::vector<std::string> variables;
  Scope inner{&call.scope, {}};
  const char* const spelled[] = {"u", "v", "w", "x", "y", "z", "s", "t"};
  Value value;
  // A formula is one in u, v (, w …); a function on a patch has parameters of its own.
  for (int i = 0; i < region.dimension; ++i) {
    const Expression name{Expression::Kind::name, spelled[i], {}, call[0].span};
    bound.push_back(std::make_unique<Variable>(call, name));
    variables.push_back(bound.back()->symbol());
    inner.values[spelled[i]] = {Scalar(Formula::symbol(variables.back()))};
  }
  value = call.evaluator.evaluate(call[0], inner);
  if (value.as<Field>()) variables = {geometry::parameter_u, geometry::parameter_v};
  const Vector components = components_of(call, value);
  if (variables.size() != static_cast<std::size_t>(region.dimension))
    fail(call[1], "this domain has not the dimension of the function");

  std::vector<Coefficients> expansions;
  int total = 0, m = 0, n = 0;
  for (const Scalar& component : components) {
    const Formula f = as_formula(call.evaluator, {component}, call[0]);
    expansions.push_back(expanded(call, f, variables));
    total = std::max(total, degree_of(expansions.back()));
    for (const auto& entry : expansions.back()) {
      m = std::max(m, entry.first[0]);
      n = std::max(n, entry.first.back());
    }
  }
  const int degree = region.square ? 0 : wanted_degree(call, total);
  std::vector<std::vector<Formula>> columns;
  for (const Coefficients& expansion : expansions)
    columns.push_back(region.square
                          ? square_coefficients(expansion, m, n)
                          : simplex_coefficients(expansion, variables.size(), degree));
  List list;
  for (std::size_t k = 0; k < columns.front().size(); ++k) {
    Vector entry;
    for (const auto& column : columns) entry.emplace_back(reduced(call, column[k]));
    list.items.push_back(entry.size() == 1 ? Value{entry[0]} : Value{entry});
  }
  return {list};
}

// bernstein(E, u): on [0, 1]; vectors entrywise, at the largest of their degrees.
Value on_unit_interval(const Call& call) {
  const Variable variable(call, call[1]);
  const Value value = call.evaluator.evaluate(call[0], variable.scope());
  if (value.as<Field>())
    fail(call[0], "a function on a patch has no named variable",
         "its domain is 'triangle' or 'square'");
  const Vector components = components_of(call, value);
  std::vector<Coefficients> expansions;
  int least = 0;
  for (const Scalar& component : components) {
    const Formula f = as_formula(call.evaluator, {component}, call[0]);
    expansions.push_back(expanded(call, f, {variable.symbol()}));
    least = std::max(least, degree_of(expansions.back()));
  }
  const int degree = wanted_degree(call, least);
  List list;
  std::vector<std::vector<Formula>> columns;
  for (const Coefficients& expansion : expansions)
    columns.push_back(simplex_coefficients(expansion, 1, degree));
  for (int k = 0; k <= degree; ++k) {
    Vector entry;
    for (const auto& column : columns) entry.emplace_back(reduced(call, column[k]));
    list.items.push_back(value.as<Scalar>() ? Value{entry[0]} : Value{entry});
  }
  return {list};
}

Value bernstein(const Call& call) {
  if (call[1].kind == Expression::Kind::name || call[1].kind == Expression::Kind::call) {
    const bool word = call[1].kind == Expression::Kind::call || call[1].text == "triangle" ||
                      call[1].text == "square";
    if (word) {
      const Value region = call.value(1);
      if (const auto* found = region.as<Region>()) return on_region(call, *found);
    }
  }
  return on_unit_interval(call);
}

}  // namespace

const Builtins& coefficient_builtins() {
  static const Builtins table = {{"degree", {1, 2, degree}},
                                 {"coefficients", {2, 2, coefficients}},
                                 {"bernstein", {2, 3, bernstein}}};
  return table;
}

}  // namespace seam::claims
