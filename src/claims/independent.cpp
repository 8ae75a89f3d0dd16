// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/stating.h"
#include "symbolic/coefficients.h"

// Arbitrary functions, and curves `generic`, are smooth functions on an open interval (of two
// numbers: an open rectangle), which "for all t" runs through. Each of their values and
// derivatives at an argument becomes a real variable: x''(t) becomes `x''{t}`.
//
// Why that is right for what is proven: whatever the functions are, and wherever the arguments
// lie, those values are some real numbers, and what is proven holds for all.
//
// Why what fails for some numbers fails for some functions: a polynomial may have any values
// and derivatives up to any order at finitely many points that are different. So a point at
// which the statement fails gives functions, if no function stands there at two arguments that
// may be equal. Two arguments with a difference that is not identically 0, the variables of
// which occur nowhere else, can be chosen to be different. In all other cases nothing is
// refuted.
//
// An assumption "for all t: A(t)" is used at the arguments that the functions have. A point at
// which the statement fails although A holds there gives functions with A nearby, on a smaller
// interval, if A consists of strict inequalities about the functions at t, without t itself,
// and all functions stand at one argument; if not, nothing is refuted. Nor is anything where an
// argument holds a parameter that meets a condition, which its function does not show.

namespace seam::claims {
namespace {

using Operands = std::vector<Formula>;

bool are_same(const Operands& a, const Operands& b) {
  return std::ranges::equal(a, b, [](const Formula& x, const Formula& y) { return x.same(y); });
}

// `x''{t}[1]`; the braces stand for parentheses, which only the names of numbers hold.
std::string name_of(const Formula& applied) {
  const std::string& function = applied.name();
  const std::size_t index = std::min(function.find('['), function.size());
  std::string orders, operands;
  if (applied.orders().size() == 1) {
    orders = std::string(applied.orders()[0], '\'');
  } else {
    for (const int order : applied.orders()) orders += "_" + std::to_string(order);
    if (std::ranges::all_of(applied.orders(), [](int order) { return order == 0; }))
      orders.clear();
  }
  for (const Formula& operand : applied.operands())
    operands += (operands.empty() ? "" : ", ") + symbolic::text(operand, 40);
  std::ranges::replace(operands, '(', '{');
  std::ranges::replace(operands, ')', '}');
  return function.substr(0, index) + orders + "{" + operands + "}" + function.substr(index);
}

class Jets {
 public:
  explicit Jets(Evaluator& evaluator) : evaluator_(evaluator) {}

  Formula operator()(const Formula& f) {
    return symbolic::replace_functions(f, [this](const Formula& written) {
      const Formula applied = canonical(written);
      const Formula symbol = Formula::symbol(variable(applied));
      add(applied);
      return symbol;
    });
  }
  symbolic::Constraint operator()(const symbolic::Constraint& c) {
    return {(*this)(c.formula), c.relation};
  }

  const std::vector<std::string>& variables() const { return variables_; }
  // What is 0, for two arguments are one.
  const std::vector<Formula>& equal() const { return equal_; }

  // All arguments of each function.
  const std::map<std::string, std::vector<Operands>>& arguments() const { return arguments_; }

  std::vector<Operands> all_arguments() const {
    std::vector<Operands> all;
    for (const auto& entry : arguments_)
      for (const Operands& operands : entry.second)
        if (std::ranges::none_of(all, [&](const auto& o) { return are_same(o, operands); }))
          all.push_back(operands);
    return all;
  }

 private:
  // With each operand as it was written first.
  Formula canonical(const Formula& applied) {
    std::vector<Formula> operands;
    for (const Formula& operand : applied.operands()) {
      const auto is_equal = [&](const Formula& other) {
        return other.same(operand) || (operand.is_polynomial() && other.is_polynomial() &&
                                       symbolic::vanishes(operand - other, evaluator_.numbers));
      };
      const auto known = std::ranges::find_if(operands_, is_equal);
      if (known == operands_.end()) {
        operands_.push_back(operand);
        operands.push_back(operand);
        continue;
      }
      operands.push_back(*known);
      if (!known->same(operand)) equal_.push_back(operand - *known);
    }
    return Formula::applied(applied.name(), std::move(operands), applied.orders());
  }

  // No other value has it, whatever has been released since.
  std::string new_name(const Formula& applied) {
    for (;;) {
      const std::string name = evaluator_.bind(name_of(applied));
      const bool is_taken = std::ranges::any_of(
          evaluator_.jets, [&](const auto& jet) { return jet.second == name; });
      if (!is_taken) return name;
    }
  }

  std::string variable(const Formula& applied) {
    auto& jets = evaluator_.jets;
    auto known =
        std::ranges::find_if(jets, [&](const auto& jet) { return jet.first.same(applied); });
    if (known == jets.end()) known = jets.insert(jets.end(), {applied, new_name(applied)});
    if (std::ranges::find(variables_, known->second) == variables_.end())
      variables_.push_back(known->second);
    return known->second;
  }

