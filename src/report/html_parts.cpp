// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_parts.h"

#include "report/html_escape.h"
#include "report/mathematics.h"
#include "report/mathml.h"
#include "report/terminal.h"

namespace seam::report {

std::string html_inline(const std::string& latex) {
  if (is_plain_mathematics(latex))
    if (const auto typeset = mathml(latex)) return *typeset;
  return html_element("code", html_escape(latex));
}

std::string html_formula(const std::string& latex) {
  return latex.empty() ? "" : html_element("div class=\"formula\"", html_inline(latex)) + "\n";
}

std::string html_verdict(Verdict verdict) {
  return html_element(
      std::string("span class=\"verdict ") + word(verdict) + "\"",
      html_element("span aria-hidden=\"true\"", shape(verdict)) + " " + word(verdict));
}

std::string html_note(const std::vector<std::string>& comments) {
  std::string note;
  for (const std::string& comment : comments) note += (note.empty() ? "" : " ") + comment;
  return note.empty() ? "" : html_element("p class=\"note\"", html_escape(note)) + "\n";
}

std::string html_anchor(const std::string& id) {
  return "claim:" + html_escape(id);
}

std::string html_link(const std::string& id) {
  return html_element("a href=\"#" + html_anchor(id) + "\"",
                      html_element("code", html_escape(id)));
}

std::string html_terms(const std::vector<Term>& terms) {
  std::string rows;
  for (const Term& term : terms)
    if (!term.content.empty())
      rows += html_element(
          "div", html_element("dt", html_escape(term.name)) + html_element("dd", term.content));
  return rows.empty() ? "" : html_element("dl class=\"terms\"", rows) + "\n";
}

}  // namespace seam::report
