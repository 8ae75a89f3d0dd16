// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/second_opinion.h"

#include <gtest/gtest.h>

namespace seam::symbolic {
namespace {

using namespace certificate;

// sqrt(5), u, and some formulas in them.
Statement statement() {
  Statement s;
  s.nodes = {{Node::Kind::symbol, "sqrt(5)", {}, 0},  // 0
             {Node::Kind::power, "", {0}, 2},         // 1: sqrt(5)^2
             {Node::Kind::constant, "-5", {}, 0},     // 2
             {Node::Kind::sum, "", {1, 2}, 0},        // 3: sqrt(5)^2 - 5
             {Node::Kind::symbol, "u", {}, 0},        // 4
             {Node::Kind::product, "", {4, 3}, 0},    // 5: u (sqrt(5)^2 - 5)
             {Node::Kind::constant, "0", {}, 0},      // 6
             {Node::Kind::constant, "1", {}, 0},      // 7
             {Node::Kind::sum, "", {4, 2}, 0}};       // 8: u - 5
  s.generators = {{"sqrt(5)", 3, "2", "3"}};
  return s;
}

const Domain unit_interval{{{{"u"}, {{7, 6}, {7, 7}}, {false, false}}}, {}};

TEST(SecondOpinion, agrees_with_an_identity_in_a_number_field) {
  EXPECT_FALSE(contradiction(statement(), Zero{5}));
}

TEST(SecondOpinion, contradicts_an_identity_that_is_none) {
  EXPECT_TRUE(contradiction(statement(), Zero{8}));
}

TEST(SecondOpinion, contradicts_a_wrong_sign_inside_the_domain) {
  EXPECT_TRUE(contradiction(statement(), Sign{8, Relation::positive, unit_interval}));
  EXPECT_FALSE(contradiction(statement(), Sign{8, Relation::negative, unit_interval}));
}

// r = sqrt(radicand), and r^2 - u, r - 5, r.
Statement with_root(Term radicand) {
  Statement s = statement();
  s.nodes.insert(s.nodes.end(), {{Node::Kind::symbol, "r", {}, 0},       // 9
                                 {Node::Kind::power, "", {9}, 2},        // 10
                                 {Node::Kind::constant, "-1", {}, 0},    // 11
                                 {Node::Kind::product, "", {11, 4}, 0},  // 12: -u
                                 {Node::Kind::sum, "", {10, 12}, 0},     // 13: r^2 - u
                                 {Node::Kind::sum, "", {9, 2}, 0}});     // 14: r - 5
  s.functions = {{"r", radicand, 2}};
  return s;
}

TEST(SecondOpinion, gives_functions_their_values) {
  EXPECT_FALSE(contradiction(with_root(4), Zero{13}));
  EXPECT_TRUE(contradiction(with_root(4), Zero{14}));
  EXPECT_FALSE(contradiction(with_root(4), Sign{14, Relation::negative, unit_interval}));
  EXPECT_TRUE(contradiction(with_root(4), Sign{14, Relation::positive, unit_interval}));
}

TEST(SecondOpinion, says_nothing_where_a_function_has_no_value) {
  EXPECT_FALSE(contradiction(with_root(8), Sign{14, Relation::positive, unit_interval}));
  EXPECT_TRUE(contradiction(with_root(8), Sign{8, Relation::positive, unit_interval}));
}

TEST(SecondOpinion, a_function_that_is_zero_is_not_mistaken_for_a_small_one) {
  EXPECT_FALSE(contradiction(with_root(3), Zero{9}));  // the root of sqrt(5)^2 - 5
}

}  // namespace
}  // namespace seam::symbolic
