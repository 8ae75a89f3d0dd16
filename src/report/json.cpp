// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json.h"

#include "certificate/layout.h"
#include "report/json_writer.h"

// The keys of the contract, and after them all that the other formats are made of.

namespace seam::report {
namespace {

Json or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : json_text(text);
}

void add(Json& to, Json more) {
  for (auto& [key, value] : more.items()) to[key] = std::move(value);
}

void add_outcome(Json& to, const Outcome& outcome) {
  to["reason"] = or_null(outcome.reason);
  to["detail"] = or_null(outcome.detail);
  to["witness"] = or_null(outcome.witness);
  to["method"] = JsonWriter::value(outcome.method);
  to["obligations"] = outcome.obligations.size();
  to["certificate"] = or_null(outcome.certificate);
}

Json correction(const Outcome& outcome) {
  Json result;
  result["verdict"] = word(outcome.verdict);
  add_outcome(result, outcome);
  add(result, JsonWriter::value(outcome));
  return result;
}

Json json_of(const ClaimRun& claim) {
  const Outcome& printed = claim.printed;
  Json result;
  result["id"] = json_text(claim.id);
  result["verdict"] = word(printed.verdict);
  result["expected"] = word(claim.expected);
  result["as_expected"] = as_expected(claim);
  result["corrected"] = claim.corrected ? Json(word(claim.corrected->verdict)) : Json(nullptr);
  add_outcome(result, printed);
  if (claim.corrected) result["corrected_certificate"] = or_null(claim.corrected->certificate);
  result["using"] = JsonWriter::value(claim.using_claims);
  if (!printed.alarm.empty()) result["alarm"] = json_text(printed.alarm);
  if (claim.corrected && !claim.corrected->alarm.empty())
    result["corrected_alarm"] = json_text(claim.corrected->alarm);
  add(result, JsonWriter::value(claim));
  add(result, JsonWriter::value(printed));
  if (claim.corrected) result["correction"] = correction(*claim.corrected);
  return result;
}

Json json_of(const AskRun& ask) {
  Json result;
  result["id"] = json_text(ask.id);
  result["decimal"] = or_null(ask.decimal);
  result["closed_form"] = or_null(ask.closed_form);
  result["detail"] = or_null(ask.detail);
  add(result, JsonWriter::value(ask));
  return result;
}

// Claims and questions stand in lists of their own; an item names them.
struct Item {
  Json operator()(const SectionRun& section) const {
    return {{"section", JsonWriter::value(section)}};
  }
  Json operator()(const DefinitionRun& definition) const {
    return {{"definition", JsonWriter::value(definition)}};
  }
  Json operator()(const ClaimRun& claim) const { return {{"claim", json_text(claim.id)}}; }
  Json operator()(const AskRun& ask) const { return {{"ask", json_text(ask.id)}}; }
  Json operator()(const FigureRun& figure) const {
    return {{"figure", JsonWriter::value(figure)}};
  }
  Json operator()(const TableRun& table) const {
    Json result = JsonWriter::value(table);
    result["rows"] = Json::array();
    for (const TableRun::Row& row : table.rows) {
      Json entry = JsonWriter::value(row);
      entry["cells"] = Json::array();
      for (const ClaimRun& cell : row.cells) entry["cells"].push_back(json_text(cell.id));
      result["rows"].push_back(std::move(entry));
    }
    return {{"table", std::move(result)}};
  }
};

Json json_of(const FileRun& file) {
  Json result;
  result["file"] = json_text(file.file);
  result["sha256"] = or_null(file.sha256);
  result["paper"] = or_null(file.paper);
  add(result, JsonWriter::value(file));
  result["claims"] = Json::array();
  for (const ClaimRun* claim : claims(file)) result["claims"].push_back(json_of(*claim));
  result["asks"] = Json::array();
  for (const ItemRun& item : file.items)
    if (const auto* ask = std::get_if<AskRun>(&item)) result["asks"].push_back(json_of(*ask));
  result["items"] = Json::array();
  for (const ItemRun& item : file.items) result["items"].push_back(std::visit(Item{}, item));
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
  result["tool"] = json_text(run.tool);
  result["libraries"] = JsonWriter::value(run.libraries);
  result["files"] = Json::array();
  for (const FileRun& file : run.files) result["files"].push_back(json_of(file));
  result["summary"] = json_of(summarize(run));
  return certificate::laid_out(result);
}

}  // namespace seam::report
