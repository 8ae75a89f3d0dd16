// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json.h"

#include <nlohmann/json.hpp>

namespace seam::report {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json json_of(const ClaimRun& claim) {
  const Outcome& printed = claim.printed;
  Json result;
  result["id"] = claim.id;
  result["verdict"] = word(printed.verdict);
  result["expected"] = word(claim.expected);
  result["as_expected"] = as_expected(claim);
  result["corrected"] = claim.corrected ? Json(word(claim.corrected->verdict)) : Json(nullptr);
  result["reason"] = or_null(printed.reason);
  result["detail"] = or_null(printed.detail);
  result["witness"] = or_null(printed.witness);
  result["method"] = printed.method;
  result["obligations"] = printed.obligations.size();
  result["certificate"] = or_null(printed.certificate);
  if (claim.corrected) result["corrected_certificate"] = or_null(claim.corrected->certificate);
  result["using"] = claim.using_claims;
  if (!printed.alarm.empty()) result["alarm"] = printed.alarm;
  if (claim.corrected && !claim.corrected->alarm.empty())
    result["corrected_alarm"] = claim.corrected->alarm;
  return result;
}

Json json_of(const AskRun& ask) {
  Json result;
  result["id"] = ask.id;
  result["decimal"] = or_null(ask.decimal);
  result["closed_form"] = or_null(ask.closed_form);
  result["detail"] = or_null(ask.detail);
  return result;
}

Json json_of(const FileRun& file) {
  Json result;
  result["file"] = file.file;
  result["sha256"] = or_null(file.sha256);
  result["paper"] = or_null(file.paper);
  result["claims"] = Json::array();
  for (const ClaimRun* claim : claims(file)) result["claims"].push_back(json_of(*claim));
  result["asks"] = Json::array();
  for (const ItemRun& item : file.items)
    if (const auto* ask = std::get_if<AskRun>(&item)) result["asks"].push_back(json_of(*ask));
  return result;
}

Json json_of(const Summary& summary) {
  Json result;
  result["claims"] = summary.claims;
  result["proven"] = summary.proven;
  result["refuted"] = summary.refuted;
  result["conditional"] = summary.conditional;
  result["undecided"] = summary.undecided;
  result["as_expected"] = summary.as_expected;
  return result;
}

}  // namespace

std::string json(const Run& run) {
  Json result;
  result["schema_version"] = 1;
  result["tool"] = run.tool;
  result["files"] = Json::array();
  for (const FileRun& file : run.files) result["files"].push_back(json_of(file));
  result["summary"] = json_of(summarize(run));
  // Bytes of a file that are not UTF-8 are replaced, never a reason to fail.
  return result.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace seam::report
