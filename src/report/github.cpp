// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/github.h"

#include "report/html_escape.h"
#include "report/tally.h"
#include "report/terminal.h"

// A command ends with its line, and % begins an escape in it; a value in front of `::` ends at
// `,` or `:`. The summary is HTML as Markdown allows it, so only html_escape has to be right;
// line ends would end a block of HTML, and html_escape makes blanks of them.

namespace seam::report {
namespace {

std::string escaped(const std::string& text, bool is_value) {
  std::string result;
  for (const char c : text) {
    if (c == '%')
      result += "%25";
    else if (c == '\r')
      result += "%0D";
    else if (c == '\n')
      result += "%0A";
    else if (is_value && c == ':')
      result += "%3A";
    else if (is_value && c == ',')
      result += "%2C";
    else
      result += c;
  }
  return result;
}

std::string command(const char* kind, const FileRun& file, const std::string& included,
                    int line, int column, const std::string& title,
                    const std::string& message) {
  return std::string("::") + kind + " file=" + escaped(path_of(file, included), true) +
         ",line=" + std::to_string(line) + ",col=" + std::to_string(column) +
         ",title=" + escaped(title, true) + "::" + escaped(message, false) + "\n";
}

std::string cell(const std::string& content) {
  return html_element("td", content);
}

std::string row(const ClaimRun& claim) {
  return html_element("tr", cell(std::string(shape(claim.printed.verdict)) + " " +
                                 word(claim.printed.verdict)) +
                                cell(html_element("code", html_escape(claim.id)) + " " +
                                     html_escape(claim.title)) +
                                cell(html_escape(in_short(claim)))) +
         "\n";
}

std::string table(const std::string& rows) {
  return html_element("table", "\n" +
                                   html_element("tr", html_element("th", "verdict") +
                                                          html_element("th", "claim") +
                                                          html_element("th", "")) +
                                   "\n" + rows) +
         "\n";
}

std::string summary(const FileRun& file) {
  std::string concerned, all;
  for (const ErrorRun& error : file.errors)
    concerned += html_element("tr", cell("error") +
                                        cell(std::to_string(error.line) + ":" +
                                             std::to_string(error.column)) +
                                        cell(html_escape(error.message))) +
                 "\n";
  for (const ClaimRun* claim : claims(file)) {
    all += row(*claim);
    if (concern(*claim) != Concern::none) concerned += row(*claim);
  }
  std::string result =
      html_element("h3", html_escape(file.paper.empty() ? file.file : file.paper)) + "\n";
  if (file.errors.empty()) result += html_element("p", sentence(summarize(file))) + "\n";
  if (!concerned.empty()) result += table(concerned);
  if (!all.empty())
    result +=
        html_element("details", html_element("summary", "all claims") + "\n" + table(all)) +
        "\n";
  return result;
}

}  // namespace

std::string github_annotations(const Run& run, bool allow_undecided) {
  std::string lines;
  for (const FileRun& file : run.files) {
    for (const ErrorRun& error : file.errors)
      lines += command("error", file, error.included, error.line, error.column,
                       "error in a claim file",
                       error.message + (error.hint.empty() ? "" : "; " + error.hint));
    for (const WarningRun& warning : file.warnings)
      lines +=
          command("notice", file, warning.included, warning.line, warning.column, warning.rule,
                  warning.message + (warning.hint.empty() ? "" : "; " + warning.hint));
    for (const ClaimRun* claim : claims(file)) {
      const Concern what = concern(*claim);
      if (what == Concern::none) continue;
      const char* kind = what != Concern::undecided ? "error"
                         : allow_undecided          ? "notice"
                                                    : "warning";
      lines += command(kind, file, claim->included, claim->line, claim->column, claim->id,
                       in_short(*claim));
    }
  }
  return lines;
}

std::string github_summary(const Run& run) {
  std::string result = html_element("h2", "Claims") + "\n";
  for (const FileRun& file : run.files) result += summary(file);
  return result;
}

}  // namespace seam::report
