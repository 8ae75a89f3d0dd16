// SPDX-License-Identifier: GPL-3.0-or-later
#include "drafting.h"

namespace seam::prove {
namespace {

using certificate::Relation;
using certificate::Sign;
using certificate::Verdict;
using certificate::Zero;

struct SignProofs : testing::Test {
  Draft d;
  T u = d.symbol("u"), v = d.symbol("v");
  T root5() { return d.generator("sqrt(5)", (d.symbol("sqrt(5)") ^ 2) - 5, "2", "3"); }
  Verdict on_triangle(T f, Relation relation, bool open = false) {
    return d.verdict(Sign{f.term, relation, {{d.triangle(open)}, {}}});
  }
  Verdict on_square(T f, Relation relation) {
    return d.verdict(
        Sign{f.term, relation, {{d.segment("u", "0", "1"), d.segment("v", "0", "1")}, {}}});
  }
  Verdict on_segment(T f, Relation relation, bool open_low = false, bool open_high = false) {
    return d.verdict(
        Sign{f.term, relation, {{d.segment("u", "0", "1", open_low, open_high)}, {}}});
  }
};

TEST_F(SignProofs, an_identity_is_zero) {
  EXPECT_EQ(d.verdict(Zero{(((u + v) ^ 2) - ((u ^ 2) + 2 * u * v + (v ^ 2))).term}),
            Verdict::proven);
}

TEST_F(SignProofs, what_is_no_identity_is_refuted_at_a_point) {
  EXPECT_EQ(d.verdict(Zero{(((u + v) ^ 2) - ((u ^ 2) + (v ^ 2))).term}), Verdict::refuted);
  EXPECT_EQ(d.verdict(Zero{((u * (u - 1) * (u - 2)) * v).term}), Verdict::refuted);
}

TEST_F(SignProofs, an_identity_may_rest_on_a_number) {
  const T s = root5();
  EXPECT_EQ(d.verdict(Zero{((u - s) * (u + s) - ((u ^ 2) - 5)).term}), Verdict::proven);
  EXPECT_EQ(d.verdict(Zero{((u - s) * (u + s) - ((u ^ 2) - 4)).term}), Verdict::refuted);
}

TEST_F(SignProofs, a_sign_of_a_number_is_computed) {
  const T s = root5();
  EXPECT_EQ(d.verdict(Sign{(s - 2).term, Relation::positive, {}}), Verdict::proven);
  EXPECT_EQ(d.verdict(Sign{(s - 3).term, Relation::positive, {}}), Verdict::refuted);
}

TEST_F(SignProofs, a_positive_polynomial_takes_some_cuts) {
  const T f = 100 * ((u - v) ^ 2) + 3 * (u + v - 1) + 4;
  EXPECT_EQ(on_triangle(f, Relation::positive), Verdict::proven);
  EXPECT_EQ(on_triangle(f, Relation::negative), Verdict::refuted);
  EXPECT_EQ(on_triangle(f - 3, Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, a_negative_value_in_a_small_dip_is_found) {
  const T f = 1000000 * (((7 * u - 2) ^ 2) + ((7 * v - 3) ^ 2)) - 1;
  EXPECT_EQ(on_triangle(f, Relation::nonnegative), Verdict::refuted);
  EXPECT_EQ(on_triangle(f + 2, Relation::positive), Verdict::proven);
}

TEST_F(SignProofs, a_zero_at_a_rational_point_is_touched) {
  const T f = ((3 * u - 1) ^ 2) + ((3 * v - 1) ^ 2) + (3 * u - 1) * (3 * v - 1);
  EXPECT_EQ(on_triangle(f, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_triangle(f, Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, a_narrow_zero_inside_is_touched) {
  const T f = 50 * ((3 * u - 3 * v) ^ 2) + ((3 * u + 3 * v - 2) ^ 2) + ((3 * u - 1) ^ 3);
  EXPECT_EQ(on_triangle(2 * f - ((3 * u - 1) ^ 3), Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_triangle(2 * f - ((3 * u - 1) ^ 3), Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, a_zero_at_a_corner_is_touched) {
  const T f = 3 * (u ^ 2) - 5 * u * v + 3 * (v ^ 2);
  EXPECT_EQ(on_triangle(f, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_triangle(f, Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, a_zero_within_an_edge_is_touched) {
  const T f = ((3 * u - 1) ^ 2) + v;
  EXPECT_EQ(on_triangle(f, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_triangle(f, Relation::positive), Verdict::refuted);
  EXPECT_EQ(on_triangle(f - 3 * (v ^ 2), Relation::nonnegative), Verdict::refuted);
}

TEST_F(SignProofs, an_irrational_zero_within_an_edge_is_touched) {
  const T f = ((2 * (u ^ 2) - 1) ^ 2) + v;
  EXPECT_EQ(on_triangle(f, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_triangle(f, Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, a_zero_inside_with_coordinates_in_the_field_is_touched) {
  const T s = root5();
  const T a = 4 * u - (s - 1), b = 3 * v - 1;
  const T f = (a ^ 2) + (b ^ 2) + a * b;
  EXPECT_EQ(on_triangle(f, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_triangle(f, Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, a_zero_inside_a_square_is_touched_if_its_axes_are_those_of_the_square) {
  const T f = ((3 * u - 1) ^ 2) + ((2 * v - 1) ^ 2);
  EXPECT_EQ(on_square(f, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_square(f, Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, a_skew_zero_inside_a_square_stays_undecided) {
  const T a = 3 * u - 1, b = 2 * v - 1;
  EXPECT_EQ(on_square((a ^ 2) + (b ^ 2) + a * b, Relation::nonnegative), Verdict::undecided);
  EXPECT_TRUE(d.last.starts_with("degenerate"));
}

TEST_F(SignProofs, a_square_is_split_off) {
  const T f = ((3 * u - 2 * v - 1) ^ 2) * (u + v + 1);
  EXPECT_EQ(on_triangle(f, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_triangle(-f, Relation::nonpositive), Verdict::proven);
  EXPECT_EQ(on_triangle(f, Relation::positive), Verdict::refuted);
  EXPECT_EQ(on_triangle(((3 * u - 2 * v - 1) ^ 2) * (u + v - 1), Relation::nonnegative),
            Verdict::refuted);
}

TEST_F(SignProofs, a_square_is_split_off_where_no_subdivision_helps) {
  EXPECT_EQ(on_square((u - v) ^ 2, Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_square((u - v) ^ 2, Relation::positive), Verdict::refuted);
  EXPECT_EQ(on_square((u - v) ^ 3, Relation::nonnegative), Verdict::refuted);
}

TEST_F(SignProofs, an_open_facet_may_carry_a_zero) {
  EXPECT_EQ(on_segment(u, Relation::positive), Verdict::refuted);
  EXPECT_EQ(on_segment(u, Relation::positive, true), Verdict::proven);
  EXPECT_EQ(on_segment(u * (1 - u), Relation::positive, true, true), Verdict::proven);
  EXPECT_EQ(on_segment(u * (1 - u), Relation::positive, true, false), Verdict::refuted);
  EXPECT_EQ(on_triangle(u * v * (1 - u - v), Relation::positive, true), Verdict::proven);
  EXPECT_EQ(on_triangle(u * v * (1 - u - v), Relation::positive, false), Verdict::refuted);
}

TEST_F(SignProofs, a_ray_ends_at_infinity) {
  const auto on_ray = [&](T f, Relation relation) {
    return d.verdict(Sign{f.term, relation, {{d.from_zero("u")}, {}}});
  };
  EXPECT_EQ(on_ray((u ^ 2) - u + 1, Relation::positive), Verdict::proven);
  EXPECT_EQ(on_ray((u ^ 2) - 3 * u + 1, Relation::positive), Verdict::refuted);
  EXPECT_EQ(on_ray(((u - 3) ^ 2), Relation::nonnegative), Verdict::proven);
  EXPECT_EQ(on_ray(1000 - u, Relation::positive), Verdict::refuted);
}

TEST_F(SignProofs, nonzero_has_one_sign_throughout) {
  EXPECT_EQ(on_triangle(u + v - 2, Relation::nonzero), Verdict::proven);
  EXPECT_EQ(on_triangle(u + v + 1, Relation::nonzero), Verdict::proven);
  EXPECT_EQ(on_triangle(3 * u - v - 1, Relation::nonzero), Verdict::refuted);
  EXPECT_EQ(on_triangle(((3 * u - 1) ^ 2) + ((3 * v - 1) ^ 2), Relation::nonzero),
            Verdict::refuted);
}

TEST_F(SignProofs, zero_on_a_domain_is_zero_everywhere) {
  EXPECT_EQ(on_triangle(u - u, Relation::zero), Verdict::proven);
  EXPECT_EQ(on_triangle(u * v, Relation::zero), Verdict::refuted);
}

TEST_F(SignProofs, a_condition_cuts_the_domain) {
  const T f = u - v;
  const auto where = [&](T condition, Relation relation, Relation claimed) {
    return d.verdict(Sign{f.term, claimed, {{d.triangle()}, {{condition.term, relation}}}});
  };
  EXPECT_EQ(where(u - 2 * v - d.number("1/10"), Relation::nonnegative, Relation::positive),
            Verdict::proven);
  EXPECT_EQ(where(u - v + d.number("1/10"), Relation::nonnegative, Relation::positive),
            Verdict::refuted);
}

TEST_F(SignProofs, a_constant_is_decided_wherever_the_domain_is_open) {
  EXPECT_EQ(on_triangle(d.number("3"), Relation::positive, true), Verdict::proven);
  EXPECT_EQ(on_triangle(d.number("-3"), Relation::positive, true), Verdict::refuted);
  EXPECT_EQ(on_triangle(u, Relation::negative, true), Verdict::refuted);
}

TEST_F(SignProofs, a_symbol_that_no_factor_holds_ranges_over_all_reals) {
  EXPECT_EQ(on_segment(u + v, Relation::positive), Verdict::refuted);
}

}  // namespace
}  // namespace seam::prove
