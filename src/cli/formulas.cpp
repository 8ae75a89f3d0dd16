// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/formulas.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace seam::cli {
namespace {

using certificate::Node;
using certificate::Term;
using symbolic::Formula;

// `x0` and 2 of `x0[2]`; 0 of a name without an index.
std::pair<std::string, int> indexed(const std::string& name) {
  const std::size_t at = name.rfind('[');
  if (at == std::string::npos || name.back() != ']' || name.size() - at > 5) return {name, 0};
  const std::string digits = name.substr(at + 1, name.size() - at - 2);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
    return {name, 0};
  return {name.substr(0, at), std::stoi(digits)};
}

}  // namespace

Formula Formulas::operator()(Term term) {
  if (const auto known = done_.find(term); known != done_.end()) return known->second;
  const auto size = static_cast<Term>(statement_.nodes.size());
  const Node& node = term < size ? statement_.nodes[term] : evidence_.nodes[term - size];
  std::vector<Formula> operands;
  for (const Term operand : node.operands) operands.push_back((*this)(operand));
  Formula result = 0;
  switch (node.kind) {
    case Node::Kind::constant:
      result = Formula(exact::Rational(node.text));
      break;
    case Node::Kind::symbol:
      result = Formula::symbol(node.text);
      break;
    case Node::Kind::sum:
      result = symbolic::sum(std::move(operands));
      break;
    case Node::Kind::product:
      result = symbolic::product(std::move(operands));
      break;
    case Node::Kind::power:
      result = symbolic::power(operands[0], node.exponent);
      break;
  }
  done_.emplace(term, result);
  return result;
}

std::string readable(std::string text) {
  std::erase(text, '~');
  std::ranges::replace(text, '{', '(');
  std::ranges::replace(text, '}', ')');
  return text;
}

std::string point_text(const certificate::Point& point, Formulas& formulas) {
  std::map<std::string, std::map<int, std::string>> values;
  std::vector<std::string> order;
  for (std::size_t i = 0; i < point.variables.size(); ++i) {
    const auto [name, index] = indexed(point.variables[i]);
    if (!values.contains(name)) order.push_back(name);
    values[name].emplace(index, symbolic::text(formulas(point.values[i]), 60));
  }
  std::string result;
  for (const std::string& name : order) {
    const auto& entries = values[name];
    const bool is_vector = entries.size() > 1 && entries.begin()->first == 1 &&
                           entries.rbegin()->first == std::ssize(entries);
    std::string tuple;
    for (const auto& [index, value] : entries) {
      if (is_vector)
        tuple += (tuple.empty() ? "" : ", ") + value;
      else
        result += (result.empty() ? "" : ", ") + name +
                  (index > 0 ? "[" + std::to_string(index) + "]" : "") + " = " + value;
    }
    if (is_vector) result += (result.empty() ? "" : ", ") + name + " = (" + tuple + ")";
  }
  return readable(result);
}

}  // namespace seam::cli
