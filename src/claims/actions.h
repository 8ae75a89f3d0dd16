// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/grammar.h"

// What each rule of the grammar does to the builder's stack of nodes.
namespace seam::claims::grammar {

using Kind = Expression::Kind;

template <typename Rule>
struct action : peg::nothing<Rule> {};

/// One node of the last `children` nodes.
template <Kind kind, std::size_t children>
struct makes {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.make(kind, {}, children, b.offset(in.begin()));
  }
};

/// A leaf whose text is the last word.
template <Kind kind>
struct makes_leaf {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.make(kind, b.word, 0, b.offset(in.begin()));
  }
};

template <std::size_t back = 0>
struct marks {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.mark(b.offset(in.begin()), back);
  }
};

// ---- tokens

template <>
struct action<gap> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.gap(b.offset(in.begin()), b.offset(in.end()));
  }
};
template <>
struct action<comment> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.comment(b.offset(in.begin()), in.string_view());
  }
};
template <>
struct action<identifier> {
  template <typename Input>
  static bool apply(const Input& in, Builder& b) {
    return b.read_name(b.offset(in.begin()), in.string_view());
  }
};
struct reads_word {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.read_word(b.offset(in.begin()), in.string_view());
  }
};
template <>
struct action<id_text> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.read_word(b.offset(in.begin()), spelled_out(in.string_view()));
  }
};
template <>
struct action<string_text> : reads_word {};
template <>
struct action<number_text> : reads_word {};

// ---- bindings

template <>
struct action<open> : marks<> {};
template <>
struct action<set_begins> {
  static void apply0(Builder& b) { b.set_begin = b.gap_end; }
};
template <>
struct action<one_name> : makes_leaf<Kind::name> {};

/// A list of what stands behind the last mark.
struct makes_group {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_group(Kind::list, {}, b.offset(in.begin()));
  }
};
template <>
struct action<bound_names> : makes_group {};
template <>
struct action<bare_names> : makes_group {};
template <>
struct action<unknown_names> : makes_group {};
template <>
struct action<unknown_ranges> : makes_group {};
template <>
struct action<condition> : makes_group {};
template <>
struct action<ranged> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_group(Kind::binding, "in", b.offset(in.begin()));
  }
};
template <>
struct action<bare_binding> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_bare_binding(b.offset(in.begin()));
  }
};

// ---- brackets

template <>
struct action<each_begins> : marks<1> {};
template <>
struct action<limit> {
  static void apply0(Builder& b) { b.end_limit(); }
};
template <>
struct action<each> {
  static void apply0(Builder& b) { b.end_call(Kind::each); }
};
template <>
struct action<named> {
  static void apply0(Builder& b) { b.end_named(); }
};
template <>
struct action<open_tuple> : marks<> {};
template <>
struct action<open_list> : marks<> {};
template <>
struct action<row_end> {
  static void apply0(Builder& b) { b.end_row(); }
};
template <>
struct action<parenthesis> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_parenthesis(b.offset(in.begin()));
  }
};
template <>
struct action<bracket> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_bracket(b.offset(in.begin()));
  }
};
template <>
struct action<open_call> : marks<1> {};
template <>
struct action<open_index> : marks<1> {};
template <>
struct action<call> {
  static void apply0(Builder& b) { b.end_call(Kind::call); }
};
template <>
struct action<index> {
  static void apply0(Builder& b) { b.end_call(Kind::index); }
};

// ---- patches

struct names_shape {
  template <typename Input>
  static void apply(const Input&, Builder& b) {
    b.marks.back().text += b.last_token();
  }
};
template <>
struct action<rational> {
  static void apply0(Builder& b) { b.marks.back().text = "rational "; }
};
template <typename Word>
struct action<shape<Word>> : names_shape {};
template <>
struct action<weight> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_weight(b.offset(in.begin()));
  }
};
template <>
struct action<net_end> {
  static void apply0(Builder& b) { b.end_net(); }
};
template <>
struct action<control_point> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    const std::string_view text = in.string_view();
    b.make(Kind::control, std::string(text.substr(0, text.find_first_not_of("0123456789,"))), 1,
           b.offset(in.begin()));
  }
};
template <>
struct action<indexed> {
  static void apply0(Builder& b) { b.end_patch(Kind::indexed); }
};
template <>
struct action<from> {
  static void apply0(Builder& b) { b.end_patch(Kind::from); }
};

// ---- values

template <>
struct action<name_value> : makes_leaf<Kind::name> {};
template <>
struct action<number_value> : makes_leaf<Kind::number> {};
template <>
struct action<string_value> : makes_leaf<Kind::string> {};
template <>
struct action<read> : makes_leaf<Kind::read> {};
template <>
struct action<infinity_value> : makes<Kind::infinity, 0> {};
template <>
struct action<plane> : makes<Kind::plane, 2> {};
template <>
struct action<negative> : makes<Kind::negate, 1> {};
template <>
struct action<root> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.end_root(b.offset(in.begin()));
  }
};

template <typename Sign>
constexpr const char* spelling = nullptr;
template <>
inline constexpr const char* spelling<times_sign> = "*";
template <>
inline constexpr const char* spelling<divide_sign> = "/";
template <>
inline constexpr const char* spelling<plus_sign> = "+";
template <>
inline constexpr const char* spelling<minus_sign> = "-";
template <>
inline constexpr const char* spelling<equal_sign> = "=";
template <>
inline constexpr const char* spelling<unequal_sign> = "!=";
template <>
inline constexpr const char* spelling<at_most_sign> = "<=";
template <>
inline constexpr const char* spelling<at_least_sign> = ">=";
template <>
inline constexpr const char* spelling<less_sign> = "<";
template <>
inline constexpr const char* spelling<greater_sign> = ">";
template <>
inline constexpr const char* spelling<rounds_sign> = "~";

template <Kind kind>
struct joins {
  static void apply0(Builder& b) { b.binary(kind, {}); }
};
template <typename Sign>
struct action<combined_factor<Sign>> {
  static void apply0(Builder& b) { b.binary(Kind::binary, spelling<Sign>); }
};
template <typename Sign>
struct action<combined_product<Sign>> {
  static void apply0(Builder& b) { b.binary(Kind::binary, spelling<Sign>); }
};
template <>
struct action<raised> {
  static void apply0(Builder& b) { b.binary(Kind::binary, "^"); }
};
template <>
struct action<range> : joins<Kind::range> {};

}  // namespace seam::claims::grammar
