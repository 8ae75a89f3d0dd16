// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "claims/items.h"

// What is said when a rule that must match does not.
namespace seam::claims::grammar {

template <typename Rule, typename... Kinds>
constexpr bool is_a = (std::is_base_of_v<Kinds, Rule> || ...);

/// What was expected, in words; null for rules that never fail, or that complain for
/// themselves.
template <typename Rule>
constexpr const char* what() {
  if constexpr (is_a<Rule, claim_statement, item_statement, body, denied, right_clause,
                     right_conjunction, implied, right_implication>)
    return "a statement";
  else if constexpr (is_a<Rule, string>)
    return "a text in quotes";
  else if constexpr (is_a<Rule, id>)
    return "an id";
  else if constexpr (is_a<Rule, whole_number>)
    return "a whole number";
  else if constexpr (is_a<Rule, bound_names, bare_names, unknowns, bindings, name>)
    return "a name";
  else if constexpr (is_a<Rule, bound_in, in_word>)
    return "'in' and a set";
  else if constexpr (is_a<Rule, header_colon, label_colon>)
    return "':'";
  else if constexpr (is_a<Rule, equal_sign>)
    return "'='";
  else if constexpr (is_a<Rule, gives_word>)
    return "'gives' and the solutions";
  else if constexpr (is_a<Rule, of_word>)
    return "'of' and a polynomial";
  else if constexpr (is_a<Rule, then_word>)
    return "'then' and the next value";
  else if constexpr (is_a<Rule, open_paren>)
    return "'('";
  else if constexpr (is_a<Rule, by_word>)
    return "'by'";
  else if constexpr (is_a<Rule, rounds_sign>)
    return "'~' and the printed values";
  else if constexpr (is_a<Rule, type_name>)
    return "'integer', 'vector' and a dimension, or 'function'";
  else if constexpr (is_a<Rule, is_generic>)
    return "'generic'";
  else if constexpr (is_a<Rule, expectation>)
    return "'refuted' or 'undecided'";
  else if constexpr (is_a<Rule, any_shape>)
    return "'triangle_patch', 'quad_patch' or 'curve'";
  else if constexpr (is_a<Rule, patch_rest>)
    return "'[', 'from', or a degree and '{'";
  else if constexpr (is_a<Rule, open_brace>)
    return "'{'";
  else if constexpr (is_a<Rule, control_point, next_control>)
    return "an index such as '300'";
  else if constexpr (is_a<Rule, arrow>)
    return "'->'";
  else if constexpr (is_a<Rule, peg::plus<row>>)
    return "a row, which begins with a text in quotes";
  else
    return "an expression";
}

template <typename Rule>
constexpr const char* closing() {
  if constexpr (is_a<Rule, tuple_end, call_end, close_paren>)
    return "',' or ')'";
  else if constexpr (is_a<Rule, list_end, net_end>)
    return "',', ';' or ']'";
  else if constexpr (is_a<Rule, index_end>)
    return "',' or ']'";
  else if constexpr (is_a<Rule, controls_end>)
    return "';' or '}'";
  else
    return nullptr;
}

template <typename Rule>
struct control : peg::normal<Rule> {
  template <typename Input>
  [[noreturn]] static void raise(const Input& in, Builder& b) {
    if constexpr (std::is_same_v<Rule, claim_statement>)
      b.missing_statement();
    else if constexpr (is_a<Rule, colon> && !is_a<Rule, header_colon, label_colon>)
      b.missing_colon();
    else if constexpr (is_a<Rule, item_end, expression_end>)
      b.unexpected_rest();
    else if constexpr (std::is_same_v<Rule, item>)
      b.unknown_item();
    else if constexpr (is_a<Rule, string_end>)
      b.fail("this text is not closed on its line", b.token_at(b.gap_end),
             "texts end with '\"'");
    else if constexpr (is_a<Rule, decimals>)
      b.fail("expected a digit after the decimal point", b.token_at(b.offset(in.current())));
    else if constexpr (is_a<Rule, no_word>)
      b.invisible_product(b.gap_end, b.offset(in.current()));
    else if constexpr (is_a<Rule, no_set>)
      b.fail("only the last of these names has a set", b.token_at(b.gap_end),
             "write 'u in S, v in S'");
    else if constexpr (closing<Rule>() != nullptr)
      b.expected_close(closing<Rule>());
    else
      b.expected(what<Rule>());
  }
};

}  // namespace seam::claims::grammar
