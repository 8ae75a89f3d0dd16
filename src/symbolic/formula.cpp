// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/formula.h"

#include <algorithm>
#include <unordered_map>

#include "exact/contract.h"

// Only constants are folded, and only those foldings are made that hold for every
// value of the symbols at which the formula has one: 0 + x, 1 * x, 0 * x, x^0, x^1. What a
// known value rests on stays where it is multiplied by 0, as far as it speaks of variables.
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
  std::vector<int> orders;
  std::vector<Fact> facts;
  std::size_t hash = 0;
  int depth = 0;
  bool polynomial = true;
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

// A node over others: hash, depth and kind of content follow from theirs.
std::shared_ptr<Formula::Node> Formula::node(Kind kind, std::vector<Formula> operands,
                                             int exponent) {
  auto node = std::make_shared<Node>();
  node->kind = kind;
  node->exponent = exponent;
  node->polynomial = kind != Kind::inverse && kind != Kind::root && kind != Kind::applied;
  node->hash = mix(static_cast<std::size_t>(kind) + 3, exponent);
  for (const Formula& operand : operands) {
    node->hash = mix(node->hash, operand.node_->hash);
    node->depth = std::max(node->depth, operand.node_->depth + 1);
    node->polynomial = node->polynomial && operand.node_->polynomial;
  }
  if (node->depth > max_depth) throw FormulaLimit("a formula is nested too deeply");
  node->operands = std::move(operands);
  return node;
}

Formula Formula::known(Formula value, std::vector<Fact> facts) {
  auto result = node(Kind::known, {std::move(value)});
  for (const Fact& fact : facts) {
    result->depth = std::max(result->depth, fact.formula.node_->depth + 1);
    result->polynomial = result->polynomial && is_number(fact.formula);
  }
  if (result->depth > max_depth) throw FormulaLimit("a formula is nested too deeply");
  result->facts = std::move(facts);
  return Formula(std::move(result));
}

Formula Formula::applied(std::string function, std::vector<Formula> operands,
                         std::vector<int> orders) {
  require(!operands.empty(), "Formula::applied: a function of nothing");
  if (orders.empty()) orders.resize(operands.size(), 0);
  require(orders.size() == operands.size(), "Formula::applied: not one order an operand");
  auto result = node(Kind::applied, std::move(operands));
  result->hash = mix(result->hash, std::hash<std::string>()(function));
  for (const int order : orders) result->hash = mix(result->hash, order);
  result->name = std::move(function);
  result->orders = std::move(orders);
  return Formula(std::move(result));
}

Formula::Kind Formula::kind() const {
  return node_->kind;
}
const Rational& Formula::value() const {
  require(kind() == Kind::constant, "Formula::value: not a constant");
  return node_->value;
}
const std::string& Formula::name() const {
  require(kind() == Kind::symbol || kind() == Kind::applied, "Formula::name: it has none");
  return node_->name;
}
const std::vector<Formula>& Formula::operands() const {
  return node_->operands;
}
int Formula::exponent() const {
  return node_->exponent;
}
const std::vector<int>& Formula::orders() const {
  return node_->orders;
}
const std::vector<Fact>& Formula::facts() const {
  return node_->facts;
}

bool Formula::is_polynomial() const {
  return node_->polynomial;
}
bool Formula::is(long value) const {
  return is_constant() && node_->value == value;
}

bool Formula::same(const Formula& other) const {
  if (node_ == other.node_) return true;
  const Node &a = *node_, &b = *other.node_;
  if (a.hash != b.hash || a.kind != b.kind || a.exponent != b.exponent || a.name != b.name ||
      a.value != b.value || a.orders != b.orders || a.operands.size() != b.operands.size())
    return false;
  return std::ranges::equal(a.operands, b.operands,
                            [](const Formula& x, const Formula& y) { return x.same(y); });
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
  return Formula(Formula::node(Formula::Kind::sum, std::move(rest)));
}

namespace {

void collect_needs(const Formula& f, std::vector<Fact>& needs, std::set<const void*>& seen) {
  if (f.is_polynomial() || !seen.insert(f.identity()).second) return;
  const auto& operands = f.operands();
  if (f.kind() == Formula::Kind::inverse)
    needs.push_back({operands[0], Fact::Relation::nonzero});
  for (const Fact& fact : f.facts())
    if (!is_number(fact.formula)) needs.push_back(fact);
  for (const Formula& operand : operands) collect_needs(operand, needs, seen);
}

// The constant, where these formulas have a value.
Formula resting(long constant, const std::vector<Formula>& on) {
  std::vector<Fact> needs;
  std::set<const void*> seen;
  for (const Formula& f : on) collect_needs(f, needs, seen);
  return needs.empty() ? Formula(constant)
                       : Formula::known(Formula(constant), std::move(needs));
}

}  // namespace

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
  if (constant == 0) return resting(0, rest);
  if (rest.empty()) return Formula(constant);
  if (constant != 1) rest.insert(rest.begin(), Formula(constant));
  if (rest.size() == 1) return rest.front();
  return Formula(Formula::node(Formula::Kind::product, std::move(rest)));
}

Formula power(const Formula& base, int exponent) {
  require(exponent >= 0, "power: negative exponent");
  if (exponent == 0) return resting(1, {base});
  if (exponent == 1) return base;
  if (base.is_constant()) {
    if (bits(base.value()) > 2) require_small(bits(base.value()) * exponent);
    Rational value;
    mpz_pow_ui(value.get_num_mpz_t(), base.value().get_num_mpz_t(), exponent);
    mpz_pow_ui(value.get_den_mpz_t(), base.value().get_den_mpz_t(), exponent);
    return Formula(value);
  }
  return Formula(Formula::node(Formula::Kind::power, {base}, exponent));
}

