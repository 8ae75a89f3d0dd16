// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/actions.h"

// What the rules of statements do to the builder's stack of nodes.
namespace seam::claims::grammar {

template <typename Sign>
struct action<comparison<Sign>> {
  static void apply0(Builder& b) { b.compare(spelling<Sign>); }
};
template <>
struct action<cut_off> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.truncate(b.offset(in.begin()));
  }
};
template <>
struct action<relation> {
  static void apply0(Builder& b) { b.nodes.back().open = false; }
};
template <>
struct action<negation> : makes<Kind::negation, 1> {};
template <>
struct action<conjoined> : joins<Kind::conjunction> {};
template <>
struct action<disjoined> : joins<Kind::disjunction> {};
template <>
struct action<implies> : joins<Kind::implication> {};
template <>
struct action<equivalent> : joins<Kind::equivalence> {};

template <>
struct action<quantifier_begins> : marks<> {};
template <>
struct action<says_all> {
  static void apply0(Builder& b) { b.marks.back().text = "all"; }
};
template <>
struct action<says_some> {
  static void apply0(Builder& b) { b.marks.back().text = "some"; }
};
template <>
struct action<for_all_sign> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.mark(b.offset(in.begin()));
    b.marks.back().text = "all";
  }
};
template <>
struct action<for_some_sign> {
  template <typename Input>
  static void apply(const Input& in, Builder& b) {
    b.mark(b.offset(in.begin()));
    b.marks.back().text = "some";
  }
};
template <>
struct action<quantified> {
  static void apply0(Builder& b) { b.end_quantified(); }
};

template <>
struct action<solve_begins> : marks<> {};
template <>
struct action<gives_none> {
  static void apply0(Builder& b) { b.marks.back().text = "none"; }
};
template <>
struct action<gives_one> {
  static void apply0(Builder& b) { b.marks.back().text = "one"; }
};
template <>
struct action<solve> {
  static void apply0(Builder& b) { b.end_solve(); }
};

}  // namespace seam::claims::grammar
