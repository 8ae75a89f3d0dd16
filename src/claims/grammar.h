// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/tokens.h"

// Values and statements. The grammar looks ahead at most at the head of a binding or of a named
// argument; elsewhere the next token decides, and what has been read stays read. So reading
// takes linear time, and an action is never taken back.
//
// `open` marks where a group of nodes begins; the action of the rule that ends it makes one
// node of the group.
namespace seam::claims::grammar {

struct open : peg::success {};

constexpr int max_depth = 200;

/// Refuses to go deeper than `max_depth`: the parser recurses.
template <typename Rule>
struct deeper {
  using rule_t = deeper;
  using subs_t = peg::type_list<Rule>;
  template <peg::apply_mode A, peg::rewind_mode M, template <typename...> class Action,
            template <typename...> class Control, typename Input>
  static bool match(Input& in, Builder& b) {
    if (b.depth >= max_depth)
      b.fail("this is nested more than " + std::to_string(max_depth) + " deep",
             b.token_at(b.gap_end), "give a name to a part of it with 'let'");
    ++b.depth;
    const bool matched = Control<Rule>::template match<A, M, Action, Control>(in, b);
    --b.depth;
    return matched;
  }
};

/// Consumes nothing; asks the builder.
template <bool (Builder::*Holds)() const>
struct holds {
  using rule_t = holds;
  using subs_t = peg::type_list<>;
  template <peg::apply_mode, peg::rewind_mode, template <typename...> class,
            template <typename...> class, typename Input>
  static bool match(Input&, Builder& b) {
    return (b.*Holds)();
  }
};

struct statement;
struct body : deeper<statement> {};  // a statement that must come
struct value;
struct operand : deeper<value> {};  // a value that must come

// ---- bindings: `u in [0,1] where S`, `(u,v) in triangle`, `u, v`

struct one_name : name {};
struct where_body : body {};
struct where : peg::if_must<where_word, where_body> {};
struct set_begins : peg::success {};
struct set : peg::seq<set_begins, operand> {};
struct name_tuple
    : peg::seq<open_paren, peg::list_must<one_name, comma>, peg::must<close_paren>> {};
struct bound_names : peg::seq<open, peg::sor<one_name, name_tuple>> {};
struct bound_in : in_word {};
struct ranged : peg::seq<open, peg::must<bound_names, bound_in, set>, peg::opt<where>> {};
struct some_names : peg::seq<word_text, gap, peg::star<peg::one<','>, gap, word_text, gap>> {};
struct ranged_head
    : peg::seq<peg::sor<peg::seq<word_text, gap>,
                        peg::seq<peg::one<'('>, gap, some_names, peg::one<')'>, gap>>,
               in_word> {};
struct ranged_list : peg::seq<ranged, peg::star<peg::if_must<comma, ranged>>> {};

struct no_set : peg::not_at<in_word> {};
struct bare_names : peg::seq<open, peg::list_must<one_name, comma>, peg::must<no_set>> {};
struct bare_binding : peg::seq<open, bare_names, peg::opt<where>> {};
struct begins_ranged : peg::at<peg::sor<ranged_head, peg::one<'('>>> {};

// ---- what may stand between brackets: `E`, `E for i in 0..3`, `E for n -> infinity`, `u =
// 1/3`

struct limit_target : operand {};
struct limit
    : peg::seq<peg::at<word_text, gap, arrow>, peg::must<one_name, arrow, limit_target>> {};
struct each
    : peg::seq<ranged, peg::star<peg::at<peg::one<','>, gap, ranged_head>, comma, ranged>> {};
struct each_head : peg::sor<limit, each> {};
struct each_begins : for_word {};
struct each_tail : peg::if_must<each_begins, each_head> {};
struct element : peg::seq<deeper<statement>, peg::opt<each_tail>> {};
struct next_element : element {};
struct elements : peg::seq<element, peg::star<peg::if_must<comma, next_element>>> {};

struct argument_value : operand {};
struct named : peg::seq<peg::not_at<infinity_word>, peg::at<word_text, gap, equal_sign>,
                        peg::must<one_name, equal_sign, argument_value>> {};
struct argument : peg::sor<named, element> {};
struct next_argument : argument {};
struct arguments : peg::seq<argument, peg::star<peg::if_must<comma, next_argument>>> {};

// ---- brackets

struct closes_half_open : holds<&Builder::at_half_open> {};
struct open_tuple : open_paren {};
struct tuple_end : peg::sor<close_paren, peg::seq<closes_half_open, close_bracket>> {};
struct part : deeper<statement> {};
struct parts : peg::list_must<part, comma> {};
struct parenthesis : peg::if_must<open_tuple, parts, tuple_end> {};

struct open_list : open_bracket {};
struct row_end : semicolon {};
struct list_end : peg::sor<close_bracket, peg::seq<closes_half_open, close_paren>> {};
struct next_row : peg::sor<peg::at<peg::one<']'>>, elements> {};
struct rows : peg::seq<elements, peg::star<peg::if_must<row_end, next_row>>> {};
struct bracket : peg::if_must<open_list, peg::opt<rows>, list_end> {};

// ---- patches

template <typename Word>
struct shape : Word {};
struct any_shape
    : peg::sor<shape<triangle_patch_word>, shape<quad_patch_word>, shape<curve_word>> {};
struct rational : rational_word {};
struct patch_begins
    : peg::at<peg::sor<rational_word, triangle_patch_word, quad_patch_word, curve_word>> {};

struct weight_value : operand {};
struct weight : peg::if_must<colon, weight_value> {};
struct entry : peg::seq<operand, peg::opt<peg::sor<each_tail, weight>>> {};
struct next_entry : entry {};
struct entries : peg::seq<entry, peg::star<peg::if_must<comma, next_entry>>> {};
struct next_net_row : peg::sor<peg::at<peg::one<']'>>, entries> {};
struct net_end : close_bracket {};
struct net : peg::if_must<open_bracket, entries, peg::star<peg::if_must<row_end, next_net_row>>,
                          net_end> {};

struct label : peg::seq<peg::list<peg::plus<peg::digit>, peg::one<','>>> {};
struct label_colon : colon {};
struct point : entry {};
struct control_point : peg::seq<label, gap, peg::must<label_colon, point>> {};
struct next_control : peg::sor<peg::at<peg::one<'}'>>, control_point> {};
struct controls
    : peg::seq<peg::must<control_point>, peg::star<peg::if_must<semicolon, next_control>>> {};
struct controls_end : close_brace {};
struct indexed : peg::seq<operand, peg::must<open_brace>, controls, peg::must<controls_end>> {};

struct formula : operand {};
struct from : peg::if_must<from_word, formula> {};
struct patch_rest : peg::sor<net, from, indexed> {};
struct patch : peg::seq<patch_begins, open, peg::opt<rational>, peg::must<any_shape>,
                        peg::must<patch_rest>> {};

// ---- values, loosest last

struct name_value : name {};
struct number_value : number {};
struct string_value : string {};
struct infinity_value : infinity_word {};
struct path : string {};
struct read : peg::if_must<read_word, path> {};

struct open_call : open_paren {};
struct call_end : close_paren {};
struct call : peg::if_must<open_call, peg::opt<arguments>, call_end> {};
struct open_index : open_bracket {};
struct index_end : close_bracket {};
struct index : peg::if_must<open_index, parts, index_end> {};

struct postfix;
struct rooted : deeper<postfix> {};
struct root : peg::if_must<root_sign, rooted> {};

struct adjacent : holds<&Builder::at_token_end> {};  // `plane normal(f) d`, and `plane n (d)`
struct callable : peg::sor<name_value, parenthesis, bracket, patch> {};
struct plane_normal
    : peg::sor<number_value, peg::seq<callable, peg::star<adjacent, peg::sor<call, index>>>> {};
struct plane_offset;
struct plane : peg::if_must<plane_word, plane_normal, plane_offset> {};

struct postfix : peg::sor<number_value, peg::seq<callable, peg::star<peg::sor<call, index>>>,
                          root, string_value, infinity_value, plane, read> {};

struct factor;
struct exponent : deeper<factor> {};
struct raised : peg::if_must<power_sign, exponent> {};
struct negated : deeper<factor> {};
struct negative : peg::if_must<minus_sign, negated> {};
struct factor : peg::sor<negative, peg::seq<postfix, peg::opt<raised>>> {};

struct right_factor : factor {};
template <typename Sign>
struct combined_factor : peg::if_must<Sign, right_factor> {};
struct product
    : peg::seq<factor,
               peg::star<peg::sor<combined_factor<times_sign>, combined_factor<divide_sign>>>> {
};

struct right_product : product {};
template <typename Sign>
struct combined_product : peg::if_must<Sign, right_product> {};
struct sum
    : peg::seq<product,
               peg::star<peg::sor<combined_product<plus_sign>, combined_product<minus_sign>>>> {
};
struct plane_offset : deeper<sum> {};

struct range_end : sum {};
struct range : peg::if_must<dots, range_end> {};
struct value : peg::seq<sum, peg::opt<range>> {};

// ---- statements, loosest last

struct compared : value {};
template <typename Sign>
struct comparison : peg::if_must<Sign, compared> {};
struct cut_off : truncated_word {};
struct relation
    : peg::seq<value,
               peg::star<peg::sor<comparison<equal_sign>, comparison<unequal_sign>,
                                  comparison<at_most_sign>, comparison<at_least_sign>,
                                  comparison<less_sign>, comparison<greater_sign>,
                                  comparison<rounds_sign>>>,
               peg::opt<cut_off>> {};

struct clause;
struct denied : deeper<clause> {};
struct negation : peg::if_must<not_word, denied> {};

struct quantifier_begins : for_word {};
struct says_all : all_word {};
struct says_some : some_word {};
struct quantifier
    : peg::sor<for_all_sign, for_some_sign,
               peg::seq<quantifier_begins, peg::opt<peg::sor<says_all, says_some>>>> {};
struct bindings : peg::sor<peg::seq<begins_ranged, ranged_list>, bare_binding> {};
struct quantified : peg::if_must<quantifier, bindings, colon, body> {};

struct unknown_names : bare_names {};
struct unknown_ranges : peg::seq<open, ranged_list> {};
struct unknowns : peg::sor<peg::seq<begins_ranged, unknown_ranges>, unknown_names> {};
struct condition : peg::seq<open, peg::opt<where>> {};
struct gives_none : none_word {};
struct gives_one : one_word {};
struct approximation : operand {};
struct solution : operand {};
struct solutions
    : peg::sor<gives_none,
               peg::seq<gives_one, peg::opt<peg::if_must<rounds_sign, approximation>>>,
               peg::list_must<solution, comma>> {};
struct solve_begins : solve_word {};
struct solve
    : peg::if_must<solve_begins, unknowns, colon, body, condition, gives_word, solutions> {};

struct clause : peg::sor<negation, quantified, solve, relation> {};

struct right_clause : clause {};
struct conjoined : peg::if_must<and_word, right_clause> {};
struct conjunction : peg::seq<clause, peg::star<conjoined>> {};

struct right_conjunction : conjunction {};
struct disjoined : peg::if_must<or_word, right_conjunction> {};
struct disjunction : peg::seq<conjunction, peg::star<disjoined>> {};

struct implication;
struct implied : deeper<implication> {};
struct implies : peg::if_must<implies_word, implied> {};
struct implication : peg::seq<disjunction, peg::opt<implies>> {};

struct right_implication : implication {};
struct equivalent : peg::if_must<iff_word, right_implication> {};
struct statement : peg::seq<implication, peg::star<equivalent>> {};

}  // namespace seam::claims::grammar
