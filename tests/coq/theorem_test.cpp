// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "coq/export.h"

namespace seam::coq {
namespace {

using certificate::Certificate;
using certificate::Computation;
using certificate::Node;

/// s u^2 - 1/2 = 0, with s^2 - 5 = 0.
Certificate example() {
  Certificate c;
  c.claim = "a (*";
  c.statement.nodes = {
      {Node::Kind::symbol, "s", {}, 0},     {Node::Kind::power, "", {0}, 2},
      {Node::Kind::constant, "-5", {}, 0},  {Node::Kind::sum, "", {1, 2}, 0},
      {Node::Kind::symbol, "u", {}, 0},     {Node::Kind::power, "", {4}, 2},
      {Node::Kind::product, "", {0, 5}, 0}, {Node::Kind::constant, "-1/2", {}, 0},
      {Node::Kind::sum, "", {6, 7}, 0}};
  c.statement.generators = {{"s", 3, "2", "3", certificate::Elementary::none, 0}};
  c.statement.obligations = {certificate::Zero{8}};
  c.evidence.proofs = {Computation{}};
  c.statement.goal = {certificate::Goal::Kind::obligation, {}, 0};
  return c;
}

TEST(Theorem, IsSaidInTermsOfRealNumbers) {
  const Theorem theorem = write_theorem(example(), 0, Shown::holds, "t");
  EXPECT_EQ(theorem.left_out, "");
  EXPECT_TRUE(
      theorem.text.starts_with("Theorem t :\n"
                               "  forall s : R, 2 <= s <= 3 -> s ^ 2 + (-5) = 0 ->\n"
                               "  forall u : R,\n"
                               "  s * u ^ 2 + (-1 / 2) = 0.\n"))
      << theorem.text;
}

TEST(Theorem, IsNotWrittenOfAnObligationOfAnotherKind) {
  Certificate c = example();
  c.statement.obligations = {certificate::Gluing{}};
  const Theorem theorem = write_theorem(c, 0, Shown::holds, "t");
  EXPECT_EQ(theorem.text, "");
  EXPECT_EQ(theorem.kind, "gluing");
  EXPECT_EQ(theorem.left_out, "of another kind");
}

TEST(Theorem, IsNotWrittenWithoutEvidence) {
  Certificate c = example();
  c.evidence.proofs = {certificate::Nothing{"effort", ""}};
  EXPECT_EQ(write_theorem(c, 0, Shown::open, "t").left_out, "undecided");
}

TEST(Theorem, OfAFailureNamesAPoint) {
  Certificate c = example();
  c.evidence.proofs = {certificate::Witness{{{"u"}, {2}}, {}}};
  const Theorem theorem = write_theorem(c, 0, Shown::fails, "t");
  EXPECT_NE(theorem.text.find("  exists u : R,\n  ~ (s * u ^ 2 + (-1 / 2) = 0).\n"),
            std::string::npos)
      << theorem.text;
}

TEST(File, SaysWhatIsNotExportedAndClosesNoCommentEarly) {
  Certificate c = example();
  c.statement.obligations = {certificate::Gluing{}};
  const Exported exported = write_file(c, {}, "x *) Axiom");
  EXPECT_NE(exported.text.find("Obligation 1 is not exported: gluing, of another kind"),
            std::string::npos);
  EXPECT_EQ(exported.text.find("*) Axiom"), std::string::npos);
}

}  // namespace
}  // namespace seam::coq
