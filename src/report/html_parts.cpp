// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_parts.h"

#include "report/html_escape.h"
#include "report/mathematics.h"
#include "report/mathml.h"
#include "report/terminal.h"
#include "report/witness.h"

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

std::string html_mark(Verdict verdict) {
  return html_element(std::string("span class=\"verdict ") + word(verdict) + "\"",
                      html_element("span aria-hidden=\"true\"", shape(verdict)) +
                          html_element("span class=\"unseen\"", word(verdict)));
}

std::string html_code(const std::string& text) {
  return text.empty() ? "" : html_element("code", html_escape(text));
}

std::string html_witness(const std::string& witness) {
  return html_code(readable_witness(witness));
}

std::string html_list(const std::vector<std::string>& parts) {
  std::string result;
  for (const std::string& part : parts)
    if (!part.empty()) result += (result.empty() ? "" : ", ") + part;
  return result;
}

std::string html_section(const std::string& anchor, const std::string& title,
                         const std::string& content) {
  if (content.empty()) return "";
  const std::string name = html_escape(anchor) + "-title";
  return html_element(
             "section id=\"" + html_escape(anchor) + "\" aria-labelledby=\"" + name + "\"",
             "\n" + html_element("h2 id=\"" + name + "\"", html_escape(title)) + "\n" +
                 content) +
         "\n";
}

std::string html_note(const std::vector<std::string>& comments) {
  std::string note;
  for (const std::string& comment : comments) note += (note.empty() ? "" : " ") + comment;
  if (note.empty()) return "";
  std::string words;
  for (std::size_t at = 0; at < note.size();) {
    const std::size_t open = note.find('`', at), close = note.find('`', open + 1);
    if (open == note.npos || close == note.npos) {
      words += html_escape(note.substr(at));
      break;
    }
    words += html_escape(note.substr(at, open - at)) +
             html_code(note.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return html_element("p class=\"note\"", words) + "\n";
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
