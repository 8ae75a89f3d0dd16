// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/context.h"

#include <algorithm>
#include <utility>

// A name means one thing throughout. Evidence could otherwise turn a variable of the
// statement into a number of its own choice.
//
// A function f stands where it has a value for its root, so that f^degree may be replaced by
// its operand; of sin(a) the square may be replaced by 1 - cos(a)^2, if that cosine comes
// before. An operand holds earlier functions alone: rewriting ends.

namespace seam::check {
namespace {

using certificate::Evidence;
using certificate::Function;
using certificate::Generator;
using certificate::Node;
using certificate::Statement;
using certificate::Term;

std::vector<std::string> declared_variables(const Statement& statement) {
  std::vector<std::string> names;
  const auto append = [&names](const std::vector<std::string>& more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  for (const auto& obligation : statement.obligations) {
    if (const auto* sign = std::get_if<certificate::Sign>(&obligation))
      for (const auto& factor : sign->domain.factors) append(factor.variables);
    if (const auto* solutions = std::get_if<certificate::Solutions>(&obligation)) {
      append(solutions->domain.variables);
      append(solutions->for_all);
      append({solutions->unknown});
    }
    const auto append_system = [&](const auto& stated) {
      for (const auto& factor : stated.domain.factors) append(factor.variables);
      append(stated.for_all);
      append(stated.unknowns);
    };
    if (const auto* only = std::get_if<certificate::OnlySolutions>(&obligation))
      append_system(*only);
    if (const auto* one = std::get_if<certificate::OneSolution>(&obligation))
      append_system(*one);
  }
  return names;
}

}  // namespace

Context::Context(const Statement& statement, const Evidence& evidence, Meter& meter)
    : statement_(&statement),
      evidence_(&evidence),
      meter_(&meter),
      ring_(meter),
      tower_(ring_),
      known_(statement.nodes.size() + evidence.nodes.size()) {
  name_symbols();
  accept_generators();
  accept_functions();
}

void Context::name_symbols() {
  const auto add = [this](const std::string& name) {
    meter_->charge(name.size());
    return symbols_.emplace(name, static_cast<int>(symbols_.size())).second;
  };
  const auto add_generator = [&](const Generator& generator) {
    demand(add(generator.name), "degenerate: two numbers have one name");
  };
  std::ranges::for_each(statement_->generators, add_generator);
  const int stated = static_cast<int>(symbols_.size());
  std::ranges::for_each(evidence_->generators, add_generator);
  generators_ = static_cast<int>(symbols_.size());

  const auto add_variable = [&](const std::string& name, int below) {
    add(name);
    const int index = symbols_.at(name);
    demand(index < below || index >= generators_,
           "degenerate: a number has the name of a variable");
  };
  std::set<std::string> functions;
  for (const Function& function : statement_->functions) functions.insert(function.name);
  const auto is_variable = [&functions](const Node& node) {
    return node.kind == Node::Kind::symbol && !functions.contains(node.text);
  };
  for (const std::string& name : declared_variables(*statement_)) add_variable(name, 0);
  for (const Node& node : statement_->nodes)
    if (is_variable(node)) add_variable(node.text, stated);
  for (const Node& node : evidence_->nodes)
    if (is_variable(node)) add_variable(node.text, generators_);
  first_function_ = static_cast<int>(symbols_.size());
  for (const Function& function : statement_->functions)
    demand(add(function.name), "degenerate: a function has the name of something else");
}

void Context::accept_generators() {
  for (const auto* generators : {&statement_->generators, &evidence_->generators})
    for (const Generator& generator : *generators)
      if (generator.function == certificate::Elementary::none)
        tower_.extend(value(generator.polynomial), rational(generator.low),
                      rational(generator.high));
      else if (generator.function == certificate::Elementary::pi)
        tower_.extend(generator.function, constant(0));
      else
        tower_.extend(generator.function, value(generator.argument));
}

void Context::accept_functions() {
  for (const Function& function : statement_->functions) {
    const int index = first_function_ + static_cast<int>(operands_.size());
    const std::set<int> held = functions({function.operand});
    demand(held.empty() || *held.rbegin() < index,
           "degenerate: a radicand holds its own function or a later one");
    operands_.push_back(value(function.operand));
    if (function.is_root())
      ring_.add_rule(index, ring_.difference(symbol(index, function.degree), operands_.back()));
    if (function.elementary == certificate::Elementary::sin) add_cosine(index);
  }
}

void Context::add_cosine(int sine) {
  for (int i = first_function_; i < sine; ++i) {
    const bool is_cosine = function(i).elementary == certificate::Elementary::cos;
    if (!is_cosine || !ring_.difference(operand(i), operand(sine)).is_zero()) continue;
    cosines_.emplace(sine, i);
    const Polynomial circle = ring_.sum(symbol(sine, 2), ring_.power(symbol(i), 2));
    ring_.add_rule(sine, ring_.difference(circle, constant(1)));
    return;
  }
}

std::set<int> Context::functions(std::vector<Term> terms) const {
  std::set<int> found;
  if (statement_->functions.empty()) return found;
  std::vector<bool> seen(known_.size());
  while (!terms.empty()) {
    const Term term = terms.back();
    terms.pop_back();
    meter_->charge(1);
    if (seen[static_cast<std::size_t>(term)]) continue;
    seen[static_cast<std::size_t>(term)] = true;
    const auto& [kind, text, operands, exponent] = node(term);
    terms.insert(terms.end(), operands.begin(), operands.end());
    if (kind != Node::Kind::symbol || symbols_.at(text) < first_function_) continue;
    found.insert(symbols_.at(text));
    if (const auto other = cosine(symbols_.at(text))) found.insert(*other);
    terms.push_back(function(symbols_.at(text)).operand);
  }
  return found;
}

const Function& Context::function(int index) const {
  return statement_->functions[static_cast<std::size_t>(index - first_function_)];
}

const Polynomial& Context::operand(int function) const {
  return operands_[static_cast<std::size_t>(function - first_function_)];
}

std::optional<int> Context::cosine(int function) const {
  const auto found = cosines_.find(function);
  return found == cosines_.end() ? std::nullopt : std::optional(found->second);
}

const Node& Context::node(Term term) const {
  const auto index = static_cast<std::size_t>(term);
  const auto& stated = statement_->nodes;
  return index < stated.size() ? stated[index] : evidence_->nodes[index - stated.size()];
}

Polynomial Context::evaluated(const Node& node) {
  const auto operand = [this](Term term) -> const Polynomial& {
    return *known_[static_cast<std::size_t>(term)];
  };
  switch (node.kind) {
    case Node::Kind::constant:
      return rational(node.text);
    case Node::Kind::symbol:
      return symbol(symbols_.at(node.text));
    case Node::Kind::sum: {
      Polynomial total;
      for (const Term term : node.operands) add(total, operand(term), *meter_);
      return total;
    }
    case Node::Kind::product: {
      Polynomial total = constant(1);
      for (const Term term : node.operands) total = ring_.product(total, operand(term));
      return total;
    }
    case Node::Kind::power:
      return ring_.power(operand(node.operands.front()), node.exponent);
  }
  throw Open("malformed: an unknown kind of node");
}

// Operands are earlier nodes: one pass down finds what is needed, one up computes it.
Polynomial Context::value(Term term) {
  if (known_words_ > Meter::max_words) {
    known_.assign(known_.size(), std::nullopt);
    known_words_ = 0;
  }
  std::vector<bool> needed(static_cast<std::size_t>(term) + 1);
  needed.back() = true;
  for (Term i = term; i >= 0; --i) {
    meter_->charge(1);
    if (needed[static_cast<std::size_t>(i)] && !known_[static_cast<std::size_t>(i)])
      for (const Term operand : node(i).operands) {
        meter_->charge(1);
        needed[static_cast<std::size_t>(operand)] = true;
      }
  }
  for (Term i = 0; i <= term; ++i) {
    auto& known = known_[static_cast<std::size_t>(i)];
    if (!needed[static_cast<std::size_t>(i)] || known) continue;
    Polynomial result = evaluated(node(i));
    demand((known_words_ += words(result)) <= 2 * Meter::max_words, "effort");
    known = std::move(result);
  }
  return ring_.reduce(*known_[static_cast<std::size_t>(term)]);
}

Polynomial Context::number(Term term) {
  Polynomial result = value(term);
  demand(depends_only_on(result, {}), "degenerate: a variable where a number is needed");
  return result;
}

int Context::variable(const std::string& name) const {
  const auto found = symbols_.find(name);
  demand(found != symbols_.end() && found->second >= generators_,
         "degenerate: an unknown variable");
  return found->second;
}

std::set<int> Context::variables(const std::vector<std::string>& names) const {
  std::set<int> result;
  for (const std::string& name : names)
    demand(result.insert(variable(name)).second, "degenerate: a variable is named twice");
  return result;
}

std::set<int> Context::variables(const Polynomial& p) const {
  std::set<int> result;
  for (const auto& [monomial, coefficient] : p.terms)
    for (int i = generators_; i < std::ssize(monomial); ++i)
      if (exponent(monomial, i) > 0) result.insert(i);
  return result;
}

bool Context::depends_only_on(const Polynomial& p, const std::set<int>& variables) const {
  return std::ranges::all_of(p.terms, [&](const auto& term) {
    const Monomial& monomial = term.first;
    for (int i = generators_; i < std::ssize(monomial); ++i)
      if (exponent(monomial, i) > 0 && !variables.contains(i)) return false;
    return true;
  });
}

}  // namespace seam::check
