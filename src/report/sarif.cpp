// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/sarif.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace seam::report {
namespace {

using Json = nlohmann::ordered_json;

struct Rule {
  const char *id, *name, *text, *level;
};

constexpr std::array rules = {
    Rule{"SEAM1001", "DecidedAgainstExpectation",
         "The claim is decided, and not as its file expects.", "error"},
    Rule{"SEAM1002", "Undecided",
         "The claim is undecided or only conditional, and should be decided.", "warning"},
    Rule{"SEAM1003", "SoundnessAlarm", "The checker did not accept the evidence for the claim.",
         "error"},
    Rule{"SEAM1004", "ErrorInFile", "The file cannot be read or does not make sense.", "error"},
    Rule{"SEAM1005", "Warning", "What may be a slip, though no verdict depends on it.",
         "note"}};

// Of a path as an URI, relative where it is: what is not plain is written as %XX.
std::string uri(const std::string& path) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = path.starts_with('/') ? "file://" : "";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') ||
                          std::string_view("/._-~").find(c) != std::string_view::npos;
    if (is_plain)
      text += c;
    else
      text += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return text;
}

// In a message `[text](target)` is a link, which no text of a file shall make.
std::string without_links(std::string text) {
  for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 2))
    text.insert(at, "\\");
  return text;
}

Json location(const std::string& path, int line, int column) {
  Json result;
  result["physicalLocation"]["artifactLocation"]["uri"] = uri(path);
  if (line > 0)
    result["physicalLocation"]["region"] = {{"startLine", line},
                                            {"startColumn", std::max(1, column)}};
  return result;
}

Json result_of(std::size_t rule, const std::string& message, Json where) {
  Json result;
  result["ruleId"] = rules[rule].id;
  result["ruleIndex"] = rule;
  result["kind"] = "fail";
  result["level"] = rules[rule].level;
  result["message"]["text"] = without_links(message);
  result["locations"] = Json::array({std::move(where)});
  return result;
}

Json result_of(const FileRun& file, const ClaimRun& claim, bool allow_undecided) {
  const Concern what = concern(claim);
  const std::size_t rule = what == Concern::contradiction ? 0
                           : what == Concern::undecided   ? 1
                                                          : 2;
  Json where = location(path_of(file, claim.included), claim.line, claim.column);
  where["logicalLocations"] =
      Json::array({{{"name", claim.id}, {"fullyQualifiedName", claim.id}, {"kind", "member"}}});
  const std::string title = claim.title.empty() ? "" : " (" + claim.title + ")";
  Json result = result_of(rule, "Claim " + claim.id + title + ": " + in_short(claim) + ".",
                          std::move(where));
  if (what == Concern::undecided && allow_undecided) {
    result["kind"] = "open";
    result["level"] = "none";
  }
  result["partialFingerprints"]["claim/v1"] = file.file + "/" + claim.id;
  return result;
}

Json driver(const std::string& tool) {
  const std::size_t blank = tool.find(' ');
  Json result;
  result["name"] = tool.substr(0, blank);
  if (blank != std::string::npos) result["version"] = tool.substr(blank + 1);
  result["rules"] = Json::array();
  for (const Rule& rule : rules) {
    Json entry;
    entry["id"] = rule.id;
    entry["name"] = rule.name;
    entry["shortDescription"]["text"] = rule.text;
    entry["fullDescription"]["text"] = rule.text;
    entry["help"]["text"] = "See the description of exit statuses in docs/command-line.md.";
    entry["defaultConfiguration"]["level"] = rule.level;
    result["rules"].push_back(std::move(entry));
  }
  return result;
}

}  // namespace

std::string sarif(const Run& run, bool allow_undecided) {
  Json results = Json::array();
  for (const FileRun& file : run.files) {
    for (const ErrorRun& error : file.errors) {
      const std::string message =
          "Error: " + error.message + (error.hint.empty() ? "." : "; " + error.hint + ".");
      results.push_back(result_of(
          3, message, location(path_of(file, error.included), error.line, error.column)));
    }
    for (const WarningRun& warning : file.warnings) {
      const std::string message =
          warning.message + (warning.hint.empty() ? "." : "; " + warning.hint + ".");
      results.push_back(result_of(
          4, message, location(path_of(file, warning.included), warning.line, warning.column)));
    }
    for (const ClaimRun* claim : claims(file))
      if (concern(*claim) != Concern::none)
        results.push_back(result_of(file, *claim, allow_undecided));
  }
  Json document;
  document["$schema"] = "https://json.schemastore.org/sarif-2.1.0.json";
  document["version"] = "2.1.0";
  Json log;
  log["tool"]["driver"] = driver(run.tool);
  log["columnKind"] = "unicodeCodePoints";
  log["results"] = std::move(results);
  document["runs"] = Json::array({std::move(log)});
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace seam::report
