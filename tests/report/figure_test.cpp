// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "report/drawing.h"
#include "report/gltf.h"
#include "report/space.h"
#include "report/svg.h"

namespace seam::report {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

template <class T>
int count(const Drawing& drawn) {
  return static_cast<int>(std::ranges::count_if(
      drawn.parts, [](const auto& part) { return std::holds_alternative<T>(part); }));
}

// A tetrahedron with its outside out.
FigureRun tetrahedron() {
  FigureRun figure;
  figure.title = "A tetrahedron";
  figure.closed = true;
  const std::vector<FigureRun::Point> corners = {
      {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}) {
    const int first = static_cast<int>(figure.points.size());
    const Vector normal = direction(cross(corners[b] - corners[a], corners[c] - corners[a]));
    for (const int i : {a, b, c}) {
      figure.points.push_back(corners[i]);
      figure.normals.push_back(normal);
    }
    figure.triangles.push_back({first, first + 1, first + 2});
  }
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      figure.lines.push_back({FigureRun::Line::Kind::edge, {corners[i], corners[j]}});
  return figure;
}

TEST(Figure, of_a_closed_surface_the_facets_and_edges_behind_are_not_drawn) {
  // Three faces look at the eye; turned inside out, the fourth alone does.
  FigureRun figure = tetrahedron();
  EXPECT_EQ(count<Drawing::Polygon>(drawing(figure)), 3);
  EXPECT_EQ(count<Drawing::Stroke>(drawing(figure)), 6);
  for (auto& triangle : figure.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(count<Drawing::Polygon>(drawing(figure)), 1);
  EXPECT_EQ(count<Drawing::Stroke>(drawing(figure)), 3);
}

TEST(Figure, a_line_behind_a_facet_is_hidden_and_one_before_it_is_seen) {
  FigureRun figure;
  figure.points = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  figure.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  figure.triangles = {{0, 1, 2}};
  figure.lines = {{FigureRun::Line::Kind::curve, {}}};
  const auto seen = [&] { return count<Drawing::Stroke>(drawing(figure)); };
  figure.lines[0].points = {{-0.35, -0.26, -0.25}, {-0.3, -0.28, -0.25}};
  EXPECT_EQ(seen(), 0);
  figure.lines[0].points = {{0.35, 0.26, 0.25}, {0.3, 0.28, 0.25}};
  EXPECT_EQ(seen(), 1);
}

TEST(Figure, of_nothing_there_is_nothing_to_see_and_it_can_be_written) {
  const FigureRun figure;
  EXPECT_TRUE(drawing(figure).parts.empty());
  EXPECT_EQ(picture(figure), "");
  EXPECT_TRUE(holds(svg(figure), "</svg>"));
  EXPECT_TRUE(glb(figure).starts_with("glTF"));
}

TEST(Figure, says_that_it_proves_nothing_in_every_form) {
  const FigureRun figure = tetrahedron();
  EXPECT_TRUE(holds(svg(figure), "<desc>A drawing of samples; it proves nothing."));
  EXPECT_TRUE(holds(glb(figure), "A drawing of samples; it proves nothing."));
}

TEST(Figure, as_svg_has_a_title_that_is_text_whatever_it_holds) {
  FigureRun figure = tetrahedron();
  figure.title = "<script>&\x01";
  const std::string text = svg(figure);
  EXPECT_TRUE(holds(text, "role=\"img\""));
  EXPECT_TRUE(holds(text, "<title>&lt;script&gt;&amp;"));
  EXPECT_FALSE(holds(text, "<script>"));
  EXPECT_FALSE(holds(text, "\x01"));
}

TEST(Figure, as_gltf_has_as_many_bytes_as_it_says) {
  const std::string bytes = glb(tetrahedron());
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
      value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  EXPECT_EQ(number(4), 2u);
  EXPECT_EQ(number(8), bytes.size());
  EXPECT_EQ(number(12) % 4, 0u);
}

TEST(Figure, files_of_figures_have_different_names) {
  FileRun file;
  FigureRun figure;
  for (const std::string title : {"The Octoid!", "The octoid", "γ", ""}) {
    figure.title = title;
    file.items.emplace_back(figure);
  }
  figure.id = "octoid.fig:5";
  file.items.emplace_back(figure);
  figure.id = "../../etc";
  file.items.emplace_back(figure);
  std::vector<std::string> names;
  for (const NamedFigure& named : figures(file)) names.push_back(named.name);
  EXPECT_EQ(names, (std::vector<std::string>{"the-octoid", "the-octoid-2", "figure", "figure-2",
                                             "octoid.fig=5", "etc"}));
}

TEST(Scale, values_far_beyond_the_others_do_not_stretch_it) {
  std::vector<double> values(1000);
  std::iota(values.begin(), values.end(), 0.0);
  values.push_back(1e9);
  const Scale scale = scale_of(values);
  EXPECT_LT(scale.high, 1200);
  EXPECT_TRUE(scale.above);
  EXPECT_FALSE(scale.below);
  EXPECT_EQ(scale.greatest, 1e9);
  EXPECT_EQ(colour(scale, 1e9), colour(scale, scale.high));
}

TEST(Scale, of_both_signs_has_its_neutral_colour_at_zero) {
  const Scale scale = scale_of({-1, 0.5, 3});
  EXPECT_TRUE(scale.diverging);
  const Colour neutral = colour(scale, 0);
  EXPECT_NEAR(neutral[0], neutral[2], 1e-9);
  EXPECT_FALSE(scale_of({1, 2, 3}).diverging);
}

TEST(Scale, has_a_few_round_ticks) {
  EXPECT_EQ(scale_of({0, 1}).ticks.size(), 6u);
  EXPECT_EQ(scale_of({-3, 7}).ticks, (std::vector<double>{-2, 0, 2, 4, 6}));
  EXPECT_EQ(scale_of({5, 5, 5}).ticks, (std::vector<double>{5}));
  EXPECT_TRUE(scale_of({}).ticks.empty());
}

}  // namespace
}  // namespace seam::report
