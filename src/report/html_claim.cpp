// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_claim.h"

#include "report/html_escape.h"
#include "report/html_parts.h"
#include "report/obligation_groups.h"

namespace seam::report {
namespace {

constexpr std::size_t longest_obligation = 300;  // bytes; beyond, it is folded away
constexpr std::size_t most_evidence = 3;         // different lines of evidence of a group

std::string evidence_of(const ObligationGroup& group) {
  std::vector<std::string> shown;
  for (const std::string& line : group.evidence)
    if (shown.size() < most_evidence && !line.empty()) shown.push_back(html_escape(line));
  if (group.evidence.size() > most_evidence) shown.emplace_back("…");
  const std::string all = html_list(shown);
  return all.empty() ? "" : " " + html_element("span class=\"quiet\"", "[" + all + "]");
}

std::string html_group(const ObligationGroup& group) {
  const ObligationRun& first = *group.first;
  std::string words = html_element(std::string("strong class=\"") + name(first.status) + "\"",
                                   name(first.status)) +
                      " " + html_escape(about(first));
  if (first.guard)
    words +=
        " " + html_element("span class=\"quiet\"", "(so that the formulas mean something)");
  words += evidence_of(group);
  if (!first.slack.empty() && group.count == 1)
    words += " " + html_element("span class=\"quiet\"",
                                "slack " + html_escape(in_words(first.slack)));
  if (group.count > 1)
    words += " " + html_element("span class=\"quiet\"", "— " + std::to_string(group.count) +
                                                            " of this kind, the first:");
  const std::string& shown = first.latex.empty() ? first.text : first.latex;
  if (shown.size() > longest_obligation)
    words += html_element("details", html_element("summary", "its formula, which is long") +
                                         html_element("pre", html_escape(shown)));
  else if (!first.latex.empty())
    words += html_formula(first.latex);
  else if (!first.text.empty())
    words += html_element("pre", html_escape(first.text));
  return html_element("li", words) + "\n";
}

std::string headline(const Outcome& outcome) {
  const std::size_t count = outcome.obligations.size();
  std::string text = std::to_string(count) + (count == 1 ? " obligation" : " obligations");
  std::vector<std::string> methods;
  for (const std::string& method : outcome.method) methods.push_back(html_escape(method));
  return methods.empty() ? text : text + ": " + html_list(methods);
}

// What a statement was turned into, how it was decided, and where that is written down.
std::string folded(const Outcome& outcome, const std::vector<std::string>& definitions) {
  if (outcome.obligations.empty()) return "";
  std::string list;
  for (const ObligationGroup& group : grouped(outcome.obligations)) list += html_group(group);
  std::vector<std::string> names;
  for (const std::string& definition : definitions) names.push_back(html_code(definition));
  const std::string certificate =
      outcome.certificate.empty()
          ? ""
          : html_element("a href=\"" + html_escape(outcome.certificate) + "\"",
                         html_code(outcome.certificate));
  return html_element("details", html_element("summary", headline(outcome)) +
                                     html_element("ol", list) +
                                     html_terms({{"certificate", certificate},
                                                 {"digest", html_code(outcome.digest)},
                                                 {"speaks of", html_list(names)}})) +
         "\n";
}

std::string reason(const Outcome& outcome) {
  std::string text = outcome.reason;
  if (!outcome.detail.empty()) text += (text.empty() ? "" : ": ") + outcome.detail;
  return html_escape(text);
}

std::string slack(const Outcome& outcome) {
  const ObligationRun* closest = closest_to_failing(outcome);
  return closest ? html_escape(in_words(closest->slack)) : "";
}

std::string html_outcome(const Outcome& outcome, const std::vector<std::string>& definitions) {
  const std::string alarm =
      outcome.alarm.empty()
          ? ""
          : html_element("strong class=\"fails\"",
                         "Soundness alarm. The checker objects: " + html_escape(outcome.alarm));
  return html_formula(outcome.latex) +
         html_terms({{"alarm", alarm},
                     {"witness", html_witness(outcome.witness)},
                     {"reason", reason(outcome)},
                     {"slack", slack(outcome)}}) +
         folded(outcome, definitions);
}

std::string links(const std::vector<std::string>& ids) {
  std::vector<std::string> all;
  for (const std::string& id : ids) all.push_back(html_link(id));
  return html_list(all);
}

std::string heading(const std::string& id, const std::string& title, const std::string& at,
                    const std::string& mark) {
  std::string words = mark + " " + html_link(id);
  if (!title.empty()) words += " " + html_element("span class=\"title\"", html_escape(title));
  if (!at.empty()) words += " " + html_element("span class=\"quiet\"", html_escape(at));
  return html_element("h3", words) + "\n";
}

}  // namespace

std::string html_claim(const ClaimRun& claim) {
  const Outcome& printed = claim.printed;
  std::string body =
      heading(claim.id, claim.title, claim.at, html_verdict(printed.verdict)) +
      html_note(claim.comments) + html_outcome(printed, claim.definitions) +
      html_terms(
          {{"expected", printed.verdict == claim.expected ? "" : html_verdict(claim.expected)},
           {"true digits", html_code(claim.true_digits)},
           {"rests on", links(claim.using_claims)}});
  if (claim.corrected)
    body += html_element("p", "corrected: " + html_verdict(claim.corrected->verdict)) +
            html_outcome(*claim.corrected, {});
  const std::string search = claim.id + " " + claim.title + " " + claim.at + " " + printed.text;
  return html_element("article class=\"claim " + std::string(word(printed.verdict)) +
                          "\" id=\"" + html_anchor(claim.id) + "\" data-verdict=\"" +
                          word(printed.verdict) + "\" data-text=\"" + html_escape(search) +
                          "\" tabindex=\"-1\"",
                      "\n" + body) +
         "\n";
}

std::string html_table(const TableRun& table) {
  std::string head;
  if (!table.labels.empty()) {
    head = html_element("td", "");
    for (const std::string& label : table.labels)
      head += html_element("th scope=\"col\"", html_escape(label));
    head = html_element("thead", html_element("tr", head));
  }
  std::string rows, cells;
  for (const TableRun::Row& row : table.rows) {
    std::string line = html_element("th scope=\"row\"", html_escape(row.label));
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const ClaimRun& cell = row.cells[i];
      std::string text =
          html_element("a href=\"#" + html_anchor(cell.id) + "\"",
                       (i < row.printed.size() ? html_escape(row.printed[i]) : "") + " " +
                           html_mark(cell.printed.verdict));
      if (!cell.true_digits.empty())
        text += html_element("span class=\"digits\"", html_escape(cell.true_digits));
      line += html_element("td", text);
      cells += html_claim(cell);
    }
    rows += html_element("tr", line) + "\n";
  }
  const std::string caption = html_element(
      "caption", html_element("code", html_escape(table.id)) + " " + html_escape(table.title) +
                     " " + html_element("span class=\"quiet\"", html_escape(table.at)));
  return html_note(table.comments) +
         html_element("div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"table " +
                          html_escape(table.id) + "\"",
                      html_element("table", caption + head + html_element("tbody", rows))) +
         "\n" +
         html_element("details class=\"cells\"",
                      html_element("summary", "the claims of the cells") + "\n" + cells) +
         "\n";
}

std::string html_ask(const AskRun& ask) {
  return html_element(
             "article class=\"ask\" id=\"" + html_anchor(ask.id) + "\"",
             heading(ask.id, "", "", html_element("span class=\"verdict\"", "= value")) +
                 html_formula(ask.latex) +
                 html_terms({{"certified decimal", html_code(ask.decimal)},
                             {"closed form", html_code(ask.closed_form)},
                             {"reason", html_escape(ask.detail)}})) +
         "\n";
}

}  // namespace seam::report
