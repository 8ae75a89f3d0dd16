// SPDX-License-Identifier: GPL-3.0-or-later
// What escape promises, read back from the PDF: every character as itself, or by its number.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <random>
#include <vector>

#include "report/escape.h"
#include "report/file.h"
#include "report/pdf.h"
#include "report/style.h"

namespace seam::report {
namespace {

namespace fs = std::filesystem;

std::string utf8(char32_t c) {
  const auto byte = [](char32_t b) { return static_cast<char>(b); };
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F))};
  if (c < 0x10000)
    return {byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
  return {byte(0xF0 | c >> 18), byte(0x80 | (c >> 12 & 0x3F)), byte(0x80 | (c >> 6 & 0x3F)),
          byte(0x80 | (c & 0x3F))};
}

// What a page of the PDF has to say of a piece of a text. Some signs are made of two, and
// raised figures are read as figures.
std::string promised(const std::string& piece) {
  static const std::map<std::string, std::string> alike = {
      {" ", ""},  {"\n", ""}, {"\t", ""}, {"\u00A0", ""}, {"…", "..."},
      {"²", "2"}, {"³", "3"}, {"¹", "1"}, {"↦", "↦→"},    {"≠", "\u0338="}};
  const auto found = alike.find(piece);
  if (found != alike.end()) return found->second;
  const std::string latex = escape(piece);
  return latex.starts_with("[") && piece != "[" ? latex : piece;
}

struct Sample {
  std::string text, promise;

  void add(const std::string& piece) {
    // An accent would join the letter before it.
    if ((piece >= "\u0300" && piece <= "\u036F") || piece == "\u20D7") text += " ";
    text += piece;
    promise += promised(piece);
  }
};

// Characters of all kinds: those of TeX, pairs and triples that fonts join, letters, controls,
// anything that Unicode has, bytes that are none.
Sample random_sample(std::mt19937& random) {
  static const std::vector<std::string> traps = {
      "\\", "{", "}", "$", "&", "#", "%", "_", "^", "~", "-", "-", "-", "`", "`",  "'",
      "'",  "?", "!", "<", "<", ">", ">", ",", ",", "f", "f", "i", "l", "|", "\"", "[",
      "]",  "(", ")", "=", "+", "*", "/", "@", ":", ";", ".", ".", ".", "0", "9",  " ",
      "é",  "ß", "Ł", "ą", "Ž", "ł", "ı", "–", "…", "§", "°", "×", "α", "λ", "≤",  "√"};
  const auto below = [&](unsigned n) { return static_cast<char32_t>(random() % n); };
  Sample sample;
  for (int i = 0; i < 60; ++i) {
    switch (below(8)) {
      case 0:
        sample.add(utf8(below(0x80)));
        break;
      case 1:
        sample.add(utf8(0x80 + below(0x500)));
        break;
      case 2: {
        const char32_t c = 0x2000 + below(0xB000);
        sample.add(utf8(c));
        break;
      }
      case 3:
        sample.add(utf8(0xE000 + below(0x10FFFF - 0xE000)));
        break;
      case 4:
        sample.add(std::string(1, static_cast<char>(0xC0 + below(0x40))));
        sample.add(" ");
        break;
      default:
        sample.add(traps[below(static_cast<unsigned>(traps.size()))]);
    }
  }
  return sample;
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; });
  return text;
}

// The pages of a PDF as text.
std::vector<std::string> pages(const fs::path& pdf) {
  FILE* pipe = popen(("pdftotext -raw '" + pdf.string() + "' -").c_str(), "r");
  if (!pipe) return {};
  std::vector<std::string> result(1);
  for (int c = 0; (c = fgetc(pipe)) != EOF;) {
    if (c == '\f')
      result.emplace_back();
    else
      result.back() += static_cast<char>(c);
  }
  pclose(pipe);
  return result;
}

std::vector<std::string> typeset_and_read(const std::vector<Sample>& samples) {
  const fs::path folder = fs::path(testing::TempDir()) /
                          (std::string("seamproof_") +
                           testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::remove_all(folder);
  std::string document = std::string(preamble) + std::string(style) +
                         "\\begin{document}\\pagestyle{empty}\\raggedright"
                         "\\hyphenpenalty=10000\\exhyphenpenalty=10000\n";
  for (const Sample& sample : samples)
    document += "\\leavevmode " + escape(sample.text) + "\\clearpage\n";
  if (write_file(folder / "report.tex", document + "\\end{document}\n")) return {};
  if (const auto error = typeset(folder / "report.tex")) {
    ADD_FAILURE() << error->message;
    return {};
  }
  return pages(folder / "report.pdf");
}

TEST(EscapePdf, random_text_is_read_back_as_it_was_or_by_its_numbers) {
  std::mt19937 random(20240229);
  std::vector<Sample> samples;
  for (int i = 0; i < 150; ++i) samples.push_back(random_sample(random));
  const std::vector<std::string> read = typeset_and_read(samples);
  ASSERT_EQ(read.size(), samples.size() + 1);
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_EQ(without_blanks(read[i]), without_blanks(samples[i].promise)) << samples[i].text;
}

TEST(EscapePdf, every_character_that_has_a_print_is_read_back) {
  std::vector<Sample> samples;
  for (char32_t c = 0x20; c < 0x2300; ++c) {
    Sample sample;
    sample.add(utf8(c));
    if (!sample.promise.empty() && !sample.promise.starts_with("[U+"))
      samples.push_back(sample);
  }
  ASSERT_GT(samples.size(), 250u);
  const std::vector<std::string> read = typeset_and_read(samples);
  ASSERT_EQ(read.size(), samples.size() + 1);
  for (std::size_t i = 0; i < samples.size(); ++i)
    EXPECT_EQ(without_blanks(read[i]), samples[i].promise) << samples[i].text;
}

}  // namespace
}  // namespace seam::report
