// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_front.h"

#include <vector>

#include "report/escape.h"
#include "report/latex_macro.h"
#include "report/tally.h"

namespace seam::report {
namespace {

std::string tally_row(const std::string& title, const Summary& summary) {
  const auto cell = [](int n) { return n == 0 ? std::string() : std::to_string(n); };
  return title + " & " + std::to_string(summary.claims) + " & " + cell(summary.proven) + " & " +
         cell(summary.refuted) + " & " + cell(summary.conditional) + " & " +
         cell(summary.undecided) + " & " + cell(summary.as_expected) + "\\\\\n";
}

std::string summary_table(const FileRun& file) {
  std::string result = "\\begin{SeamTally}\n";
  for (const Tally& tally : by_section(file))
    result += tally_row(escape(tally.title), tally.summary);
  return result + "\\midrule\n" + tally_row("\\textbf{all}", summarize(file)) +
         "\\end{SeamTally}\n";
}

std::string fact(const std::string& name, const std::string& value) {
  return value.empty() ? "" : name + " & " + value + "\\\\\n";
}

// What was read, and by what: enough to make the same report again.
std::string facts(const FileRun& file, const Run& run) {
  std::vector<std::string> libraries;
  for (const std::string& library : run.libraries) libraries.push_back(escape(library));
  return "\\begin{SeamFacts}\n" + fact("claims", "\\texttt{" + escape(file.file) + "}") +
         fact("SHA-256",
              file.sha256.empty() ? "" : "{\\small\\texttt{" + escape(file.sha256) + "}}") +
         fact("read by", escape(run.tool)) + fact("with", joined(libraries, ", ")) +
         "\\end{SeamFacts}\n";
}

}  // namespace

std::string latex_front(const FileRun& file, const Run& run) {
  const std::string title = file.paper.empty() ? file.file : file.paper;
  std::string result = "\\renewcommand{\\SeamRunning}{" + escape(title) + "}\n";
  result += "{\\color{seamquiet}\\large Verification report\\par}\n\\vspace{8pt}\n";
  result += "{\\LARGE\\bfseries\\raggedright " + escape(title) + "\\par}\n\\vspace{2pt}\n";
  const std::string whose =
      joined({escape(file.by), escape(file.source), escape(file.year)}, ", ");
  if (!whose.empty()) result += "{\\large\\raggedright " + whose + "\\par}\n";
  result += "\\vspace{8pt}\n" + sentence(summarize(file)) + " ";
  if (has_alarm(file))
    result += "\\SeamAlarm{Evidence of this run was rejected; see the claims so marked.}\n";
  else
    result +=
        "Every \\emph{proven} and every \\emph{refuted} was accepted by the independent "
        "checker from the certificate named with it.\\par\n";
  return result + summary_table(file) + facts(file, run);
}

}  // namespace seam::report
