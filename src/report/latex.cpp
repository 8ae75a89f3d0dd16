// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex.h"

#include "report/drawing.h"
#include "report/escape.h"
#include "report/figure.h"
#include "report/glossary.h"
#include "report/latex_assumptions.h"
#include "report/latex_claim.h"
#include "report/latex_errata.h"
#include "report/latex_front.h"
#include "report/latex_macro.h"
#include "report/latex_table.h"
#include "report/latex_warnings.h"
#include "report/mathematics.h"
#include "report/style.h"

namespace seam::report {
namespace {

std::string latex_item(const SectionRun& section) {
  return latex_heading(escape(section.title));
}

std::string latex_item(const DefinitionRun& definition) {
  return "\\begin{SeamIndent}\n" + latex_note(definition.comments) +
         latex_call("SeamFormula", {mathematics(definition.latex)}) + "\\end{SeamIndent}\n";
}

std::string latex_item(const ClaimRun& claim) {
  return latex_claim(claim);
}

std::string latex_item(const TableRun& table) {
  std::string result = latex_table(table);
  for (const TableRun::Row& row : table.rows)
    for (const ClaimRun& cell : row.cells) result += latex_claim(cell);
  return result;
}

std::string latex_item(const FigureRun& figure) {
  const std::string place = figure.at.empty() ? "" : " (" + escape(figure.at) + ")";
  return picture(figure) + "\\begin{center}\\small " + escape(figure.title) + place +
         ". \\SeamQuiet{" + escape(description(figure)) + "}\\end{center}\n";
}

std::string latex_item(const AskRun& ask) {
  std::string result =
      latex_call("SeamQuestion",
                 {escape(ask.id), ask.decimal.empty() ? "no answer" : "value"}) +
      "\\begin{SeamIndent}\n";
  result += latex_call("SeamFormula", {mathematics(ask.latex)});
  if (!ask.decimal.empty())
    result += latex_call("SeamLine", {"certified decimal", escape(ask.decimal)});
  if (!ask.closed_form.empty())
    result += latex_call("SeamLine", {"closed form", escape(ask.closed_form)});
  if (!ask.detail.empty()) result += latex_call("SeamLine", {"reason", escape(ask.detail)});
  return result + "\\end{SeamIndent}\n";
}

std::string predicates(const Run& run) {
  std::vector<std::string> used;
  for (const FileRun& file : run.files)
    for (const ClaimRun* claim : claims(file))
      used.insert(used.end(), claim->predicates.begin(), claim->predicates.end());
  std::string result;
  for (const GlossaryEntry& entry : glossary(used))
    result += "\\item[\\texttt{" + escape(entry.predicate) + "}] " + entry.latex + "\n";
  return result;
}

std::string closing(const Run& run) {
  std::string result = latex_heading("Glossary") + "\\begin{description}\\raggedright\n";
  result +=
      "\\item[\\SeamVerdict{proven}] There is a certificate that the independent checker "
      "accepted.\n"
      "\\item[\\SeamVerdict{refuted}] There is an exact witness that the checker accepted.\n"
      "\\item[\\SeamVerdict{conditional}] Proven from a claim that is itself not proven.\n"
      "\\item[\\SeamVerdict{undecided}] Neither; the reason is given with the claim.\n" +
      predicates(run) + "\\end{description}\n";
  return result +
         "Whether a claim was turned into the right obligations is for a person to judge; "
         "that they hold or fail is what the certificates show. To have them judged again: "
         "\\texttt{seamproof-check}, with the folder of this report.\\par\n";
}

}  // namespace

std::string latex(const Run& run) {
  std::string result = std::string(preamble) + std::string(style);
  result += "\\title{" +
            escape(run.files.empty()            ? run.tool
                   : run.files[0].paper.empty() ? run.files[0].file
                                                : run.files[0].paper) +
            "}\n\\begin{document}\n";
  for (const FileRun& file : run.files) {
    if (&file != run.files.data()) result += "\\clearpage\n";
    result += latex_front(file, run) + latex_errata(file) + latex_warnings(file);
    for (const ItemRun& item : file.items)
      result += std::visit([](const auto& it) { return latex_item(it); }, item);
    result += latex_assumptions(file);
  }
  return result + closing(run) + "\\end{document}\n";
}

}  // namespace seam::report
