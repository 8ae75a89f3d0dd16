// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_errata.h"

#include <vector>

#include "report/errata.h"
#include "report/escape.h"
#include "report/latex_claim.h"
#include "report/latex_macro.h"
#include "report/mathematics.h"
#include "report/witness.h"

// Every word is made from the claims, so that an author can send the list as it is: a claim's
// own title stands for the sentence of the paper.

namespace seam::report {
namespace {

std::string item(const std::string& name, const std::string& content) {
  return latex_call("SeamItem", {name}) + content;
}

std::string formula(const Outcome& outcome) {
  return latex_call("SeamFormula", {mathematics(outcome.latex)});
}

std::string right_version_of(const ClaimRun& claim) {
  switch (right_version(claim)) {
    case RightVersion::correction:
      return item("should read", formula(*claim.corrected));
    case RightVersion::digits:
      return item("should read", escape(claim.true_digits) + "\n");
    case RightVersion::unproven:
      return item("corrected", formula(*claim.corrected)) +
             latex_call("SeamVerdict", {word(claim.corrected->verdict)});
    case RightVersion::none:
      break;
  }
  return "";
}

std::string erratum(const ClaimRun& claim) {
  std::string result =
      latex_call("SeamErratum", {latex_anchor(claim), escape(claim.id), escape(claim.title)});
  result += "\\begin{SeamNamed}\n" + item("printed", formula(claim.printed));
  result += right_version_of(claim);
  if (!claim.printed.witness.empty())
    result += item("because", escape(readable_witness(claim.printed.witness)) + "\n");
  if (!claim.comments.empty()) result += item("remark", latex_note(claim.comments));
  return result + "\\end{SeamNamed}\n";
}

std::string list(const std::vector<ErrataPlace>& places) {
  std::string result;
  for (const ErrataPlace& place : places) {
    result += latex_call("SeamPlace", {escape(place.at)});
    for (const ClaimRun* claim : place.claims) result += erratum(*claim);
  }
  return result;
}

std::string whose(const FileRun& file) {
  return joined({"\\emph{" + escape(file.paper.empty() ? file.file : file.paper) + "}",
                 escape(file.by), escape(file.source), escape(file.year)},
                ", ");
}

}  // namespace

std::string latex_errata(const FileRun& file) {
  const Errata all = errata(file);
  std::string result;
  if (!all.known.empty())
    result += latex_heading(errata_known_title) + "To " + whose(file) + ". " +
              errata_known_words + "\\par\n" + list(all.known);
  if (!all.others.empty()) result += latex_heading(errata_others_title) + list(all.others);
  return result;
}

}  // namespace seam::report
