// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_warnings.h"

#include "report/escape.h"
#include "report/latex_macro.h"

namespace seam::report {

std::string latex_warnings(const FileRun& file) {
  std::string list;
  for (const WarningRun& warning : file.warnings)
    list += "\\item " + escape(warning.message) +
            (warning.hint.empty() ? "" : "; " + escape(warning.hint)) + " \\SeamQuiet{(line " +
            std::to_string(warning.line) +
            (warning.included.empty() ? "" : " of " + escape(warning.included)) + ")}\n";
  return list.empty() ? ""
                      : latex_heading("Warnings") + "\\begin{itemize}\\raggedright\n" + list +
                            "\\end{itemize}\n";
}

}  // namespace seam::report