Formula inverse(const Formula& x) {
  if (x.is_constant() && !x.is(0)) return Formula(Rational(1) / x.value());
  return Formula(Formula::node(Formula::Kind::inverse, {x}));
}

Formula root(const Formula& radicand, int index) {
  require(index >= 2 && index % 2 == 0, "root: an odd index");
  return Formula(Formula::node(Formula::Kind::root, {radicand}, index));
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
  if (a.node_ == b.node_) return resting(0, {a});
  return sum({a, -b});
}

namespace {

using Memo = std::unordered_map<const void*, Formula>;

using Value = std::function<Formula(const Formula&)>;

// Rebuilds a formula with other values for its symbols and functions. Facts about numbers never
// change.
Formula rebuild(const Formula& f, const Value& value, Memo& memo) {
  if (f.is_constant() || (f.kind() == Formula::Kind::known && f.is_polynomial())) return f;
  if (f.kind() == Formula::Kind::symbol) return value(f);
  if (const auto found = memo.find(f.identity()); found != memo.end()) return found->second;
  std::vector<Formula> operands;
  bool changed = f.kind() == Formula::Kind::known;
  for (const Formula& operand : f.operands()) {
    operands.push_back(rebuild(operand, value, memo));
    changed = changed || operands.back().identity() != operand.identity();
  }
  const auto rebuilt = [&]() -> Formula {
    switch (f.kind()) {
      case Formula::Kind::sum:
        return sum(std::move(operands));
      case Formula::Kind::product:
        return product(std::move(operands));
      case Formula::Kind::power:
        return power(operands[0], f.exponent());
      case Formula::Kind::inverse:
        return inverse(operands[0]);
      case Formula::Kind::root:
        return root(operands[0], f.exponent());
      case Formula::Kind::applied:
        return Formula::applied(f.name(), std::move(operands), f.orders());
      default: {
        std::vector<Fact> facts;
        for (const Fact& fact : f.facts())
          facts.push_back({rebuild(fact.formula, value, memo), fact.relation});
        return Formula::known(operands[0], std::move(facts));
      }
    }
  };
  Formula result = changed ? rebuilt() : f;
  if (result.kind() == Formula::Kind::applied) result = value(result);
  memo.emplace(f.identity(), result);
  return result;
}

// The derivative of an applied function in its operand i.
Formula derived_in(const Formula& f, std::size_t i) {
  const auto& operands = f.operands();
  if (f.name() == "exp") return f;
  if (f.name() == "sin") return Formula::applied("cos", operands);
  if (f.name() == "cos") return -Formula::applied("sin", operands);
  if (f.name() == "log") return inverse(operands[0]);
  std::vector<int> orders = f.orders();
  ++orders[i];
  return Formula::applied(f.name(), operands, std::move(orders));
}

Formula derive(const Formula& f, const std::string& symbol, Memo& memo) {
  if (f.is_constant() || (f.kind() == Formula::Kind::known && f.is_polynomial())) return {0};
  if (f.kind() == Formula::Kind::symbol) return {f.name() == symbol ? 1 : 0};
  if (const auto found = memo.find(f.identity()); found != memo.end()) return found->second;
  const auto& operands = f.operands();
  const auto inner = [&] { return derive(operands[0], symbol, memo); };
  const auto derived = [&]() -> Formula {
    std::vector<Formula> terms;
    switch (f.kind()) {
      case Formula::Kind::sum:
        for (const Formula& term : operands) terms.push_back(derive(term, symbol, memo));
        return sum(std::move(terms));
      case Formula::Kind::product:
        for (std::size_t i = 0; i < operands.size(); ++i) {
          std::vector<Formula> factors = operands;
          factors[i] = derive(operands[i], symbol, memo);
          terms.push_back(product(std::move(factors)));
        }
        return sum(std::move(terms));
      case Formula::Kind::power:
        return product({Formula(f.exponent()), power(operands[0], f.exponent() - 1), inner()});
      case Formula::Kind::inverse:
        return product({Formula(-1), power(f, 2), inner()});
      case Formula::Kind::root:
        return product({inner(), inverse(Formula(f.exponent()) * power(f, f.exponent() - 1))});
      case Formula::Kind::applied:
        for (std::size_t i = 0; i < operands.size(); ++i) {
          const Formula rate = derive(operands[i], symbol, memo);
          if (!rate.is(0)) terms.push_back(rate * derived_in(f, i));
        }
        return sum(std::move(terms));
      default:
        return Formula::known(inner(), f.facts());
    }
  };
  Formula result = derived();
  memo.emplace(f.identity(), result);
  return result;
}

}  // namespace

Formula diff(const Formula& f, const std::string& symbol) {
  Memo memo;
  return derive(f, symbol, memo);
}

Formula subst(const Formula& f, const std::map<std::string, Formula>& map) {
  Memo memo;
  const auto value = [&map](const Formula& g) {
    if (g.kind() != Formula::Kind::symbol) return g;
    const auto found = map.find(g.name());
    return found == map.end() ? g : found->second;
  };
  return rebuild(f, value, memo);
}

Formula replace_functions(const Formula& f,
                          const std::function<Formula(const Formula&)>& value) {
  Memo memo;
  const auto of_arbitrary = [&value](const Formula& g) {
    const bool is_arbitrary = g.kind() == Formula::Kind::applied && !is_elementary(g.name());
    return is_arbitrary ? value(g) : g;
  };
  return rebuild(f, of_arbitrary, memo);
}

}  // namespace seam::symbolic
