// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/mutants_of_node.h"

#include <algorithm>
#include <optional>
#include <sstream>

namespace seam::claims {
namespace {

using Kind = Expression::Kind;
using Change = Mutation::Kind;

Expression node(Kind kind, std::string text, std::vector<Expression> children) {
  return {kind, std::move(text), std::move(children), {}};
}

// The decimal with one unit of its last digit more, or less; none below 0.
std::optional<std::string> one_more(std::string digits) {
  for (std::size_t i = digits.size(); i-- > 0;) {
    if (digits[i] == '.') continue;
    if (digits[i] != '9') {
      ++digits[i];
      return digits;
    }
    digits[i] = '0';
  }
  return "1" + digits;
}
std::optional<std::string> one_less(std::string digits) {
  for (std::size_t i = digits.size(); i-- > 0;) {
    if (digits[i] == '.') continue;
    if (digits[i] != '0') {
      --digits[i];
      const std::size_t first = digits.find_first_not_of('0');
      const std::size_t point = std::min(digits.find('.'), digits.size());
      return digits.substr(std::min(first, point - 1));
    }
    digits[i] = '9';
  }
  return std::nullopt;
}

class Node {
 public:
  Node(const Expression& e, const NodeContext& context) : e_(e), context_(context) {}

  NodeMutants all() {
    if (e_.kind == Kind::number) change_number();
    if (e_.kind == Kind::name) change_name();
    if (e_.kind == Kind::binary) change_operation();
    if (e_.kind == Kind::relation || e_.kind == Kind::truncated) change_relation();
    change_sign();
    change_connective();
    if (context_.is_set || e_.kind == Kind::half_open) change_ends();
    exchange_neighbours();
    return std::move(found_);
  }

 private:
  void add(Change kind, Expression instead) { found_.emplace_back(kind, std::move(instead)); }

  bool is_below(Kind kind) const { return context_.parent && context_.parent->kind == kind; }
  bool is_exponent() const {
    return is_below(Kind::binary) && context_.parent->text == "^" && context_.child == 1;
  }
  bool is_index() const { return is_below(Kind::index) && context_.child > 0; }
  bool is_end() const {
    return is_below(Kind::range) || is_below(Kind::half_open) || context_.is_in_set;
  }

  void change_number() {
    const Change kind = is_exponent() ? Change::power
                        : is_index()  ? Change::index
                        : is_end()    ? Change::range
                                      : Change::number;
    for (const auto& text : {one_more(e_.text), one_less(e_.text)})
      if (text) add(kind, node(Kind::number, *text, {}));
  }

  void change_name() {
    for (const std::string& word : words_like(e_.text))
      add(Change::function, node(Kind::name, word, {}));
    const auto is_bound = [&](const std::string& name) {
      return std::ranges::find(context_.bound, name) != context_.bound.end();
    };
    if (is_bound(e_.text)) {
      for (const std::string& name : context_.bound)
        add(is_index() ? Change::index : Change::name, node(Kind::name, name, {}));
      return;
    }
    const auto own = std::ranges::find(*context_.known, e_.text, &KnownName::name);
    if (own == context_.known->end()) return;
    for (const auto& [name, item] : *context_.known)
      if (item->kind == own->item->kind && item->type == own->item->type &&
          item->parameters.size() == own->item->parameters.size() && !is_bound(name))
        add(Change::name, node(Kind::name, name, {}));
  }

  void change_operation() {
    static const std::vector<std::pair<std::string, std::string>> others = {
        {"+", "-"}, {"-", "+"}, {"*", "+/"}, {"/", "*"}, {"^", "*"}};
    const auto own =
        std::ranges::find(others, e_.text, &std::pair<std::string, std::string>::first);
    if (own == others.end()) return;
    for (const char operation : own->second)
      add(Change::operation, node(Kind::binary, std::string(1, operation), e_.children));
  }

