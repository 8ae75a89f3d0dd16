// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_warnings.h"

#include "report/html_escape.h"
#include "report/html_parts.h"

namespace seam::report {

std::string html_warnings(const FileRun& file) {
  std::string list;
  for (const WarningRun& warning : file.warnings) {
    std::string words = html_escape(warning.message);
    if (!warning.hint.empty()) words += "; " + html_escape(warning.hint);
    words +=
        " " + html_element(
                  "span class=\"quiet\"",
                  "line " + std::to_string(warning.line) +
                      (warning.included.empty() ? "" : " of " + html_escape(warning.included)));
    if (!warning.claim.empty()) words += " " + html_link(warning.claim);
    list += html_element("li", words) + "\n";
  }
  return list.empty() ? "" : html_section("warnings", warnings_title, html_element("ul", list));
}

}  // namespace seam::report
