// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_front.h"

#include <algorithm>
#include <vector>

#include "report/escape.h"
#include "report/latex_claim.h"
#include "report/latex_macro.h"
#include "report/mathematics.h"

namespace seam::report {
namespace {

// Verdicts by section: where in the paper the trouble is.
struct Tally {
  std::string title;
  Summary summary;
};

std::vector<Tally> by_section(const FileRun& file) {
  std::vector<Tally> tallies;
  FileRun part;
  std::string title = "before the first section";
  const auto finish = [&] {
    const Summary summary = summarize(part);
    if (summary.claims > 0) tallies.push_back({title, summary});
    part.items.clear();
  };
  for (const ItemRun& item : file.items) {
    if (const auto* section = std::get_if<SectionRun>(&item)) {
      finish();
      title = section->title;
    } else {
      part.items.push_back(item);
    }
  }
  finish();
  return tallies;
}

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

bool has_alarm(const FileRun& file) {
  return std::ranges::any_of(claims(file), [](const ClaimRun* claim) {
    return !claim->printed.alarm.empty() ||
           (claim->corrected && !claim->corrected->alarm.empty());
  });
}

std::string sentence(const Summary& summary) {
  return "Of " + std::to_string(summary.claims) +
         (summary.claims == 1 ? " claim, " : " claims, ") + std::to_string(summary.proven) +
         " proven, " + std::to_string(summary.refuted) + " refuted, " +
         std::to_string(summary.conditional) + " conditional and " +
         std::to_string(summary.undecided) + " undecided; " +
         std::to_string(summary.as_expected) + (summary.as_expected == 1 ? " is" : " are") +
         " as the author of the file expects. ";
}

}  // namespace

std::string latex_front(const FileRun& file, const std::string& tool) {
  const std::string title = file.paper.empty() ? file.file : file.paper;
  std::string result = "\\renewcommand{\\SeamRunning}{" + escape(title) + "}\n";
  result += "{\\LARGE\\bfseries\\raggedright " + escape(title) + "\\par}\n\\vspace{2pt}\n";
  std::string whose = escape(file.by);
  for (const std::string& more : {file.source, file.year})
    if (!more.empty()) whose += (whose.empty() ? "" : ", ") + escape(more);
  if (!whose.empty()) result += "{\\large\\raggedright " + whose + "\\par}\n";
  result += "\\vspace{6pt}{\\large\\color{quiet} Verification report\\par}\n\\vspace{6pt}\n";
  result += sentence(summarize(file));
  if (has_alarm(file))
    result += "\\SeamAlarm{Evidence of this run was rejected; see the claims so marked.}\n";
  else
    result +=
        "Every \\emph{proven} and every \\emph{refuted} was accepted by the independent "
        "checker from the certificate named with it.\\par\n";
  result += summary_table(file);
  result += "\\SeamTrace{\\texttt{" + escape(file.file) + "}";
  if (!file.sha256.empty()) result += ", SHA-256 \\texttt{" + escape(file.sha256) + "}";
  return result + ", read by " + escape(tool) + "}\n";
}

std::string latex_errata(const FileRun& file) {
  std::string result;
  for (const ClaimRun* claim : claims(file)) {
    if (claim->printed.verdict != Verdict::refuted) continue;
    result += "\\SeamBand{refuted}{\\hyperlink{" + latex_anchor(*claim) +
              "}{\\texttt{\\textbf{" + escape(claim->id) + "}}}\\quad " + escape(claim->title) +
              "}{\\textcolor{quiet}{" + escape(claim->at) + "}}\n\\begin{SeamIndent}\n";
    result += latex_note(claim->comments) + "\\textcolor{quiet}{printed}\\nobreak\n" +
              latex_call("SeamFormula", {mathematics(claim->printed.latex)});
    if (!claim->printed.witness.empty())
      result += latex_call("SeamLine", {"witness", escape(claim->printed.witness)});
    if (claim->corrected)
      result += "\\textcolor{quiet}{corrected} \\SeamVerdict{" +
                std::string(word(claim->corrected->verdict)) + "}\\nobreak\n" +
                latex_call("SeamFormula", {mathematics(claim->corrected->latex)});
    result += "\\end{SeamIndent}\n";
  }
  if (result.empty()) return "";
  return latex_heading("Errata") + "What the paper prints and what was refuted.\\par\n" +
         result;
}

}  // namespace seam::report
