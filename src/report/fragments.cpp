// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/fragments.h"

#include <algorithm>

#include "report/figure.h"
#include "report/latex_claim.h"
#include "report/latex_macro.h"
#include "report/latex_table.h"
#include "report/style.h"

namespace seam::report {
namespace {

// As the certificates do: no colon in file names.
std::string file_name(std::string id) {
  std::ranges::replace(id, ':', '=');
  return id + ".tex";
}

}  // namespace

std::map<std::string, std::string> fragments(const FileRun& file) {
  std::map<std::string, std::string> result;
  result["seamproof.sty"] = style;
  std::string& status = result["seamproof-status.tex"];
  for (const ClaimRun* claim : claims(file)) {
    status += latex_call("SeamStatus", {claim->id, word(claim->printed.verdict)});
    result[file_name(claim->id)] = latex_claim(*claim);
  }
  for (const ItemRun& item : file.items) {
    if (const auto* table = std::get_if<TableRun>(&item))
      result["tables/" + file_name(table->id)] = latex_table(*table);
  }
  for (const auto& [name, figure] : figures(file))
    result["figures/" + name + ".tex"] = picture(*figure);
  return result;
}

}  // namespace seam::report
