// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tao/pegtl.hpp>

#include "claims/builder.h"
#include "claims/greek.h"
#include "text/utf8.h"

// The words and signs of the language. Every token takes the gap behind it along, so
// each rule of the grammar begins at a token.
namespace seam::claims::grammar {

namespace peg = tao::pegtl;

struct comment : peg::seq<peg::one<'#'>, peg::until<peg::at<peg::eolf>>> {};
struct gap : peg::star<peg::sor<peg::plus<peg::one<' ', '\t', '\r', '\n'>>, comment>> {};

struct greek_letter {
  using rule_t = greek_letter;
  using subs_t = peg::type_list<>;
  template <typename Input>
  static bool match(Input& in) {
    if (in.empty() || static_cast<unsigned char>(*in.current()) < 0x80) return false;
    const auto point = text::decode({in.current(), in.size()}, 0);
    if (greek_name(point.value).empty()) return false;
    in.bump_in_this_line(point.length);
    return true;
  }
};

struct word_part : peg::sor<peg::alnum, peg::one<'_', '\''>, greek_letter> {};
struct inner_dot
    : peg::seq<peg::one<'.'>, peg::at<peg::sor<peg::alnum, peg::one<'_'>, greek_letter>>> {};
struct word_text
    : peg::seq<peg::sor<peg::alpha, greek_letter>, peg::star<peg::sor<word_part, inner_dot>>> {
};
struct word_ends : peg::not_at<peg::sor<word_part, inner_dot>> {};

/// A word that is not reserved.
struct identifier : peg::seq<word_text> {};
struct name : peg::seq<identifier, gap> {};

struct id_part : peg::sor<peg::alnum, peg::one<'_'>, greek_letter> {};
struct id_text
    : peg::seq<id_part, peg::star<peg::sor<id_part, peg::seq<peg::plus<peg::one<'.', '-', ':'>>,
                                                             peg::at<id_part>>>>> {};
struct id : peg::seq<id_text, gap> {};

struct string_text : peg::star<peg::not_one<'"', '\n', '\r'>> {};
struct string_end : peg::one<'"'> {};
struct string : peg::seq<peg::one<'"'>, string_text, peg::must<string_end>, gap> {};

struct decimals : peg::plus<peg::digit> {};
struct no_word : peg::not_at<peg::sor<peg::alpha, greek_letter>> {};
struct number_text
    : peg::seq<peg::plus<peg::digit>,
               peg::opt<peg::one<'.'>, peg::not_at<peg::one<'.'>>, peg::must<decimals>>> {};
struct number : peg::seq<number_text, peg::must<no_word>, gap> {};
struct whole_text : peg::plus<peg::digit> {};
struct whole_number : peg::seq<whole_text, gap> {};

template <typename Text>
struct keyword : peg::seq<Text, word_ends, gap> {};

template <char... C>
struct sign : peg::seq<peg::string<C...>, gap> {};

template <char32_t C>
struct special : peg::seq<peg::utf8::one<C>, gap> {};

#define SEAM_KEYWORD(rule, text) \
  struct rule : keyword<TAO_PEGTL_STRING(text)> {}

SEAM_KEYWORD(paper_word, "paper");
SEAM_KEYWORD(section_word, "section");
SEAM_KEYWORD(let_word, "let");
SEAM_KEYWORD(sequence_word, "sequence");
SEAM_KEYWORD(param_word, "param");
SEAM_KEYWORD(root_word, "root");
SEAM_KEYWORD(include_word, "include");
SEAM_KEYWORD(define_word, "define");
SEAM_KEYWORD(claim_word, "claim");
SEAM_KEYWORD(table_word, "table");
SEAM_KEYWORD(figure_word, "figure");
SEAM_KEYWORD(ask_word, "ask");

SEAM_KEYWORD(corrected_word, "corrected");
SEAM_KEYWORD(expect_word, "expect");
SEAM_KEYWORD(refuted_word, "refuted");
SEAM_KEYWORD(undecided_word, "undecided");
SEAM_KEYWORD(using_word, "using");
SEAM_KEYWORD(by_word, "by");
SEAM_KEYWORD(at_word, "at");
SEAM_KEYWORD(source_word, "source");
SEAM_KEYWORD(year_word, "year");
SEAM_KEYWORD(then_word, "then");
SEAM_KEYWORD(of_word, "of");
SEAM_KEYWORD(integer_word, "integer");
SEAM_KEYWORD(vector_word, "vector");
SEAM_KEYWORD(mesh_word, "mesh");
SEAM_KEYWORD(function_word, "function");
SEAM_KEYWORD(generic_word, "generic");
SEAM_KEYWORD(labelled_word, "labelled");
SEAM_KEYWORD(coloured_word, "coloured");
SEAM_KEYWORD(with_word, "with");
SEAM_KEYWORD(digits_word, "digits");

SEAM_KEYWORD(for_word, "for");
SEAM_KEYWORD(all_word, "all");
SEAM_KEYWORD(some_word, "some");
SEAM_KEYWORD(where_word, "where");
SEAM_KEYWORD(solve_word, "solve");
SEAM_KEYWORD(gives_word, "gives");
SEAM_KEYWORD(none_word, "none");
SEAM_KEYWORD(one_word, "one");
SEAM_KEYWORD(truncated_word, "truncated");
SEAM_KEYWORD(infinity_word, "infinity");
SEAM_KEYWORD(plane_word, "plane");
SEAM_KEYWORD(read_word, "read");
SEAM_KEYWORD(from_word, "from");
SEAM_KEYWORD(rational_word, "rational");
SEAM_KEYWORD(triangle_patch_word, "triangle_patch");
SEAM_KEYWORD(quad_patch_word, "quad_patch");
SEAM_KEYWORD(curve_word, "curve");

struct in_word : peg::sor<keyword<TAO_PEGTL_STRING("in")>, special<U'∈'>> {};
struct not_word : peg::sor<keyword<TAO_PEGTL_STRING("not")>, special<U'¬'>> {};
struct and_word : peg::sor<keyword<TAO_PEGTL_STRING("and")>, special<U'∧'>> {};
struct or_word : peg::sor<keyword<TAO_PEGTL_STRING("or")>, special<U'∨'>> {};
SEAM_KEYWORD(implies_word, "implies");
SEAM_KEYWORD(iff_word, "iff");

#undef SEAM_KEYWORD

struct for_all_sign : special<U'∀'> {};
struct for_some_sign : special<U'∃'> {};
struct root_sign : special<U'√'> {};

struct colon : sign<':'> {};
struct comma : sign<','> {};
struct semicolon : sign<';'> {};
struct open_paren : sign<'('> {};
struct close_paren : sign<')'> {};
struct open_bracket : sign<'['> {};
struct close_bracket : sign<']'> {};
struct open_brace : sign<'{'> {};
struct close_brace : sign<'}'> {};
struct dots : sign<'.', '.'> {};
struct arrow : sign<'-', '>'> {};

struct plus_sign : sign<'+'> {};
struct minus_sign : peg::seq<peg::one<'-'>, peg::not_at<peg::one<'>'>>, gap> {};
struct times_sign : peg::sor<peg::seq<peg::one<'*'>, peg::not_at<peg::one<'*'>>, gap>,
                             special<U'·'>, special<U'⋅'>> {};
struct divide_sign : sign<'/'> {};
struct power_sign : sign<'^'> {};

struct equal_sign : peg::seq<peg::one<'='>, peg::not_at<peg::one<'=', '<', '>'>>, gap> {};
struct unequal_sign : peg::sor<sign<'!', '='>, special<U'≠'>> {};
struct at_most_sign : peg::sor<sign<'<', '='>, special<U'≤'>> {};
struct at_least_sign : peg::sor<sign<'>', '='>, special<U'≥'>> {};
struct less_sign : peg::seq<peg::one<'<'>, peg::not_at<peg::one<'>'>>, gap> {};
struct greater_sign : sign<'>'> {};
struct rounds_sign : peg::sor<sign<'~'>, special<U'≈'>> {};

}  // namespace seam::claims::grammar
