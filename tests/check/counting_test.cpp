// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include "builder.h"

namespace seam::check::test {
namespace {

const std::vector<Gluing::Side> triangle = {{0, 1}, {1, 2}, {2, 0}};
const std::vector<Gluing::Side> square = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};

Finding glued(Gluing gluing) {
  Case c;
  c.claim(std::move(gluing));
  return c.finding(Computation{});
}

// Two triangles back to back.
Gluing pillow() {
  return {{triangle, triangle}, {{0, 0, 1, 0}, {0, 1, 1, 1}, {0, 2, 1, 2}}, 2};
}

TEST(Gluing, two_triangles_make_a_sphere) {
  EXPECT_HOLDS(glued(pillow()));
}

TEST(Gluing, a_wrong_characteristic_fails) {
  Gluing gluing = pillow();
  gluing.euler = 0;
  EXPECT_FAILS(glued(gluing));
}

TEST(Gluing, a_square_makes_torus_klein_bottle_and_projective_plane) {
  // Sides run 0-1, 1-2, 2-3, 3-0: opposite ones, each reversed, make a torus.
  EXPECT_HOLDS(glued({{square}, {{0, 0, 0, 2, true}, {0, 1, 0, 3, true}}, 0}));
  EXPECT_HOLDS(glued({{square}, {{0, 0, 0, 2, true}, {0, 1, 0, 3, false}}, 0}));
  EXPECT_HOLDS(glued({{square}, {{0, 0, 0, 2, false}, {0, 1, 0, 3, false}}, 1}));
  EXPECT_HOLDS(glued({{square}, {{0, 0, 0, 1, true}, {0, 2, 0, 3, true}}, 2}));
}

TEST(Gluing, a_side_on_no_seam_fails) {
  Gluing gluing = pillow();
  gluing.seams.pop_back();
  EXPECT_FAILS(glued(gluing));
}

TEST(Gluing, a_side_on_two_seams_fails) {
  Gluing gluing = pillow();
  gluing.seams.push_back({0, 2, 1, 2});
  EXPECT_FAILS(glued(gluing));
}

TEST(Gluing, a_side_glued_to_itself_fails) {
  EXPECT_FAILS(glued({{{{0, 0}}}, {{0, 0, 0, 0}}, 1}));
}

TEST(Gluing, two_spheres_are_not_connected) {
  Gluing gluing = pillow();
  gluing.patches = {triangle, triangle, triangle, triangle};
  for (const int s : {0, 1, 2}) gluing.seams.push_back({2, s, 3, s});
  gluing.euler = 4;  // as V - E + F is
  EXPECT_FAILS(glued(gluing));
}

TEST(Gluing, a_patch_that_is_no_disc_is_not_judged) {
  Gluing gluing = pillow();
  gluing.patches[0] = {{0, 1}, {0, 1}, {2, 2}};
  EXPECT_OPEN(glued(gluing), "closed polygon");
  gluing.patches[0] = {{0, 1}, {1, 2}, {1, 0}};
  EXPECT_OPEN(glued(gluing), "closed polygon");
  gluing.patches[0] = {};
  EXPECT_OPEN(glued(gluing), "");
  EXPECT_OPEN(glued({}), "no patch");
}

TEST(Gluing, the_sense_of_sides_does_not_matter_if_corners_meet) {
  Gluing gluing = pillow();
  gluing.patches[1] = {{1, 0}, {2, 1}, {0, 2}};
  for (auto& seam : gluing.seams) seam.reversed = true;
  EXPECT_HOLDS(glued(gluing));
}

TEST(Gluing, indices_out_of_range_are_rejected) {
  Gluing gluing = pillow();
  gluing.seams[0].patch = 2;
  EXPECT_OPEN(glued(gluing), "malformed");
  gluing = pillow();
  gluing.seams[0].other_side = -1;
  EXPECT_OPEN(glued(gluing), "malformed");
  gluing = pillow();
  gluing.patches[0][0].to = 3;
  EXPECT_OPEN(glued(gluing), "malformed");
}

struct Tuples : Case {
  Term one = number(1), two = number(2), root = Case::root("r", number(4), "1", "3");
};

TEST(Distinct, tuples_that_differ_somewhere_are_distinct) {
  Tuples c;
  c.claim(Distinct{{{c.one, c.two}, {c.two, c.one}, {c.one, c.one}}});
  EXPECT_HOLDS(c.finding(Computation{}));
  c.claim(Distinct{});
  EXPECT_HOLDS(c.finding(Computation{}));
}

TEST(Distinct, equal_tuples_fail) {
  Tuples c;
  c.claim(Distinct{{{c.one, c.two}, {c.one, c.one}, {c.one, c.two}}});
  EXPECT_FAILS(c.finding(Computation{}));
  c.claim(Distinct{{{}, {}}});
  EXPECT_FAILS(c.finding(Computation{}));
}

TEST(Distinct, values_that_are_not_told_apart_stay_open) {
  Tuples c;  // r = 2, though its normal form does not know
  c.claim(Distinct{{{c.one, c.two}, {c.one, c.root}}});
  EXPECT_OPEN(c.finding(Computation{}), "not seen to be different");
  c.claim(Distinct{{{c.one, c.two}, {c.two, c.root}}});
  EXPECT_HOLDS(c.finding(Computation{}));
}

TEST(Distinct, tuples_of_different_lengths_are_rejected) {
  Tuples c;
  c.claim(Distinct{{{c.one, c.two}, {c.one}}});
  EXPECT_OPEN(c.finding(Computation{}), "malformed");
}

}  // namespace
}  // namespace seam::check::test
