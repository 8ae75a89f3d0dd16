// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/read_json.h"

#include <exception>

#include "report/json_reader.h"

// The parser is stopped at a depth that no run has, so that nothing recurs deeply; after it
// each value is looked at before it is taken. Claims and questions come in the order in which
// the items name them.

namespace seam::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr int max_depth = 24;
constexpr std::size_t max_bytes = std::size_t{1} << 30;

Json parsed(std::string_view bytes) {
  if (bytes.size() > max_bytes) throw JsonError{"", "the document is too long", ""};
  try {
    return Json::parse(bytes, [](int depth, Json::parse_event_t, Json&) {
      if (depth > max_depth) throw JsonError{"", "brackets are nested too deeply", ""};
      return true;
    });
  } catch (const Json::parse_error& error) {
    throw JsonError{"byte " + std::to_string(error.byte), "this is not JSON",
                    "the file may have been cut off or changed"};
  } catch (const Json::exception&) {
    throw JsonError{"", "a number is too large", ""};
  }
}

// Files are named by ids.
void read_id(const JsonReader& from, std::string& id) {
  from.read(id);
  if (id.find('/') != std::string::npos || id.find('\0') != std::string::npos)
    from.fail("no id has a slash or a zero byte");
}

void read_outcome(const JsonReader& from, Outcome& outcome) {
  from.at("verdict").read(outcome.verdict);
  outcome.reason = from.text("reason");
  outcome.detail = from.text("detail");
  outcome.witness = from.text("witness");
  outcome.certificate = from.text("certificate");
  from.at("method").read(outcome.method);
  fields(from, outcome);
}

ClaimRun claim(const JsonReader& from) {
  ClaimRun claim;
  read_id(from.at("id"), claim.id);
  from.at("expected").read(claim.expected);
  from.at("using").read(claim.using_claims);
  read_outcome(from, claim.printed);
  from("alarm", claim.printed.alarm);
  fields(from, claim);
  if (from.has("correction")) {
    read_outcome(from.at("correction"), claim.corrected.emplace());
    from("corrected_alarm", claim.corrected->alarm);
  }
  return claim;
}

AskRun ask(const JsonReader& from) {
  AskRun ask;
  read_id(from.at("id"), ask.id);
  ask.decimal = from.text("decimal");
  ask.closed_form = from.text("closed_form");
  ask.detail = from.text("detail");
  fields(from, ask);
  return ask;
}

FigureRun figure(const JsonReader& from) {
  FigureRun figure;
  from.read(figure);
  if (from.has("id")) read_id(from.at("id"), figure.id);
  const std::size_t points = figure.points.size();
  if (!figure.normals.empty() && figure.normals.size() != points)
    from.fail("there are not as many normals as points");
  if (!figure.values.empty() && figure.values.size() != points)
    from.fail("there are not as many values as points");
  for (const auto& triangle : figure.triangles)
    for (const int corner : triangle)
      if (static_cast<std::size_t>(corner) >= points)
        from.fail("a triangle has a corner that is no point");
  return figure;
}

/// What stands in a list of its own, taken in its order.
template <typename Entry>
class Waiting {
 public:
  Waiting(std::vector<JsonReader> entries, Entry (*read)(const JsonReader&))
      : entries_(std::move(entries)), read_(read) {}

  Entry next(const JsonReader& name) {
    std::string id;
    name.read(id);
    if (taken_ == entries_.size()) name.fail("'" + id + "' is not in its list");
    Entry entry = read_(entries_[taken_++]);
    if (entry.id != id)
      name.fail("'" + id + "' is not the next in its list",
                "items and their lists have one order");
    return entry;
  }

  void end() const {
    if (taken_ < entries_.size()) entries_[taken_].fail("no item names this");
  }

 private:
  std::vector<JsonReader> entries_;
  Entry (*read_)(const JsonReader&);
  std::size_t taken_ = 0;
};

TableRun table(const JsonReader& from, Waiting<ClaimRun>& claims) {
  TableRun table;
  fields(from, table);
  if (from.has("id")) read_id(from.at("id"), table.id);
  for (const JsonReader& entry : from.list("rows")) {
    TableRun::Row& row = table.rows.emplace_back();
    fields(entry, row);
    for (const JsonReader& cell : entry.list("cells")) row.cells.push_back(claims.next(cell));
    if (!row.printed.empty() && row.printed.size() != row.cells.size())
      entry.fail("there are not as many printed values as cells");
    if (!table.labels.empty() && row.cells.size() > table.labels.size())
      entry.fail("there are more cells than columns");
  }
  return table;
}

FileRun file(const JsonReader& from) {
  FileRun file;
  from.at("file").read(file.file);
  file.sha256 = from.text("sha256");
  file.paper = from.text("paper");
  fields(from, file);
  Waiting<ClaimRun> claims(from.list("claims"), claim);
  Waiting<AskRun> asks(from.list("asks"), ask);
  for (const JsonReader& item : from.list("items")) {
    if (item.has("claim")) {
      file.items.emplace_back(claims.next(item.at("claim")));
    } else if (item.has("ask")) {
      file.items.emplace_back(asks.next(item.at("ask")));
    } else if (item.has("table")) {
      file.items.emplace_back(table(item.at("table"), claims));
    } else if (item.has("figure")) {
      file.items.emplace_back(figure(item.at("figure")));
    } else if (item.has("section")) {
      SectionRun section;
      item.at("section").read(section);
      file.items.emplace_back(std::move(section));
    } else if (item.has("definition")) {
      DefinitionRun definition;
      item.at("definition").read(definition);
      file.items.emplace_back(std::move(definition));
    } else {
      item.fail("this item is not known", "claim, ask, table, figure, section or definition");
    }
  }
  claims.end();
  asks.end();
  return file;
}

Run run(const JsonReader& from) {
  int version = 0;
  from.at("schema_version").read(version);
  if (version != 1)
    from.at("schema_version")
        .fail("version " + std::to_string(version) + " is not known",
              "this program reads version 1");
  Run run;
  from.at("tool").read(run.tool);
  from("libraries", run.libraries);
  for (const JsonReader& entry : from.list("files")) run.files.push_back(file(entry));
  return run;
}

}  // namespace

std::variant<Run, JsonError> read_json(std::string_view bytes) {
  try {
    const Json document = parsed(bytes);
    return run(JsonReader(document, ""));
  } catch (const JsonError& error) {
    return error;
  } catch (const std::exception& error) {
    return JsonError{"", error.what(), ""};
  }
}

}  // namespace seam::report
