// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/workshop.h"

#include <algorithm>
#include <ranges>

#include "exact/contract.h"
#include "exact/elementary.h"

// The tower is a field because every generator in it is irreducible over those before: for
// those of the statement that is expected, and whoever breaks it gets evidence that is not
// accepted; for those added here `irreducible_factor` makes it so.

namespace seam::prove {

using certificate::Node;
using certificate::Term;
using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;

namespace {

Rational rational(const std::string& text) {
  Rational result(text);
  result.canonicalize();
  return result;
}

std::string spelled(certificate::Elementary function) {
  using certificate::Elementary;
  return function == Elementary::exp   ? "exp"
         : function == Elementary::log ? "log"
         : function == Elementary::sin ? "sin"
         : function == Elementary::cos ? "cos"
                                       : "pi";
}

}  // namespace

Workshop::Workshop(const certificate::Statement& statement, certificate::Evidence& evidence,
                   const Budget& budget)
    : statement_(&statement), evidence_(&evidence), budget_(&budget) {
  for (const auto& generator : statement.generators) generators_.insert(generator.name);
  for (const Node& node : statement.nodes) {
    std::set<std::string> symbols;
    if (node.kind == Node::Kind::symbol) symbols.insert(node.text);
    for (const Term operand : node.operands)
      symbols.insert(symbols_[operand].begin(), symbols_[operand].end());
    symbols_.push_back(std::move(symbols));
  }
  for (const auto& generator : statement.generators) accept(generator);
  add_circles();
}

void Workshop::add_circles() {
  using certificate::Elementary;
  const auto& numbers = statement_->generators;
  for (const auto& sine : numbers)
    for (const auto& cosine : numbers)
      if (sine.function == Elementary::sin && cosine.function == Elementary::cos &&
          sine.argument == cosine.argument)
        circles_.push_back({sine.name, cosine.name});
  for (const auto& sine : statement_->functions)
    for (const auto& cosine : statement_->functions)
      if (sine.elementary == Elementary::sin && cosine.elementary == Elementary::cos &&
          sine.operand == cosine.operand)
        circles_.push_back({sine.name, cosine.name});
}

void Workshop::accept(const certificate::Generator& generator) {
  if (generator.function != certificate::Elementary::none) {
    const bool is_pi = generator.function == certificate::Elementary::pi;
    const auto value =
        near(generator.function, is_pi ? numbers()->constant(0) : number(generator.argument));
    if (!value) throw Unfit("a number that is too large or too small to be worked out");
    near_.emplace(generator.name, *value);
    transcendental_.push_back(generator.name);
    return;
  }
  generators_.erase(generator.name);  // for this once it is a variable
  const exact::Univariate f =
      exact::univariate(expand(generator.polynomial, {generator.name}), 0);
  generators_.insert(generator.name);
  exact::require(exact::degree(f) >= 1, "prove: a generator of degree below 1");
  if (exact::degree(f) == 1) {  // over transcendental numbers
    near_.emplace(generator.name, *(-f[0] * exact::inverse(f[1])).rational());
    transcendental_.push_back(generator.name);
    rings_.clear();
    expanded_.clear();
    return;
  }
  tower_ = exact::adjoin(exact::monic(f), generator.name,
                         {rational(generator.low), rational(generator.high)});
  rings_.clear();
  expanded_.clear();
}

RingPtr Workshop::ring(const std::vector<std::string>& variables) const {
  auto& ring = rings_[variables];
  if (!ring) ring = exact::Ring::make(tower_, variables);
  return ring;
}

std::vector<const certificate::Function*> Workshop::functions(
    const std::vector<Term>& terms) const {
  std::set<std::string> symbols;
  for (const Term term : terms) symbols.insert(symbols_[term].begin(), symbols_[term].end());
  std::vector<const certificate::Function*> result;
  for (const auto& function : statement_->functions | std::views::reverse) {
    if (!symbols.contains(function.name)) continue;
    symbols.insert(symbols_[function.operand].begin(), symbols_[function.operand].end());
    for (const auto& [sine, cosine] : circles_)
      if (function.name == sine) symbols.insert(cosine);
    result.insert(result.begin(), &function);
  }
  return result;
}

std::optional<std::string> Workshop::cosine(const certificate::Function& function) const {
  for (const auto& [sine, cosine] : circles_)
    if (sine == function.name) return cosine;
  return std::nullopt;
}

std::set<std::string> Workshop::variables(Term term) const {
  std::set<std::string> result = symbols_[term];
  const auto held = functions({term});
  for (const auto* function : held)
    result.insert(symbols_[function->operand].begin(), symbols_[function->operand].end());
  for (const auto* function : held) result.erase(function->name);
  std::erase_if(result, [this](const std::string& name) { return generators_.contains(name); });
  return result;
}

// From the last function on: a radicand brings in earlier ones alone.
Polynomial Workshop::reduced(Polynomial p) {
  const auto names = p.ring().variables();
  for (const auto& function : statement_->functions | std::views::reverse) {
    const auto place =
        static_cast<int>(std::ranges::find(names, function.name) - names.begin());
    if (!function.is_root() || place == std::ssize(names) || p.degree(place) < function.degree)
      continue;
    const Polynomial radicand = expand(function.operand, names);
    const Polynomial symbol = p.ring().variable(place);
    Polynomial sum = p.ring().constant(0), power = p.ring().constant(1);
    int reached = 0;
    for (const auto& [exponents, coefficient] : p.coefficients({place})) {
      const int e = exponents.front();
      for (; reached < e / function.degree; ++reached) power = reduced(power * radicand);
      sum = sum + coefficient * power * symbol.pow(e % function.degree);
    }
    p = sum;
  }
  return circles_.empty() ? p : without_squares(std::move(p));
}

Polynomial Workshop::without_squares(Polynomial p) {
  const auto names = p.ring().variables();
  const auto place_of = [&](const std::string& name) {
    return static_cast<int>(std::ranges::find(names, name) - names.begin());
  };
  for (const auto& [sine, cosine] : circles_) {
    const int s = place_of(sine), c = place_of(cosine);
    if (std::max(s, c) == std::ssize(names) || p.degree(s) < 2) continue;
    const Polynomial x = p.ring().variable(c), square = p.ring().constant(1) - x * x;
    Polynomial sum = p.ring().constant(0);
    for (const auto& [exponents, coefficient] : p.coefficients({s}))
      sum = sum + coefficient * square.pow(exponents.front() / 2) *
                      p.ring().variable(s).pow(exponents.front() % 2);
    p = sum;
  }
  return p;
}

Polynomial Workshop::power(const Polynomial& base, int exponent) {
  if (statement_->functions.empty() && circles_.empty()) return base.pow(exponent);
  Polynomial result = base.ring().constant(1), square = base;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = reduced(result * square);
    if (exponent > 1) square = reduced(square * square);
  }
  return result;
}

