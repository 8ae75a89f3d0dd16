// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html.h"

#include <gtest/gtest.h>

#include "report/html_escape.h"
#include "sample.h"
#include "well_formed.h"

namespace seam::report {
namespace {

// The page without its scripts and styles, which XML does not look into.
std::string without_scripts(std::string page) {
  for (const char* tag : {"script", "style"})
    for (;;) {
      const std::size_t begin = page.find("<" + std::string(tag));
      if (begin == page.npos) break;
      const std::string end = "</" + std::string(tag) + ">";
      page.erase(begin, page.find(end, begin) + end.size() - begin);
    }
  return page;
}

// The sample holds hostile text.
TEST(Html, the_sample_is_well_formed_and_the_same_again) {
  const std::string page = html(sample());
  EXPECT_EQ(not_well_formed(without_scripts(page)), "");
  EXPECT_EQ(page, html(sample()));
}

TEST(Html, nothing_outside_the_page_is_named) {
  const std::string page = html(sample());
  for (const char* loading : {" src=", "url(", "@import", "<link", "<iframe", "<img", "fetch("})
    EXPECT_EQ(page.find(loading), std::string::npos) << loading;
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(Html, each_claim_is_there_once_with_its_verdict) {
  const report::Run run = sample();
  const std::string page = html(run);
  for (const FileRun& file : run.files)
    for (const ClaimRun* claim : claims(file)) {
      const std::string start = "id=\"claim:" + html_escape(claim->id) + "\" data-verdict=\"" +
                                word(claim->printed.verdict) + "\"";
      const std::size_t first = page.find(start);
      EXPECT_NE(first, std::string::npos) << claim->id;
      EXPECT_EQ(page.find(start, first + 1), std::string::npos) << claim->id;
    }
}

TEST(Html, text_cannot_become_markup) {
  EXPECT_EQ(html_escape("<script>&\"'"), "&lt;script&gt;&amp;&quot;&#39;");
  EXPECT_EQ(html_escape(std::string("\0\x1b\x7f", 3)), "␀␛␡");
  EXPECT_EQ(html_escape("a\xFF\xC3"), "a\uFFFD\uFFFD");
  EXPECT_EQ(html_escape("\u202E"), "\uFFFD");
  EXPECT_EQ(html_escape("ä√"), "ä√");
}

}  // namespace
}  // namespace seam::report
