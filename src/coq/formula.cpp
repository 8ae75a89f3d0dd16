// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/formula.h"

#include <algorithm>

// Text and code are built side by side, by the same rules, so that one is the value of the
// other: Coq compares the two when it checks a theorem.

namespace seam::coq {
namespace {

using certificate::Node;
using certificate::Term;
using Level = Written::Level;

std::string bracketed(const Written& written, Level least) {
  return written.level < least ? "(" + written.text + ")" : written.text;
}

std::string called(const char* name, const Written& a, const Written& b) {
  return std::string("(") + name + " " + a.code + " " + b.code + ")";
}

bool is_negative(const std::string& rational) {
  return rational.starts_with('-');
}

}  // namespace

std::string in_brackets(const Written& written) {
  return bracketed(written, Level::atom);
}

Written sum(const Written& a, const Written& b) {
  return {a.text + " + " + bracketed(b, Level::product), called("Add", a, b), Level::sum};
}

Written difference(const Written& a, const Written& b) {
  return {a.text + " - " + bracketed(b, Level::product), called("Sub", a, b), Level::sum};
}

Written product(const Written& a, const Written& b) {
  return {bracketed(a, Level::product) + " * " + bracketed(b, Level::power),
          called("Mul", a, b), Level::product};
}

Written constant(const std::string& rational) {
  const std::size_t bar = rational.find('/');
  const std::string top = rational.substr(0, bar);
  const std::string over = is_negative(top) ? "(" + top + ")" : top;
  if (bar == std::string::npos) return {over, "(Num " + over + ")", Level::atom};
  const std::string below = rational.substr(bar + 1);
  return {"(" + top + " / " + below + ")", "(Frac " + over + " " + below + ")", Level::atom};
}

Formulas::Formulas(const certificate::Certificate& certificate) : certificate_(certificate) {}

const Node& Formulas::node(Term term) const {
  const auto& stated = certificate_.statement.nodes;
  const auto index = static_cast<std::size_t>(term);
  return index < stated.size() ? stated[index]
                               : certificate_.evidence.nodes[index - stated.size()];
}

std::set<std::string> Formulas::symbols(const std::vector<Term>& terms) const {
  std::set<std::string> result;
  std::set<Term> seen;
  std::vector<Term> left = terms;
  while (!left.empty()) {
    const Term term = left.back();
    left.pop_back();
    if (!seen.insert(term).second) continue;
    const Node& at = node(term);
    if (at.kind == Node::Kind::symbol) result.insert(at.text);
    left.insert(left.end(), at.operands.begin(), at.operands.end());
  }
  return result;
}

bool Formulas::is_constant(Term term) const {
  return node(term).kind == Node::Kind::constant;
}

bool Formulas::is_short(Term term) const {
  const Node& at = node(term);
  const auto is_leaf = [&](Term operand) {
    const Node::Kind kind = node(operand).kind;
    return kind == Node::Kind::constant || kind == Node::Kind::symbol;
  };
  return at.operands.size() <= 2 && std::ranges::all_of(at.operands, is_leaf);
}

std::vector<Term> Formulas::shared(const std::vector<Term>& terms) const {
  std::map<Term, int> uses;
  std::vector<Term> left = terms;
  while (!left.empty()) {
    const Term term = left.back();
    left.pop_back();
    if (++uses[term] > 1) continue;
    const Node& at = node(term);
    left.insert(left.end(), at.operands.begin(), at.operands.end());
  }
  std::vector<Term> result;
  for (const auto& [term, count] : uses)
    if (count > 1 && !is_short(term)) result.push_back(term);
  return result;
}

Written Formulas::next_place(const std::string& name) {
  return {name, "(Sym " + std::to_string(size_++) + ")", Level::atom};
}

void Formulas::place(const std::string& symbol, const std::string& name) {
  symbols_[symbol] = next_place(name);
}

void Formulas::place(Term value, const std::string& name) {
  values_[value] = next_place(name);
}

void Formulas::place_coordinate(const std::string& name) {
  coordinates_[name] = next_place(name);
}

Written Formulas::write(Term term) const {
  const auto found = values_.find(term);
  return found != values_.end() ? found->second : write_node(node(term));
}

Written Formulas::write_definition(Term term) const {
  return write_node(node(term));
}

Written Formulas::write_node(const Node& at) const {
  switch (at.kind) {
    case Node::Kind::constant:
      return constant(at.text);
    case Node::Kind::symbol:
      return symbols_.at(at.text);
    case Node::Kind::power: {
      const Written base = write(at.operands.front());
      const std::string n = std::to_string(at.exponent);
      return {in_brackets(base) + " ^ " + n, "(Pow " + base.code + " " + n + ")", Level::power};
    }
    case Node::Kind::product: {
      if (at.operands.empty()) return constant("1");
      Written result = write(at.operands.front());
      for (std::size_t i = 1; i < at.operands.size(); ++i)
        result = product(result, write(at.operands[i]));
      return result;
    }
    case Node::Kind::sum:
      break;
  }
  if (at.operands.empty()) return constant("0");
  Written result = write(at.operands.front());
  for (std::size_t i = 1; i < at.operands.size(); ++i) {
    const Node& part = node(at.operands[i]);
    const Term first = part.operands.empty() ? at.operands[i] : part.operands.front();
    const bool is_subtracted = !values_.contains(at.operands[i]) &&
                               part.kind == Node::Kind::product && part.operands.size() == 2 &&
                               node(first).kind == Node::Kind::constant &&
                               node(first).text == "-1";
    result = is_subtracted ? difference(result, write(part.operands.back()))
                           : sum(result, write(at.operands[i]));
  }
  return result;
}

}  // namespace seam::coq
