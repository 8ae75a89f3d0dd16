// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/grammar.h"

// The items of a file, each from its first word to where the next item may begin.
namespace seam::claims::grammar {

struct header_colon : colon {};     // before what the item is about
struct statement_colon : colon {};  // before a claim's statement
struct claim_statement : body {};
struct item_value : operand {};
struct item_statement : body {};

struct title_text : string {};
struct at_text : string {};
struct at : peg::if_must<at_word, at_text> {};

// ---- paper, section, include

struct author : string {};
struct by_author : peg::if_must<by_word, author> {};
struct source_text : string {};
struct source : peg::if_must<source_word, source_text> {};
struct year_number : whole_number {};
struct year : peg::if_must<year_word, year_number> {};
struct paper
    : peg::if_must<paper_word, title_text, peg::star<peg::sor<by_author, source, year>>> {};

struct section : peg::if_must<section_word, title_text> {};
struct include : peg::if_must<include_word, title_text> {};

// ---- let, define

struct item_name : name {};
struct parameter : name {};
struct parameters : peg::if_must<open_paren, peg::list_must<parameter, comma>, close_paren> {};
struct defines : equal_sign {};
struct let : peg::if_must<let_word, item_name, peg::opt<parameters>, defines, item_value> {};
struct define
    : peg::if_must<define_word, item_name, peg::opt<parameters>, header_colon, item_statement> {
};

// ---- sequence

struct sequence_start : operand {};
struct sequence_then : then_word {};
struct sequence_step : operand {};
struct sequence : peg::if_must<sequence_word, item_name, open_paren, parameter, close_paren,
                               defines, sequence_start, sequence_then, sequence_step> {};

// ---- param, root

struct param_name : name {};
struct dimension : whole_number {};
struct integer_type : integer_word {};
struct arity : whole_number {};
struct begins_function : function_word {};
struct function_values : peg::if_must<begins_function, peg::opt<peg::if_must<of_word, arity>>> {
};
struct vector_type : peg::seq<peg::if_must<vector_word, dimension>, peg::opt<function_values>> {
};
struct mesh_type : mesh_word {};
struct type_name : peg::sor<integer_type, mesh_type, vector_type, function_values> {};
struct type : peg::if_must<colon, type_name> {};
struct param_set : peg::if_must<in_word, set> {};
struct param_where : peg::if_must<where_word, where_body> {};
struct param : peg::if_must<param_word, peg::list_must<param_name, comma>, peg::opt<type>,
                            peg::opt<param_set>, peg::opt<param_where>> {};

// `curve x, y generic`: curves in space, as params that are functions.
struct some_curves : peg::seq<peg::at<curve_word, some_names, generic_word>, curve_word> {};
struct is_generic : generic_word {};
struct generic_curves
    : peg::if_must<some_curves, peg::list_must<param_name, comma>, is_generic> {};

struct polynomial : item_value {};
struct root_of : of_word {};
struct root_in : in_word {};
struct root_item : peg::if_must<root_word, item_name, root_of, polynomial, root_in, set> {};

// ---- claim

struct claim_id : id {};
struct corrected_statement : body {};
struct corrected : peg::if_must<corrected_word, header_colon, corrected_statement> {};
struct expectation : peg::sor<refuted_word, undecided_word> {};
struct expect : peg::if_must<expect_word, expectation> {};
struct used_id : id {};
struct uses : peg::if_must<using_word, peg::list_must<used_id, comma>> {};
struct hint_argument : peg::sor<number_value, name_value> {};
struct hint : peg::seq<name_value, peg::opt<peg::sor<call, hint_argument>>> {};
struct hints : peg::if_must<by_word, peg::list_must<hint, comma>> {};
struct claim
    : peg::if_must<claim_word, claim_id, peg::star<peg::sor<title_text, at>>, statement_colon,
                   claim_statement, peg::star<peg::sor<corrected, expect, uses, hints>>> {};

// ---- table, figure, ask

struct column_label : string {};
struct labelled : peg::if_must<labelled_word, peg::list_must<column_label, comma>> {};
struct columns : peg::if_must<for_word, ranged> {};
struct row_label : string {};
struct row_value : operand {};
struct printed_value : operand {};
struct cell_corrected : corrected_word {};
struct right_value : operand {};
struct cell : peg::seq<printed_value, peg::opt<peg::if_must<cell_corrected, right_value>>> {};
struct row_rounds : rounds_sign {};
struct row_cut_off : truncated_word {};
struct row : peg::if_must<row_label, row_value, row_rounds, peg::list_must<cell, comma>,
                          peg::opt<row_cut_off>> {};
struct table
    : peg::if_must<table_word, claim_id, peg::star<peg::sor<title_text, at>>, peg::opt<columns>,
                   peg::opt<labelled>, header_colon, peg::plus<row>> {};

// `S`, or a function over a domain: `f(u, v) for (u,v) in triangle`.
struct shown_value : deeper<statement> {};
struct shown : peg::seq<shown_value, peg::opt<peg::if_must<each_begins, each>>> {};
struct colour : operand {};
struct coloured_by : by_word {};
struct coloured : peg::if_must<coloured_word, coloured_by, colour> {};
struct drawn : name {};
struct drawn_with : peg::if_must<with_word, peg::list_must<drawn, comma>> {};
struct figure : peg::if_must<figure_word, peg::opt<claim_id>, title_text, peg::opt<at>,
                             header_colon, shown, peg::star<peg::sor<coloured, drawn_with>>> {};

struct digit_count : whole_number {};
struct digits : peg::if_must<digits_word, digit_count> {};
struct ask : peg::if_must<ask_word, claim_id, header_colon, item_statement, peg::opt<digits>> {
};

// ---- a file is a gap and items; each item is read by itself, so that one may fail alone

struct item_word : peg::sor<paper_word, section_word, let_word, sequence_word, param_word,
                            root_word, include_word, define_word, claim_word, table_word,
                            figure_word, ask_word, some_curves> {};
struct at_line_begin : holds<&Builder::at_line_begin> {};
struct item_end : peg::sor<peg::eof, peg::seq<at_line_begin, peg::at<item_word>>> {};
struct item : peg::sor<paper, section, let, sequence, param, generic_curves, root_item, include,
                       define, claim, table, figure, ask> {};
struct whole_item : peg::seq<peg::must<item>, peg::must<item_end>> {};

struct expression_end : peg::eof {};
struct whole_expression : peg::seq<gap, peg::must<item_statement>, peg::must<expression_end>> {
};

}  // namespace seam::claims::grammar
