// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html.h"

#include "embedded/page_css.h"
#include "embedded/page_js.h"
#include "embedded/view_js.h"
#include "report/assumptions.h"
#include "report/errata.h"
#include "report/html_assumptions.h"
#include "report/html_claim.h"
#include "report/html_errata.h"
#include "report/html_escape.h"
#include "report/html_figure.h"
#include "report/html_front.h"
#include "report/html_parts.h"
#include "report/html_warnings.h"

namespace seam::report {
namespace {

// No source of anything is allowed but what stands in the page itself.
constexpr const char* policy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; "
    "base-uri 'none'; form-action 'none'";

std::string html_item(const DefinitionRun& definition) {
  return html_element("div class=\"definition\"",
                      html_note(definition.comments) + html_formula(definition.latex)) +
         "\n";
}
std::string html_item(const ClaimRun& claim) {
  return html_claim(claim);
}
std::string html_item(const TableRun& table) {
  return html_table(table);
}
std::string html_item(const FigureRun& figure) {
  return html_figure(figure);
}
std::string html_item(const AskRun& ask) {
  return html_ask(ask);
}

// The items of the file, each section of the paper a section of the page.
std::string items(const FileRun& file) {
  std::string all, part;
  int number = 0;
  std::string title = "Claims";
  const auto finish = [&] {
    if (!part.empty())
      all += html_element("section class=\"part\" aria-labelledby=\"" +
                              html_section_anchor(number) + "\"",
                          "\n" +
                              html_element("h2 id=\"" + html_section_anchor(number) + "\"",
                                           html_escape(title)) +
                              "\n" + part) +
             "\n";
    part.clear();
  };
  for (const ItemRun& item : file.items) {
    if (const auto* section = std::get_if<SectionRun>(&item)) {
      finish();
      title = section->title;
      ++number;
      continue;
    }
    part += std::visit(
        [](const auto& it) {
          if constexpr (std::is_same_v<std::decay_t<decltype(it)>, SectionRun>)
            return std::string();
          else
            return html_item(it);
        },
        item);
  }
  finish();
  return all;
}

// Shown by the script, without which they would do nothing.
std::string controls() {
  std::string buttons;
  for (const Verdict verdict :
       {Verdict::proven, Verdict::refuted, Verdict::conditional, Verdict::undecided})
    buttons += html_element(std::string("button type=\"button\" aria-pressed=\"true\" "
                                        "data-verdict=\"") +
                                word(verdict) + "\"",
                            html_verdict(verdict)) +
               "\n";
  return html_element(
             "form role=\"search\" id=\"controls\" hidden=\"hidden\"",
             "\n" + html_element("label for=\"query\"", "Search the claims") +
                 "<input id=\"query\" type=\"search\" autocomplete=\"off\" "
                 "placeholder=\"id, title or formula\"/>\n" +
                 html_element("div role=\"group\" aria-label=\"verdicts shown\"", buttons) +
                 html_element("button type=\"button\" id=\"unfold\"", "Unfold all") +
                 html_element("p id=\"count\" role=\"status\" aria-live=\"polite\"", "")) +
         "\n" +
         html_element(
             "p id=\"keys\" class=\"quiet\" hidden=\"hidden\"",
             "Keys: <kbd>/</kbd> search, <kbd>Esc</kbd> out of it, <kbd>j</kbd> "
             "<kbd>k</kbd> next and previous claim, <kbd>Enter</kbd> fold and unfold") +
         "\n";
}

std::string contents(const FileRun& file) {
  std::string links;
  const auto add = [&](const std::string& anchor, const std::string& title) {
    links += html_element("li", html_element("a href=\"#" + anchor + "\"", title));
  };
  add("summary", "Summary");
  const Errata wrong = errata(file);
  if (!wrong.known.empty()) add("errata", errata_known_title);
  if (!wrong.others.empty()) add("refuted", errata_others_title);
  if (!file.warnings.empty()) add("warnings", warnings_title);
  int number = 0;
  for (const ItemRun& item : file.items)
    if (const auto* section = std::get_if<SectionRun>(&item))
      add(html_section_anchor(++number), html_escape(section->title));
  if (!assumptions(file).empty()) add("assumptions", assumptions_title);
  add("glossary", "Glossary");
  return html_element("nav aria-label=\"contents\"", html_element("ul", links)) + "\n";
}

// A script as XHTML may hold it: nothing in it is read as markup.
std::string script(std::string_view text) {
  return "<script>//<![CDATA[\n" + std::string(text) + "//]]></script>\n";
}

std::string body(const FileRun& file, const Run& run) {
  return html_element("a class=\"skip\" href=\"#claims\"", "Skip to the claims") + "\n" +
         html_header(file, run) + contents(file) +
         html_element("main",
                      "\n" + html_summary(file) + html_errata(file) + html_warnings(file) +
                          html_element("div id=\"claims\"", "\n" + controls() + items(file)) +
                          "\n" + html_assumptions(file) + html_glossary(file)) +
         "\n";
}

}  // namespace

std::string html(const Run& run) {
  std::string title = run.tool, bodies;
  for (const FileRun& file : run.files) {
    if (&file == run.files.data()) title = file.paper.empty() ? file.file : file.paper;
    bodies += body(file, run);
  }
  return "<!DOCTYPE html>\n"
         "<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
         "<meta charset=\"utf-8\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
         std::string(policy) +
         "\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n" +
         html_element("title", html_escape(title) + ": verification report") + "\n<style>\n" +
         std::string(embedded::page_css) + "</style>\n</head>\n<body>\n" + bodies +
         script(embedded::page_js) + script(embedded::view_js) + "</body>\n</html>\n";
}

}  // namespace seam::report
