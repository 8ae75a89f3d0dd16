// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_front.h"

#include "report/glossary.h"
#include "report/html_escape.h"
#include "report/html_parts.h"
#include "report/tally.h"

namespace seam::report {
namespace {

std::string tally_row(const std::string& title, const Summary& summary) {
  std::string cells = html_element("th scope=\"row\"", title);
  for (const int n : {summary.claims, summary.proven, summary.refuted, summary.conditional,
                      summary.undecided, summary.as_expected})
    cells += html_element("td", n == 0 ? "" : std::to_string(n));
  return html_element("tr", cells) + "\n";
}

// Text with formulas between dollar signs, as the glossary has it.
std::string prose(const std::string& latex) {
  std::string result, part;
  bool is_formula = false;
  for (const char c : latex + "$") {
    if (c != '$') {
      part += c;
      continue;
    }
    result += is_formula ? html_inline(part) : html_escape(part);
    part.clear();
    is_formula = !is_formula;
  }
  return result;
}

}  // namespace

std::string html_section_anchor(int number) {
  return "section-" + std::to_string(number);
}

std::string html_header(const FileRun& file, const Run& run) {
  std::vector<std::string> libraries;
  for (const std::string& library : run.libraries) libraries.push_back(html_escape(library));
  const std::string title = html_escape(file.paper.empty() ? file.file : file.paper);
  const std::string whose =
      html_list({html_escape(file.by), html_escape(file.source), html_escape(file.year)});
  const std::string accepted =
      has_alarm(file)
          ? html_element("strong class=\"fails\"",
                         "Evidence of this run was rejected; see the claims so marked.")
          : "Every <em>proven</em> and every <em>refuted</em> was accepted by the independent "
            "checker from the certificate named with it.";
  return html_element("header",
                      "\n" + html_element("p class=\"kind\"", "Verification report") +
                          html_element("h1", title) +
                          (whose.empty() ? "" : html_element("p", whose)) +
                          html_element("p", sentence(summarize(file)) + " " + accepted) +
                          html_terms({{"claims", html_code(file.file)},
                                      {"SHA-256", html_code(file.sha256)},
                                      {"read by", html_escape(run.tool)},
                                      {"with", html_list(libraries)}})) +
         "\n";
}

std::string html_summary(const FileRun& file) {
  std::string head = html_element("td", "") + html_element("th scope=\"col\"", "claims");
  for (const Verdict verdict :
       {Verdict::proven, Verdict::refuted, Verdict::conditional, Verdict::undecided})
    head += html_element("th scope=\"col\"", html_verdict(verdict));
  head += html_element("th scope=\"col\"", "as expected");
  std::string rows;
  for (const Tally& tally : by_section(file))
    rows +=
        tally_row(tally.section == 0
                      ? html_escape(tally.title)
                      : html_element("a href=\"#" + html_section_anchor(tally.section) + "\"",
                                     html_escape(tally.title)),
                  tally.summary);
  return html_section(
      "summary", "Summary",
      html_element("div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"summary\"",
                   html_element("table class=\"tally\"",
                                html_element("thead", html_element("tr", head)) +
                                    html_element("tbody", rows) +
                                    html_element("tfoot", tally_row("all", summarize(file))))));
}

std::string html_glossary(const FileRun& file) {
  std::string rows;
  const auto add = [&](const std::string& name, const std::string& meaning) {
    rows += html_element("div", html_element("dt", name) + html_element("dd", meaning)) + "\n";
  };
  add(html_verdict(Verdict::proven),
      "There is a certificate that the independent checker accepted.");
  add(html_verdict(Verdict::refuted),
      "There is an exact witness that the independent checker accepted.");
  add(html_verdict(Verdict::conditional), "Proven from a claim that is itself not proven.");
  add(html_verdict(Verdict::undecided), "None of these; the reason is given with the claim.");
  std::vector<std::string> used;
  for (const ClaimRun* claim : claims(file))
    used.insert(used.end(), claim->predicates.begin(), claim->predicates.end());
  for (const GlossaryEntry& entry : glossary(used))
    add(html_code(entry.predicate), prose(entry.latex));
  return html_section(
      "glossary", "Glossary",
      html_element("dl class=\"terms\"", rows) +
          html_element(
              "p",
              "Whether a claim was turned into the right obligations is for a person "
              "to judge; that they hold or fail is what the certificates show. To have "
              "them judged again: <code>seamproof-check</code>, with the folder of this "
              "page."));
}

}  // namespace seam::report
