// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/junit.h"

#include <algorithm>
#include <cstdio>

#include "report/html_escape.h"

namespace seam::report {
namespace {

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + html_escape(value) + "\"";
}

std::string seconds(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3f", value);
  return buffer;
}

struct Counts {
  int tests = 0, failures = 0, errors = 0, skipped = 0;
  double time = 0;
};

std::string attributes(const Counts& counts) {
  return attribute("tests", std::to_string(counts.tests)) +
         attribute("failures", std::to_string(counts.failures)) +
         attribute("errors", std::to_string(counts.errors)) +
         attribute("skipped", std::to_string(counts.skipped)) +
         attribute("time", seconds(counts.time));
}

std::string complaint(const char* element, const char* type, const std::string& message) {
  return std::string("      <") + element + attribute("message", message) +
         attribute("type", type) + "/>\n";
}

std::string complaint(const ClaimRun& claim, bool allow_undecided, Counts& counts) {
  switch (concern(claim)) {
    case Concern::none:
      return "";
    case Concern::undecided:
      if (allow_undecided) {
        ++counts.skipped;
        return "      <skipped" + attribute("message", in_short(claim)) + "/>\n";
      }
      ++counts.failures;
      return complaint("failure", "undecided", in_short(claim));
    case Concern::contradiction:
      ++counts.failures;
      return complaint("failure", "contradiction", in_short(claim));
    case Concern::alarm:
      break;
  }
  ++counts.errors;
  return complaint("error", "alarm", in_short(claim));
}

std::string methods(const Outcome& outcome) {
  std::string text;
  for (const std::string& method : outcome.method) text += (text.empty() ? "" : ", ") + method;
  return text;
}

std::string test_case(const ClaimRun& claim, const std::string& suite, bool allow_undecided,
                      Counts& counts) {
  ++counts.tests;
  counts.time += claim.seconds;
  std::string output = claim.printed.text + "\n" + in_short(claim);
  if (const std::string how = methods(claim.printed); !how.empty()) output += "\n" + how;
  std::string lines;  // line ends stand, where html_escape would make blanks of them
  for (std::size_t begin = 0; begin <= output.size();) {
    const std::size_t end = std::min(output.find('\n', begin), output.size());
    lines += html_escape(output.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return "    <testcase" + attribute("name", claim.id) + attribute("classname", suite) +
         attribute("time", seconds(claim.seconds)) + ">\n" +
         complaint(claim, allow_undecided, counts) + "      <system-out>" + lines +
         "</system-out>\n    </testcase>\n";
}

std::string suite(const FileRun& file, bool allow_undecided, Counts& all) {
  const std::string name = path_of(file, "");
  Counts counts;
  std::string cases;
  for (const ErrorRun& error : file.errors) {
    ++counts.tests;
    ++counts.errors;
    const std::string place = std::to_string(error.line) + ":" + std::to_string(error.column);
    cases += "    <testcase" + attribute("name", "reading " + place) +
             attribute("classname", name) + attribute("time", "0.000") + ">\n" +
             complaint("error", "reading",
                       error.message + (error.hint.empty() ? "" : "; " + error.hint)) +
             "    </testcase>\n";
  }
  for (const ClaimRun* claim : claims(file))
    cases += test_case(*claim, name, allow_undecided, counts);
  all.tests += counts.tests;
  all.failures += counts.failures;
  all.errors += counts.errors;
  all.skipped += counts.skipped;
  all.time += counts.time;
  return "  <testsuite" + attribute("name", name) + attributes(counts) + ">\n" + cases +
         "  </testsuite>\n";
}

}  // namespace

std::string junit(const Run& run, bool allow_undecided) {
  Counts counts;
  std::string suites;
  for (const FileRun& file : run.files) suites += suite(file, allow_undecided, counts);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
         attribute("name", run.tool) + attributes(counts) + ">\n" + suites + "</testsuites>\n";
}

}  // namespace seam::report
