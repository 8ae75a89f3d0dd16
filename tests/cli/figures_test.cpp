// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the figures of a file.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "process.h"

namespace seam::test {
namespace {

namespace fs = std::filesystem;

class Figures : public testing::Test {
 protected:
  Figures() { fs::create_directories(folder_); }
  ~Figures() override { fs::remove_all(folder_); }

  Finished verify(const std::string& text) const {
    std::ofstream(folder_ / "a.seam") << text;
    return run("cd " + quoted(folder_.string()) + " && " + quoted(SEAMPROOF) +
               " verify a.seam --out out");
  }
  std::string read(const std::string& name) const {
    std::ifstream file(folder_ / "out/figures" / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  const fs::path folder_ = fs::path(testing::TempDir()) /
                           (std::string("seamproof_figures_") +
                            testing::UnitTest::GetInstance()->current_test_info()->name());
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string saddle = "let p = quad_patch from (u, v, u*v)\n";

TEST_F(Figures, have_files_named_by_id_or_title) {
  EXPECT_EQ(
      verify(saddle + "figure \"A Saddle!\": p\nfigure b.c \"T\": p coloured by mean\n").status,
      0);
  EXPECT_TRUE(holds(read("a-saddle.svg"), "<title>A Saddle!</title>"));
  EXPECT_TRUE(holds(read("b.c.svg"), "mean curvature H"));
  EXPECT_TRUE(read("b.c.glb").starts_with("glTF"));
}

TEST_F(Figures, have_the_same_bytes_again) {
  const std::string text =
      saddle + "figure f \"F\": p coloured by gauss with curvature_lines\n";
  verify(text);
  const std::string svg = read("f.svg"), glb = read("f.glb");
  verify(text);
  EXPECT_EQ(read("f.svg"), svg);
  EXPECT_EQ(read("f.glb"), glb);
}

TEST_F(Figures, mark_where_a_claim_about_a_patch_is_refuted) {
  verify(saddle +
         "claim wrong: for u in [0, 1]: gauss(p)(u, 1/2) > 0\n    expect refuted\n"
         "claim right: for u in [0, 1]: gauss(p)(u, 1/2) < 0\n"
         "figure f \"F\": p\n");
  EXPECT_TRUE(holds(read("f.svg"), ">wrong</text>"));
  EXPECT_FALSE(holds(read("f.svg"), ">right</text>"));
}

TEST_F(Figures, do_not_mark_a_patch_that_the_witness_may_not_be_about) {
  verify(saddle +
         "let q = quad_patch from (u, v, u^2)\n"
         "claim either: max(gauss(p)) < 0 and max(gauss(q)) < 0\n    expect refuted\n"
         "claim other: max(gauss(q)) < 0\n    expect refuted\n"
         "figure f \"F\": p\n");
  EXPECT_FALSE(holds(read("f.svg"), "<circle"));
}

TEST_F(Figures, of_what_has_no_picture_are_refused_with_a_hint) {
  const Finished finished = verify("let f(u, v) = u*v\nfigure \"F\": f\n");
  EXPECT_EQ(finished.status, 65);
  EXPECT_TRUE(holds(finished.output, "has no picture")) << finished.output;
  EXPECT_TRUE(holds(finished.output, "f(u, v) for (u,v) in triangle")) << finished.output;
}

TEST_F(Figures, over_an_unbounded_domain_are_refused) {
  const Finished finished = verify("figure \"F\": u^2 for u in [0, infinity)\n");
  EXPECT_EQ(finished.status, 65);
  EXPECT_TRUE(holds(finished.output, "bounded domain")) << finished.output;
}

TEST_F(Figures, of_a_flat_patch_have_curvature_zero_and_no_noise) {
  verify(
      "let c = quad_patch from (u^2, v^2, u*v)\n"
      "figure f \"F\": c coloured by gauss\n");
  EXPECT_TRUE(holds(read("f.svg"), "from 0 to 0.")) << read("f.svg").substr(0, 600);
}

}  // namespace
}  // namespace seam::test
