// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/formula.h"

#include <algorithm>
#include <unordered_map>

#include "exact/contract.h"

// Only constants are folded, and only those foldings are made that hold for every
// value of the symbols: 0 + x, 1 * x, 0 * x (formulas are polynomials: nothing in them
// can be undefined), x^0, x^1. Facts of a known value that is folded away are
// lost on purpose where the value no longer matters (0 * x).
//
// Every walk is memoised by node, so it costs a step a node of the shared tree; depth is
// bounded when a node is built, so no walk overflows the stack.

namespace seam::symbolic {

using exact::Rational;
using exact::require;

struct Formula::Node {
  Kind kind = Kind::constant;
  Rational value;
  std::string name;
  std::vector<Formula> operands;
  int exponent = 0;
  std::vector<Fact> facts;
  std::size_t hash = 0;
  int depth = 0;
};

namespace {

constexpr int max_depth = 5000;
constexpr std::size_t max_bits = 1'000'000;

std::size_t bits(const Rational& value) {
  return mpz_sizeinbase(value.get_num_mpz_t(), 2) + mpz_sizeinbase(value.get_den_mpz_t(), 2);
}

void require_small(std::size_t size) {
  if (size > max_bits) throw FormulaLimit("a number of more than a million bits");
}

std::size_t mix(std::size_t seed, std::size_t value) {
  return (seed ^ value) * 0x9e3779b97f4a7c15ULL + (seed << 7) + (seed >> 3);
}

}  // namespace

Formula::Formula(long value) : Formula(Rational(value)) {}

Formula::Formula(Rational value) {
  auto node = std::make_shared<Node>();
  node->value = std::move(value);
  node->hash = mix(1, std::hash<std::string>()(node->value.get_str()));
  node_ = std::move(node);
}

Formula Formula::symbol(std::string name) {
  auto node = std::make_shared<Node>();
  node->kind = Kind::symbol;
  node->name = std::move(name);
  node->hash = mix(2, std::hash<std::string>()(node->name));
  return Formula(std::move(node));
}

Formula Formula::known(Formula value, std::vector<Fact> facts) {
  auto node = std::make_shared<Node>();
  node->kind = Kind::known;
  node->hash = mix(3, value.node_->hash);
  node->depth = value.node_->depth + 1;
  for (const Fact& fact : facts)
    node->depth = std::max(node->depth, fact.formula.node_->depth + 1);
  if (node->depth > max_depth) throw FormulaLimit("a formula is nested too deeply");
  node->operands.push_back(std::move(value));
  node->facts = std::move(facts);
  return Formula(std::move(node));
}

Formula::Kind Formula::kind() const {
  return node_->kind;
}
const Rational& Formula::value() const {
  require(kind() == Kind::constant, "Formula::value: not a constant");
  return node_->value;
}
const std::string& Formula::name() const {
  require(kind() == Kind::symbol, "Formula::name: not a symbol");
  return node_->name;
}
const std::vector<Formula>& Formula::operands() const {
  return node_->operands;
}
int Formula::exponent() const {
  return node_->exponent;
}
const std::vector<Fact>& Formula::facts() const {
  return node_->facts;
}

bool Formula::is(long value) const {
  return is_constant() && node_->value == value;
}

bool Formula::same(const Formula& other) const {
  if (node_ == other.node_) return true;
  const Node &a = *node_, &b = *other.node_;
  if (a.hash != b.hash || a.kind != b.kind || a.exponent != b.exponent || a.name != b.name ||
      a.value != b.value || a.operands.size() != b.operands.size())
    return false;
  return std::ranges::equal(a.operands, b.operands,
                            [](const Formula& x, const Formula& y) { return x.same(y); });
}

// The sum or product of what is left after the constants are folded into one.
static Formula::Kind kind_of(bool is_sum) {
  return is_sum ? Formula::Kind::sum : Formula::Kind::product;
}

Formula sum(std::vector<Formula> terms) {
  Rational constant = 0;
  std::vector<Formula> rest;
  for (Formula& term : terms) {
    if (!term.is_constant()) {
      rest.push_back(std::move(term));
      continue;
    }
    constant += term.value();
    require_small(bits(constant));
  }
  if (rest.empty()) return Formula(constant);
  if (constant != 0) rest.push_back(Formula(constant));
  if (rest.size() == 1) return rest.front();
  auto node = std::make_shared<Formula::Node>();
  node->kind = kind_of(true);
  node->hash = 5;
  for (const Formula& term : rest) {
    node->hash = mix(node->hash, term.node_->hash);
    node->depth = std::max(node->depth, term.node_->depth + 1);
  }
  if (node->depth > max_depth) throw FormulaLimit("a formula is nested too deeply");
  node->operands = std::move(rest);
  return Formula(std::move(node));
}

Formula product(std::vector<Formula> factors) {
  Rational constant = 1;
  std::vector<Formula> rest;
  for (Formula& factor : factors) {
    if (!factor.is_constant()) {
      rest.push_back(std::move(factor));
      continue;
    }
    constant *= factor.value();
    require_small(bits(constant));
  }
  if (constant == 0) return {0};
  if (rest.empty()) return Formula(constant);
  if (constant != 1) rest.insert(rest.begin(), Formula(constant));
  if (rest.size() == 1) return rest.front();
  auto node = std::make_shared<Formula::Node>();
  node->kind = kind_of(false);
  node->hash = 7;
  for (const Formula& factor : rest) {
    node->hash = mix(node->hash, factor.node_->hash);
    node->depth = std::max(node->depth, factor.node_->depth + 1);
  }
  if (node->depth > max_depth) throw FormulaLimit("a formula is nested too deeply");
  node->operands = std::move(rest);
  return Formula(std::move(node));
}

Formula power(const Formula& base, int exponent) {
  require(exponent >= 0, "power: negative exponent");
  if (exponent == 0) return {1};
  if (exponent == 1) return base;
  if (base.is_constant()) {
    if (bits(base.value()) > 2) require_small(bits(base.value()) * exponent);
    Rational value;
    mpz_pow_ui(value.get_num_mpz_t(), base.value().get_num_mpz_t(), exponent);
    mpz_pow_ui(value.get_den_mpz_t(), base.value().get_den_mpz_t(), exponent);
    return Formula(value);
  }
  auto node = std::make_shared<Formula::Node>();
  node->kind = Formula::Kind::power;
  node->exponent = exponent;
  node->hash = mix(mix(11, base.node_->hash), exponent);
  node->depth = base.node_->depth + 1;
  if (node->depth > max_depth) throw FormulaLimit("a formula is nested too deeply");
  node->operands.push_back(base);
  return Formula(std::move(node));
}

Formula operator+(const Formula& a, const Formula& b) {
  return sum({a, b});
}
Formula operator*(const Formula& a, const Formula& b) {
  return product({a, b});
}
Formula operator-(const Formula& a) {
  return product({Formula(-1), a});
}
Formula operator-(const Formula& a, const Formula& b) {
  if (a.node_ == b.node_) return {0};
  return sum({a, -b});
}

namespace {

using Memo = std::unordered_map<const void*, Formula>;

// Rebuilds a formula with `leaf` applied to its symbols. A known value whose
// symbols stay the same keeps its facts; facts speak of numbers, so they never change.
Formula rebuild(const Formula& f, const std::map<std::string, Formula>& map, Memo& memo) {
  if (f.is_constant() || f.kind() == Formula::Kind::known) return f;
  if (f.kind() == Formula::Kind::symbol) {
    const auto found = map.find(f.name());
    return found == map.end() ? f : found->second;
  }
  if (const auto found = memo.find(f.identity()); found != memo.end()) return found->second;
  std::vector<Formula> operands;
  bool changed = false;
  for (const Formula& operand : f.operands()) {
    operands.push_back(rebuild(operand, map, memo));
    changed = changed || operands.back().identity() != operand.identity();
  }
  Formula result = f;
  if (changed && f.kind() == Formula::Kind::sum) result = sum(std::move(operands));
  if (changed && f.kind() == Formula::Kind::product) result = product(std::move(operands));
  if (changed && f.kind() == Formula::Kind::power) result = power(operands[0], f.exponent());
  memo.emplace(f.identity(), result);
  return result;
}

Formula derive(const Formula& f, const std::string& symbol, Memo& memo) {
  if (f.is_constant() || f.kind() == Formula::Kind::known) return {0};
  if (f.kind() == Formula::Kind::symbol) return {f.name() == symbol ? 1 : 0};
  if (const auto found = memo.find(f.identity()); found != memo.end()) return found->second;
  std::vector<Formula> terms;
  const auto& operands = f.operands();
  switch (f.kind()) {
    case Formula::Kind::sum:
      for (const Formula& term : operands) terms.push_back(derive(term, symbol, memo));
      break;
    case Formula::Kind::product:
      for (std::size_t i = 0; i < operands.size(); ++i) {
        std::vector<Formula> factors = operands;
        factors[i] = derive(operands[i], symbol, memo);
        terms.push_back(product(std::move(factors)));
      }
      break;
    default:  // a power
      terms.push_back(product({Formula(f.exponent()), power(operands[0], f.exponent() - 1),
                               derive(operands[0], symbol, memo)}));
  }
  Formula result = sum(std::move(terms));
  memo.emplace(f.identity(), result);
  return result;
}

void collect(const Formula& f, std::set<std::string>& found, std::set<const void*>& seen) {
  if (f.kind() == Formula::Kind::symbol) found.insert(f.name());
  if (f.operands().empty() || !seen.insert(f.identity()).second) return;
  for (const Formula& operand : f.operands()) collect(operand, found, seen);
}

}  // namespace

Formula diff(const Formula& f, const std::string& symbol) {
  Memo memo;
  return derive(f, symbol, memo);
}

Formula subst(const Formula& f, const std::map<std::string, Formula>& map) {
  Memo memo;
  return rebuild(f, map, memo);
}

std::set<std::string> symbols(const Formula& f) {
  std::set<std::string> found;
  std::set<const void*> seen;
  collect(f, found, seen);
  return found;
}

bool is_generator(const std::string& name) {
  return name.find('(') != std::string::npos;
}

std::set<std::string> variables(const Formula& f) {
  std::set<std::string> found = symbols(f);
  std::erase_if(found, is_generator);
  return found;
}

bool is_number(const Formula& f) {
  return variables(f).empty();
}

}  // namespace seam::symbolic
