// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/second_opinion.h"

#include <gtest/gtest.h>

namespace seam::symbolic {
namespace {

using namespace certificate;

// sqrt(5), u, and some formulas in them.
Statement statement() {
  Statement s;
  s.nodes = {{Node::Kind::symbol, "sqrt(5)", {}, 0},   // 0
             {Node::Kind::power, "", {0}, 2},          // 1: sqrt(5)^2
             {Node::Kind::constant, "-5", {}, 0},      // 2
             {Node::Kind::sum, "", {1, 2}, 0},         // 3: sqrt(5)^2 - 5
             {Node::Kind::symbol, "u", {}, 0},         // 4
             {Node::Kind::product, "", {4, 3}, 0},     // 5: u (sqrt(5)^2 - 5)
             {Node::Kind::constant, "0", {}, 0},       // 6
             {Node::Kind::constant, "1", {}, 0},       // 7
             {Node::Kind::sum, "", {4, 2}, 0}};        // 8: u - 5
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

}  // namespace
}  // namespace seam::symbolic