Polynomial Workshop::expand(Term term, const std::vector<std::string>& variables) {
  auto& done = expanded_[variables];
  if (const auto known = done.find(term); known != done.end()) return known->second;
  const RingPtr ring = this->ring(variables);
  std::vector<bool> needed(term + 1);
  needed[term] = true;
  for (Term i = term; i >= 0; --i)
    if (needed[i] && !done.contains(i))
      for (const Term operand : statement_->nodes[i].operands) needed[operand] = true;
  for (Term i = 0; i <= term; ++i) {
    if (!needed[i] || done.contains(i)) continue;
    const Node& node = statement_->nodes[i];
    Polynomial value = ring->constant(node.kind == Node::Kind::product ? 1 : 0);
    switch (node.kind) {
      case Node::Kind::constant:
        value = ring->constant(rational(node.text));
        break;
      case Node::Kind::symbol: {
        const auto symbol = ring->symbol(node.text);
        if (const auto number = near_.find(node.text); !symbol && number != near_.end()) {
          value = ring->constant(number->second);
          break;
        }
        if (!symbol)
          throw Unfit("'" + node.text + "' is neither a number nor a bound variable");
        value = *symbol;
        break;
      }
      case Node::Kind::sum:
        for (const Term operand : node.operands) value = value + done.at(operand);
        break;
      case Node::Kind::product:
        for (const Term operand : node.operands) value = reduced(value * done.at(operand));
        break;
      case Node::Kind::power:
        value = power(done.at(node.operands[0]), node.exponent);
        break;
    }
    done.emplace(i, value);
  }
  return done.at(term);
}

Polynomial Workshop::adjoin(const exact::Univariate& squarefree,
                            const exact::RootInterval& where) {
  const exact::Univariate f = exact::irreducible_factor(squarefree, where);
  if (exact::degree(f) == 1) return numbers()->embed(-f[0]);
  const auto bracket = exact::bracket(f, where);
  std::string name;
  for (int i = 1; name.empty() || generators_.contains(name); ++i)
    name = "root(" + std::to_string(i) + ")";
  std::vector<Term> terms;
  const Term symbol = add({Node::Kind::symbol, name, {}, 0});
  for (int i = 0; i <= exact::degree(f); ++i) {
    if (f[i].is_zero()) continue;
    const Term power = add({Node::Kind::power, "", {symbol}, i});
    terms.push_back(add({Node::Kind::product, "", {write(f[i]), power}, 0}));
  }
  evidence_->generators.push_back({name, add({Node::Kind::sum, "", terms, 0}),
                                   bracket.low.get_str(), bracket.high.get_str()});
  tower_ = exact::adjoin(f, name, bracket);
  generators_.insert(name);
  rings_.clear();
  expanded_.clear();
  return *numbers()->symbol(name);
}

