// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_macro.h"

#include "report/escape.h"

namespace seam::report {

std::string latex_call(const std::string& macro, const std::vector<std::string>& arguments) {
  std::string result = "\\" + macro;
  for (const std::string& argument : arguments) result += "{" + argument + "}";
  return result + "\n";
}

std::string latex_heading(const std::string& title) {
  return latex_call("section", {title});
}

std::string latex_note(const std::vector<std::string>& comments) {
  const std::string note = joined(comments, " ");
  return note.empty() ? "" : latex_call("SeamNote", {escape(note)});
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string result;
  for (const std::string& part : parts) {
    if (part.empty()) continue;
    if (!result.empty()) result += separator;
    result += part;
  }
  return result;
}

}  // namespace seam::report