  void add(const Formula& applied) {
    auto& all = arguments_[applied.name()];
    const bool is_known = std::ranges::any_of(
        all, [&](const Operands& operands) { return are_same(operands, applied.operands()); });
    if (!is_known) all.push_back(applied.operands());
  }

  Evaluator& evaluator_;
  std::vector<std::string> variables_;
  std::vector<Formula> operands_, equal_;
  std::map<std::string, std::vector<Operands>> arguments_;
};

// Whether arguments are different for some values of variables that are not these.
bool may_differ(const Operands& a, const Operands& b, const std::set<std::string>& taken,
                const Numbers& numbers) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Formula difference = a[i] - b[i];
    if (!difference.is_polynomial() || symbolic::vanishes(difference, numbers)) continue;
    const auto held = symbolic::variables(difference);
    if (std::ranges::none_of(held, [&](const auto& v) { return taken.contains(v); }))
      return true;
  }
  return false;
}

// Whether there is room around every value of the arguments.
bool is_open(const Operands& operands, const Context& context) {
  for (const Formula& operand : operands)
    for (const std::string& variable : symbolic::variables(operand))
      for (const symbolic::Simplex& factor : context.factors)
        if (std::ranges::find(factor.variables, variable) != factor.variables.end())
          return false;
  return true;
}

bool is_strict(const symbolic::Constraint& c) {
  return c.relation == Relation::positive || c.relation == Relation::negative ||
         c.relation == Relation::nonzero;
}

// Whether it speaks of functions at these variables and of nothing else at them.
bool is_local(const Formula& f, const std::vector<std::string>& variables) {
  bool is_at_them = true;
  const Formula rest = symbolic::replace_functions(f, [&](const Formula& applied) {
    is_at_them =
        is_at_them && std::ranges::equal(applied.operands(), variables,
                                         [](const Formula& operand, const std::string& v) {
                                           return operand.kind() == Formula::Kind::symbol &&
                                                  operand.name() == v;
                                         });
    return Formula(1);
  });
  const auto held = symbolic::variables(rest);
  return is_at_them &&
         std::ranges::none_of(variables, [&](const auto& v) { return held.contains(v); });
}

// Whether a parameter in it meets a condition.
bool is_conditional(const Operands& operands, const std::vector<Parameter>& parameters) {
  return std::ranges::any_of(operands, [&](const Formula& operand) {
    const auto held = symbolic::variables(operand);
    return std::ranges::any_of(parameters, [&](const Parameter& p) {
      return !p.where.empty() && held.contains(p.name);
    });
  });
}

}  // namespace

Stating::Independent Stating::independent(const Formula& f, const Context& context) {
  Jets jets(evaluator);
  Independent result{jets(f), context, true};
  auto& where = result.context.where;
  for (symbolic::Constraint& c : where) c = jets(c);
  result.context.given.clear();
  const std::vector<Operands> places = jets.all_arguments();
  for (const Assumption& assumption : context.given) {
    std::vector<std::map<std::string, Formula>> instances;
    for (const Operands& operands : places) {
      if (operands.size() != assumption.variables.size()) continue;
      auto& instance = instances.emplace_back();
      for (std::size_t i = 0; i < operands.size(); ++i)
        instance.emplace(assumption.variables[i], operands[i]);
    }
    if (instances.empty()) {
      instances.emplace_back();
      for (const std::string& variable : assumption.variables)
        result.context.lines.push_back(variable);
    }
    for (const auto& instance : instances)
      for (const symbolic::Constraint& c : assumption.constraints) {
        where.push_back(jets({symbolic::subst(c.formula, instance), c.relation}));
        result.is_exact =
            result.is_exact && is_strict(c) && is_local(c.formula, assumption.variables);
      }
  }
  if (!jets.variables().empty()) speaks_of_functions = true;
  for (const Formula& difference : jets.equal())
    guards.push_back(symbolic::atom(symbolic::Zero{difference}, "the arguments are equal"));
  for (const std::string& variable : jets.variables()) result.context.lines.push_back(variable);

  std::set<std::string> taken = symbolic::variables(result.formula);
  for (const symbolic::Constraint& c : where) taken.merge(symbolic::variables(c.formula));
  for (const auto& entry : jets.arguments())
    for (std::size_t i = 0; i < entry.second.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        result.is_exact = result.is_exact && may_differ(entry.second[i], entry.second[j], taken,
                                                        evaluator.numbers);
  for (const Operands& operands : jets.all_arguments())
    result.is_exact = result.is_exact && !is_conditional(operands, evaluator.parameters);
  if (!context.given.empty()) {
    const std::vector<Operands> all = jets.all_arguments();
    result.is_exact = result.is_exact && all.size() == 1 && is_open(all.front(), context);
  }
  return result;
}

}  // namespace seam::claims
