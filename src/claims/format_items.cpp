// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/printer.h"

// The canonical layout of a file: every item as its kind is written, comments above it, and a
// blank line between items, save between definitions of one line each.

namespace seam::claims {
namespace {

using Strings = std::vector<std::string>;

constexpr std::size_t indent = 4;
const std::string margin(indent, ' ');

std::string enclosed(char open, const std::string& text, char close) {
  return open + text + close;
}

std::string quoted(const std::string& text) {
  return enclosed('"', text, '"');
}

std::string joined(const Strings& words) {
  std::string out;
  for (const std::string& word : words) out.append(out.empty() ? "" : ", ").append(word);
  return out;
}

/// The text so far, and an expression where it ends, its further lines one step deeper.
std::string with(const std::string& text, const Expression& e, Level wanted) {
  const std::size_t newline = text.rfind('\n');
  const std::string line = newline == std::string::npos ? text : text.substr(newline + 1);
  const std::size_t deeper = (line.starts_with(margin) ? 2 : 1) * indent;
  return text + lay_out(pieces(e, wanted), width(line), deeper);
}

std::string parameters(const Item& item) {
  return item.parameters.empty() ? "" : enclosed('(', joined(item.parameters), ')');
}

std::string clause(const std::string& word, const std::string& text) {
  return text.empty() ? "" : " " + word + " " + quoted(text);
}

std::string paper(const Item& item) {
  return "paper " + quoted(item.name) + clause("by", item.by) + clause("source", item.source) +
         (item.year.empty() ? "" : " year " + item.year);
}

std::string param(const Item& item) {
  if (item.type == "vector 3 function" && item.expressions.empty() && !item.where)
    return "curve " + joined(item.names) + " generic";
  std::string text =
      "param " + joined(item.names) + (item.type.empty() ? "" : " : " + item.type);
  if (!item.expressions.empty()) text = with(text + " in ", item.expressions[0], Level::range);
  return item.where ? with(text + " where ", *item.where, Level::statement) : text;
}

std::string sequence(const Item& item) {
  const std::string text = with("sequence " + item.name + parameters(item) + " = ",
                                item.expressions[0], Level::range);
  return with(text + " then ", item.expressions[1], Level::range);
}

std::string root(const Item& item) {
  const std::string text =
      with("root " + item.name + " of ", item.expressions[0], Level::range);
  return with(text + " in ", item.expressions[1], Level::range);
}

// On the line of its header if it fits there.
std::string define(const Item& item) {
  const std::string header = "define " + item.name + parameters(item) + ":";
  std::string text = with(header + " ", item.expressions[0], Level::statement);
  if (text.find('\n') == std::string::npos) return text;
  return with(header + "\n" + margin, item.expressions[0], Level::statement);
}

std::string id_title_at(const Item& item) {
  const std::string& title = item.claim.title;
  const std::string named = title.empty() ? item.name : item.name + ' ' + quoted(title);
  return named + clause("at", item.claim.at);
}

std::string hint(const Expression& e) {
  const bool apart = e.kind == Expression::Kind::call && e.children.size() == 2 &&
                     (e.children[1].kind == Expression::Kind::number ||
                      e.children[1].kind == Expression::Kind::name);
  return apart ? e.children[0].text + " " + e.children[1].text : format(e);
}

std::string claim(const Item& item) {
  const Claim& c = item.claim;
  const std::string line = "\n" + margin;
  std::string text =
      with("claim " + id_title_at(item) + ":" + line, c.statement, Level::statement);
  if (c.corrected) text = with(text + line + "corrected: ", *c.corrected, Level::statement);
  if (!c.expect.empty()) text += line + "expect " + c.expect;
  if (!c.using_claims.empty()) text += line + "using " + joined(c.using_claims);
  Strings hints;
  for (const Expression& h : c.hints) hints.push_back(hint(h));
  return hints.empty() ? text : text + line + "by " + joined(hints);
}

// The values and the printed numbers of the rows stand in columns.
std::string table(const Item& item) {
  std::string text = "table " + id_title_at(item);
  for (const Expression& binding : item.columns)
    text = with(text.append(" for "), binding, Level::statement);
  Strings labels;
  for (const std::string& label : item.labels) labels.push_back(quoted(label));
  text += (labels.empty() ? "" : " labelled " + joined(labels)) + ":";

  std::size_t label_width = 0, value_width = 0;
  for (const Item::Row& row : item.rows) {
    label_width = std::max(label_width, width(row.label));
    value_width = std::max(value_width, std::min<std::size_t>(width(format(row.value)), 40));
  }
  for (const Item::Row& row : item.rows) {
    const std::string blanks(label_width - width(row.label) + 1, ' ');
    text.append("\n").append(margin).append(quoted(row.label)).append(blanks);
    text = with(text, row.value, Level::range);
    const std::size_t written = width(format(row.value));
    text += std::string(value_width > written ? value_width - written : 0, ' ') + " ~ ";
    for (std::size_t k = 0; k < row.printed.size(); ++k) {
      text = with(k > 0 ? text.append(", ") : text, row.printed[k], Level::range);
      if (const auto right = row.corrected.find(k); right != row.corrected.end())
        text = with(text + " corrected ", right->second, Level::range);
    }
    if (row.truncated) text += " truncated";
  }
  return text;
}

std::string figure(const Item& item) {
  std::string text = "figure " + (item.name.empty() ? "" : item.name + " ") +
                     quoted(item.claim.title) + clause("at", item.claim.at) + ":";
  text = with(text + " ", item.expressions[0], Level::range);
  if (item.expressions.size() > 1)
    text = with(text + " coloured by ", item.expressions[1], Level::range);
  return item.names.empty() ? text : text + " with " + joined(item.names);
}

std::string body(const Item& item) {
  switch (item.kind) {
    case Item::Kind::paper:
      return paper(item);
    case Item::Kind::section:
      return "section " + quoted(item.name);
    case Item::Kind::let:
      return with("let " + item.name + parameters(item) + " = ", item.expressions[0],
                  Level::range);
    case Item::Kind::sequence:
      return sequence(item);
    case Item::Kind::param:
      return param(item);
    case Item::Kind::root:
      return root(item);
    case Item::Kind::include:
      return "include " + quoted(item.name);
    case Item::Kind::define:
      return define(item);
    case Item::Kind::claim:
      return claim(item);
    case Item::Kind::table:
      return table(item);
    case Item::Kind::figure:
      return figure(item);
    case Item::Kind::ask:
      return with("ask " + item.name + ": ", item.expressions[0], Level::equivalence) +
             (item.option.empty() ? "" : " digits " + item.option);
  }
  return {};
}

std::string comments(const Strings& lines) {
  std::string text;
  for (const std::string& line : lines) text += (line.empty() ? "#" : "# " + line) + "\n";
  return text;
}

bool definition(const Item& item) {
  return item.kind == Item::Kind::let || item.kind == Item::Kind::sequence ||
         item.kind == Item::Kind::param || item.kind == Item::Kind::root ||
         item.kind == Item::Kind::include;
}

}  // namespace

std::string format(const File& file) {
  std::string out;
  bool after_line = false;  // a definition of one line came before
  for (const Item& item : file.items) {
    const std::string text = body(item);
    const bool line = definition(item) && text.find('\n') == std::string::npos;
    const bool together = line && after_line && item.comments.empty();
    if (!out.empty() && !together) out += "\n";
    out += comments(item.comments) + text + "\n";
    after_line = line;
  }
  if (!out.empty() && !file.closing_comments.empty()) out += "\n";
  return out + comments(file.closing_comments);
}

}  // namespace seam::claims
