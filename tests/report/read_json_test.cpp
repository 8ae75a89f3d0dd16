// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/read_json.h"

#include <gtest/gtest.h>

#include <random>

#include "report/html.h"
#include "report/json.h"
#include "report/latex.h"
#include "sample.h"

namespace seam::report {
namespace {

Run read(const std::string& bytes) {
  auto result = read_json(bytes);
  if (const auto* error = std::get_if<JsonError>(&result)) {
    ADD_FAILURE() << error->where << ": " << error->message;
    return {};
  }
  return std::get<Run>(std::move(result));
}

JsonError error(const std::string& bytes) {
  auto result = read_json(bytes);
  return std::holds_alternative<report::Run>(result) ? JsonError{}
                                                     : std::get<JsonError>(result);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(ReadJson, what_is_read_is_written_again_with_the_same_bytes) {
  const std::string written = json(sample());
  EXPECT_EQ(json(read(written)), written);
}

TEST(ReadJson, nothing_that_a_report_says_is_lost) {
  const report::Run run = read(json(sample()));
  EXPECT_EQ(run.files.front().items.size(), sample().files.front().items.size());
  const report::Run again = read(json(run));
  EXPECT_EQ(latex(again), latex(run));
  EXPECT_EQ(html(again), html(run));
  // Of the sample two things change: numbers of figures are rounded, stray bytes replaced.
  report::Run exact = sample();
  std::erase_if(exact.files.front().items,
                [](const ItemRun& item) { return std::holds_alternative<FigureRun>(item); });
  for (ItemRun& item : exact.files.front().items)
    if (auto* claim = std::get_if<ClaimRun>(&item)) std::erase(claim->title, '\xFF');
  EXPECT_EQ(latex(read(json(exact))), latex(exact));
}

TEST(ReadJson, every_field_of_a_claim_comes_back) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.alarm = "objection";
  claim.printed.digest = "00";
  claim.corrected = Outcome{};
  claim.corrected->alarm = "another";
  claim.corrected->text = "1 = 1";
  claim.true_digits = "1.25";
  claim.definitions = {"f"};
  claim.line = 3;
  claim.column = 7;
  claim.included = "parts/a.seam";
  const report::Run run =
      read(json({"tool", {{"a.seam", "", "", "", "", "", {claim}}}, {"Lib 1"}}));
  const auto& back = std::get<ClaimRun>(run.files.at(0).items.at(0));
  EXPECT_EQ(back.printed.alarm, "objection");
  EXPECT_EQ(back.printed.digest, "00");
  EXPECT_EQ(back.corrected.value().alarm, "another");
  EXPECT_EQ(back.corrected.value().text, "1 = 1");
  EXPECT_EQ(back.true_digits, "1.25");
  EXPECT_EQ(back.definitions, claim.definitions);
  EXPECT_EQ(back.line, 3);
  EXPECT_EQ(back.column, 7);
  EXPECT_EQ(back.included, "parts/a.seam");
  EXPECT_EQ(run.libraries, std::vector<std::string>{"Lib 1"});
}

TEST(ReadJson, an_error_says_where_it_is_and_what_would_help) {
  const std::string written = json(sample());
  const JsonError wrong_word = error(replaced(written, "\"proven\"", "\"surely\""));
  EXPECT_EQ(wrong_word.where, "files[0].claims[0].verdict");
  EXPECT_EQ(wrong_word.hint, "one of proven refuted conditional undecided");
  EXPECT_EQ(error("{}").message, "'schema_version' is missing");
  EXPECT_EQ(error("{\"schema_version\": 2}").where, "schema_version");
  EXPECT_EQ(error("{\"schema_version\": 1, \"tool\": 3}").message, "expected a text");
  EXPECT_EQ(error("{\"a\": ").message, "this is not JSON");
  EXPECT_EQ(
      error(replaced(written, "\"id\": \"icosahedral.smooth\"", "\"id\": \"../x\"")).message,
      "no id has a slash or a zero byte");
}

TEST(ReadJson, indices_and_lengths_of_a_figure_fit) {
  FigureRun figure;
  figure.points = {{0, 0, 0}};
  figure.triangles = {{0, 0, 1}};
  EXPECT_NE(error(json({"", {{"a", "", "", "", "", "", {figure}}}})).message, "");
  figure.triangles.clear();
  figure.values = {1, 2};
  EXPECT_NE(error(json({"", {{"a", "", "", "", "", "", {figure}}}})).message, "");
}

TEST(ReadJson, any_bytes_end_in_a_run_or_an_error) {
  EXPECT_EQ(error(std::string(1'000'000, '[')).message, "brackets are nested too deeply");
  for (const std::string text : {"", "null", "[]", "1e999", "\xFF\xFE", "\"", "{\"files\":{}}"})
    EXPECT_NE(error(text).message, "") << text;
  report::Run run = sample();
  std::erase_if(run.files.front().items,
                [](const ItemRun& item) { return std::holds_alternative<FigureRun>(item); });
  FigureRun figure;
  figure.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  figure.triangles = {{0, 1, 2}};
  run.files.front().items.emplace_back(figure);
  const std::string written = json(run);
  for (std::size_t end = 0; end + 2 < written.size(); end += 211)
    EXPECT_NE(error(written.substr(0, end)).message, "") << end;
  std::mt19937 random(7);
  const std::string bytes = "{}[],:\"0-9eE.nu\\\xC3\x01";
  for (int i = 0; i < 400; ++i) {
    std::string changed = written;
    for (unsigned j = 0; j <= random() % 3; ++j)
      changed[random() % changed.size()] = bytes[random() % bytes.size()];
    const auto result = read_json(changed);
    if (const auto* accepted = std::get_if<report::Run>(&result)) {
      EXPECT_FALSE(json(*accepted).empty());
    }
  }
}

}  // namespace
}  // namespace seam::report