  void change_relation() {
    static const std::vector<std::pair<std::string, std::vector<std::string>>> others = {
        {"=", {"!=", "<="}}, {"!=", {"="}},      {"<", {"<=", ">"}},
        {"<=", {"<", ">="}}, {">", {">=", "<"}}, {">=", {">", "<="}}};
    if (e_.kind == Kind::truncated) return add(Change::relation, e_.children[0]);
    std::vector<std::string> operators;
    std::istringstream in(e_.text);
    for (std::string one; in >> one;) operators.push_back(one);
    for (std::size_t i = 0; i < operators.size(); ++i)
      for (const auto& [own, instead] : others)
        for (const std::string& other : instead) {
          if (own != operators[i]) continue;
          std::string text;
          for (std::size_t k = 0; k < operators.size(); ++k)
            text += (k > 0 ? " " : "") + (k == i ? other : operators[k]);
          add(Change::relation, node(Kind::relation, text, e_.children));
        }
    if (e_.text == "~" && !is_below(Kind::truncated))
      add(Change::relation, node(Kind::truncated, {}, {e_}));
  }

  void change_sign() {
    if (e_.kind == Kind::negate) return add(Change::sign, e_.children[0]);
    const bool is_value = e_.kind == Kind::name || e_.kind == Kind::number ||
                          e_.kind == Kind::call || e_.kind == Kind::index ||
                          e_.kind == Kind::tuple;
    const bool is_operand = is_below(Kind::binary) || is_below(Kind::relation) ||
                            is_below(Kind::tuple) || is_below(Kind::list);
    const bool is_zero =
        e_.kind == Kind::number && e_.text.find_first_not_of("0.") == std::string::npos;
    if (is_value && is_operand && !is_exponent() && !context_.is_in_set && !is_zero)
      add(Change::sign, node(Kind::negate, {}, {e_}));
  }

  void change_connective() {
    const auto with = [&](Kind kind) { return node(kind, e_.text, e_.children); };
    const auto turned = [&](Kind kind) {
      return node(kind, e_.text, {e_.children[1], e_.children[0]});
    };
    if (e_.kind == Kind::conjunction || e_.kind == Kind::disjunction) {
      add(Change::connective,
          with(e_.kind == Kind::conjunction ? Kind::disjunction : Kind::conjunction));
      for (const Expression& child : e_.children) add(Change::connective, child);
    }
    if (e_.kind == Kind::implication) {
      add(Change::connective, with(Kind::equivalence));
      add(Change::connective, turned(Kind::implication));
      add(Change::connective, e_.children[1]);
    }
    if (e_.kind == Kind::equivalence) {
      add(Change::connective, with(Kind::implication));
      add(Change::connective, turned(Kind::implication));
    }
    if (e_.kind == Kind::negation) add(Change::connective, e_.children[0]);
    if (e_.kind == Kind::for_some) add(Change::connective, with(Kind::for_all));
    if (e_.kind == Kind::for_all) add(Change::connective, with(Kind::for_some));
    const std::size_t condition = e_.text == "all" ? 1 : 2;
    if (e_.kind == Kind::binding && e_.children.size() > condition) {
      Expression unconditional = e_;
      unconditional.children.pop_back();
      add(Change::connective, std::move(unconditional));
    }
  }

  // Whether the ends of an interval belong to it.
  void change_ends() {
    const std::vector<Expression>& ends = e_.children;
    if (ends.size() != 2) return;
    if (e_.kind == Kind::list) add(Change::range, node(Kind::tuple, {}, ends));
    if (e_.kind == Kind::tuple) add(Change::range, node(Kind::list, {}, ends));
    if (e_.kind == Kind::half_open) {
      add(Change::range, node(Kind::half_open, e_.text == "[)" ? "(]" : "[)", ends));
      add(Change::range, node(Kind::list, {}, ends));
    }
  }

  void exchange_neighbours() {
    constexpr std::size_t most = 40;
    const bool has_order = e_.kind == Kind::tuple || e_.kind == Kind::list ||
                           e_.kind == Kind::call || e_.kind == Kind::matrix ||
                           e_.kind == Kind::patch;
    if (!has_order || context_.is_set || e_.children.size() > most) return;
    for (std::size_t i = e_.kind == Kind::call ? 1 : 0; i + 1 < e_.children.size(); ++i) {
      Expression instead = e_;
      std::swap(instead.children[i], instead.children[i + 1]);
      add(Change::order, std::move(instead));
    }
  }

  const Expression& e_;
  const NodeContext& context_;
  NodeMutants found_;
};

}  // namespace

NodeMutants mutants_of_node(const Expression& e, const NodeContext& context) {
  return Node(e, context).all();
}

}  // namespace seam::claims
