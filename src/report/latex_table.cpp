// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_table.h"

#include <algorithm>

#include "report/escape.h"
#include "report/latex_macro.h"

namespace seam::report {
namespace {

std::size_t columns_of(const TableRun& table) {
  std::size_t columns = table.labels.size();
  for (const TableRun::Row& row : table.rows) columns = std::max(columns, row.cells.size());
  return columns;
}

std::string cell(const TableRun::Row& row, std::size_t i) {
  const ClaimRun& claim = row.cells[i];
  const std::string printed = i < row.printed.size() ? escape(row.printed[i]) : "";
  return "\\SeamCell{" + std::string(word(claim.printed.verdict)) + "}{" + printed + "}{" +
         escape(claim.true_digits) + "}";
}

}  // namespace

std::string latex_table(const TableRun& table) {
  std::string grid =
      "\\begin{tabular}{@{}l*{" + std::to_string(columns_of(table)) + "}{r}@{}}\\toprule\n";
  for (const std::string& label : table.labels) grid += " & " + escape(label);
  grid += table.labels.empty() ? "" : "\\\\\\midrule\n";
  for (const TableRun::Row& row : table.rows) {
    grid += escape(row.label);
    for (std::size_t i = 0; i < row.cells.size(); ++i) grid += " & " + cell(row, i);
    grid += "\\\\\n";
  }
  return latex_call("SeamTitle", {escape(table.id), escape(table.title), escape(table.at)}) +
         "\\begin{SeamIndent}\n" + latex_note(table.comments) +
         latex_call("SeamFit", {grid + "\\bottomrule\\end{tabular}"}) + "\\end{SeamIndent}\n";
}

}  // namespace seam::report
