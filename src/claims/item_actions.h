// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/items.h"
#include "claims/statement_actions.h"

// What each rule of an item puts into the item.
namespace seam::claims::grammar {

template <Item::Kind kind>
struct begins {
  static void apply0(Builder& b) { b.item.kind = kind; }
};
template <>
struct action<paper_word> : begins<Item::Kind::paper> {};
template <>
struct action<section_word> : begins<Item::Kind::section> {};
template <>
struct action<let_word> : begins<Item::Kind::let> {};
template <>
struct action<sequence_word> : begins<Item::Kind::sequence> {};
template <>
struct action<param_word> : begins<Item::Kind::param> {};
template <>
struct action<root_word> : begins<Item::Kind::root> {};
template <>
struct action<include_word> : begins<Item::Kind::include> {};
template <>
struct action<define_word> : begins<Item::Kind::define> {};
template <>
struct action<claim_word> : begins<Item::Kind::claim> {};
template <>
struct action<table_word> : begins<Item::Kind::table> {};
template <>
struct action<figure_word> : begins<Item::Kind::figure> {};
template <>
struct action<ask_word> : begins<Item::Kind::ask> {};

/// Puts the last word into a field of the item.
template <std::string Item::*field>
struct stores {
  static void apply0(Builder& b) { b.item.*field = b.word; }
};
template <std::vector<std::string> Item::*field>
struct appends {
  static void apply0(Builder& b) { (b.item.*field).push_back(b.word); }
};

/// Refuses a second one.
template <typename Rule>
struct once {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.once(b.offset(in.begin()));
  }
};
template <>
struct action<by_word> : once<by_word> {};
template <>
struct action<source_word> : once<source_word> {};
template <>
struct action<year_word> : once<year_word> {};
template <>
struct action<at_word> : once<at_word> {};
template <>
struct action<corrected_word> : once<corrected_word> {};
template <>
struct action<expect_word> : once<expect_word> {};
template <>
struct action<using_word> : once<using_word> {};
template <>
struct action<coloured_word> : once<coloured_word> {};
template <>
struct action<with_word> : once<with_word> {};

template <>
struct action<title_text> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_title(b.offset(in.begin()));
  }
};
template <>
struct action<at_text> {
  static void apply0(Builder& b) { b.item.claim.at = b.word; }
};
template <>
struct action<author> : stores<&Item::by> {};
template <>
struct action<source_text> : stores<&Item::source> {};
template <>
struct action<year_number> : stores<&Item::year> {};

template <>
struct action<item_name> {
  static void apply0(Builder& b) { b.name_item(); }
};
template <>
struct action<claim_id> {
  static void apply0(Builder& b) { b.name_item(); }
};
template <>
struct action<parameter> : appends<&Item::parameters> {};
template <>
struct action<param_name> {
  static void apply0(Builder& b) {
    if (b.item.names.empty()) b.name_item();
    b.item.names.push_back(b.word);
  }
};
template <>
struct action<integer_type> {
  static void apply0(Builder& b) { b.item.type = "integer"; }
};
template <>
struct action<mesh_type> {
  static void apply0(Builder& b) { b.item.type = "mesh"; }
};
template <>
struct action<whole_text> : reads_word {};
template <>
struct action<dimension> {
  static void apply0(Builder& b) { b.item.type = "vector " + b.word; }
};

template <>
struct action<begins_function> {
  static void apply0(Builder& b) {
    b.item.type += b.item.type.empty() ? "function" : " function";
  }
};
template <>
struct action<arity> {
  static void apply0(Builder& b) { b.item.type += " of " + b.word; }
};
template <>
struct action<some_curves> : begins<Item::Kind::param> {};
template <>
struct action<is_generic> {
  static void apply0(Builder& b) { b.item.type = "vector 3 function"; }
};

template <>
struct action<param_where> {
  static void apply0(Builder& b) { b.item.where = b.take(); }
};

template <>
struct action<claim_statement> {
  static void apply0(Builder& b) { b.item.claim.statement = b.take(); }
};
template <>
struct action<corrected_statement> {
  static void apply0(Builder& b) { b.item.claim.corrected = b.take(); }
};
template <>
struct action<expectation> {
  static void apply0(Builder& b) { b.item.claim.expect = b.last_token(); }
};
template <>
struct action<used_id> {
  static void apply0(Builder& b) { b.item.claim.using_claims.push_back(b.word); }
};
template <>
struct action<hint_argument> {
  static void apply0(Builder& b) { b.end_hint(); }
};
template <>
struct action<hint> {
  static void apply0(Builder& b) { b.item.claim.hints.push_back(b.take()); }
};

template <>
struct action<column_label> : appends<&Item::labels> {};
template <>
struct action<columns> {
  static void apply0(Builder& b) { b.item.columns.push_back(b.take()); }
};
template <>
struct action<row_label> {
  static void apply0(Builder& b) {
    b.item.rows.emplace_back();
    b.item.rows.back().label = b.word;
  }
};
template <>
struct action<row_value> {
  static void apply0(Builder& b) { b.item.rows.back().value = b.take(); }
};
template <>
struct action<printed_value> {
  static void apply0(Builder& b) { b.item.rows.back().printed.push_back(b.take()); }
};
template <>
struct action<right_value> {
  static void apply0(Builder& b) {
    Item::Row& row = b.item.rows.back();
    row.corrected.emplace(row.printed.size() - 1, b.take());
  }
};
template <>
struct action<row_cut_off> {
  static void apply0(Builder& b) { b.item.rows.back().truncated = true; }
};
template <>
struct action<shown> {
  static void apply0(Builder& b) { b.item.expressions.push_back(b.take()); }
};
template <>
struct action<colour> {
  static void apply0(Builder& b) { b.item.expressions.push_back(b.take()); }
};
template <>
struct action<drawn> {
  static void apply0(Builder& b) { b.draw_with(); }
};
template <>
struct action<digit_count> : stores<&Item::option> {};

template <>
struct action<item> {
  static void apply0(Builder& b) { b.end_item(); }
};

}  // namespace seam::claims::grammar