std::optional<Rational> Workshop::near(certificate::Elementary function, const Polynomial& at) {
  const auto ring = exact::Ring::make(at.ring().tower(), {"x"});
  const auto bounds =
      exact::enclosure(ring->variable(0), {{spelled(function), ring->embed(at)}}, 192);
  if (!bounds) return std::nullopt;
  const Rational middle = (bounds->low + bounds->high) / 2;
  Integer scaled;
  const Rational shifted = middle * (Integer(1) << 128);
  mpz_fdiv_q(scaled.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  Rational result(scaled, Integer(1) << 128);
  result.canonicalize();
  return result;
}

std::optional<Polynomial> Workshop::near_value(certificate::Elementary function,
                                               const Polynomial& operand) {
  std::vector<Polynomial> places;
  for (const std::string& name : operand.ring().variables())
    places.push_back(numbers()->constant(near_.at(name)));
  const auto value = near(function, operand.substitute(numbers(), places));
  if (!value) return std::nullopt;
  return numbers()->constant(*value);
}

bool Workshop::is_simple(certificate::Elementary function, const Polynomial& operand) {
  return function == certificate::Elementary::log ? operand.rational() == Rational(1)
                                                  : operand.is_zero();
}

Term Workshop::write(certificate::Elementary function, const Polynomial& operand) {
  if (is_simple(function, operand)) return write(*near_value(function, operand));
  const auto symbol = [&](const std::string& name) {
    return add({Node::Kind::symbol, name, {}, 0});
  };
  for (const auto& known : statement_->generators)
    if (known.function == function && expand(known.argument, transcendental_) == operand)
      return symbol(known.name);
  const Term argument = write(operand);
  for (const auto& known : evidence_->generators)
    if (known.function == function && known.argument == argument) return symbol(known.name);
  const auto rational = operand.rational();
  std::string name =
      rational ? spelled(function) + ("(" + rational->get_str() + ")") : std::string();
  for (int i = 1; name.empty() || generators_.contains(name); ++i)
    name = "value(" + std::to_string(i) + ")";
  evidence_->generators.push_back({name, 0, {}, {}, function, argument});
  generators_.insert(name);
  return symbol(name);
}

Term Workshop::add(Node node) {
  std::string key = std::to_string(static_cast<int>(node.kind)) + node.text + "^" +
                    std::to_string(node.exponent);
  for (const Term operand : node.operands) key += " " + std::to_string(operand);
  const auto next = static_cast<Term>(statement_->nodes.size() + evidence_->nodes.size());
  const auto [place, is_new] = written_.emplace(std::move(key), next);
  if (is_new) evidence_->nodes.push_back(std::move(node));
  return place->second;
}

Term Workshop::write(const Rational& value) {
  return add({Node::Kind::constant, value.get_str(), {}, 0});
}

Term Workshop::negated(Term term) {
  return add({Node::Kind::product, "", {write(Rational(-1)), term}, 0});
}

Term Workshop::write(const Polynomial& polynomial) {
  const auto [terms, denominator] = polynomial.numerators();
  const auto& variables = polynomial.ring().variables();
  const auto steps = exact::steps(polynomial.ring().tower());
  std::vector<Term> sum;
  for (const auto& [exponents, coordinates] : terms) {
    for (std::size_t index = 0; index < coordinates.size(); ++index) {
      if (coordinates[index] == 0) continue;
      Rational coefficient(coordinates[index], denominator);
      coefficient.canonicalize();
      std::vector<Term> factors;
      const auto multiply = [&](const std::string& symbol, int exponent) {
        if (exponent == 0) return;
        const Term base = add({Node::Kind::symbol, symbol, {}, 0});
        factors.push_back(exponent == 1 ? base
                                        : add({Node::Kind::power, "", {base}, exponent}));
      };
      std::size_t rest = index;
      for (const exact::Tower* step : steps) {
        const int exponent = static_cast<int>(rest % step->degree());
        rest /= step->degree();
        for (int k = 0; k < exponent; ++k) coefficient *= step->scale();
        multiply(step->symbol(), exponent);
      }
      for (std::size_t v = 0; v < variables.size(); ++v) multiply(variables[v], exponents[v]);
      if (factors.empty() || coefficient != 1)
        factors.insert(factors.begin(), write(coefficient));
      sum.push_back(factors.size() == 1 ? factors[0]
                                        : add({Node::Kind::product, "", factors, 0}));
    }
  }
  if (sum.empty()) return write(Rational(0));
  return sum.size() == 1 ? sum[0] : add({Node::Kind::sum, "", sum, 0});
}

}  // namespace seam::prove
