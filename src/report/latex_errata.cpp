// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_errata.h"

#include <algorithm>
#include <vector>

#include "report/escape.h"
#include "report/latex_claim.h"
#include "report/latex_macro.h"
#include "report/mathematics.h"

// Every word is made from the claims, so that an author can send the list as it is: a claim's
// own title stands for the sentence of the paper.

namespace seam::report {
namespace {

// "Should read" is said of what was proven, and of certified digits; of nothing else.
bool has_right_version(const ClaimRun& claim) {
  return !claim.true_digits.empty() ||
         (claim.corrected && claim.corrected->verdict == Verdict::proven);
}

// Places in the order in which the file comes to them.
struct Place {
  std::string at;
  std::vector<const ClaimRun*> claims;
};

std::vector<Place> by_place(const std::vector<const ClaimRun*>& claims) {
  std::vector<Place> places;
  for (const ClaimRun* claim : claims) {
    auto place = std::ranges::find(places, claim->at, &Place::at);
    if (place == places.end()) place = places.insert(place, {claim->at, {}});
    place->claims.push_back(claim);
  }
  return places;
}

std::string item(const std::string& name, const std::string& content) {
  return latex_call("SeamItem", {name}) + content;
}

std::string formula(const Outcome& outcome) {
  return latex_call("SeamFormula", {mathematics(outcome.latex)});
}

std::string right_version(const ClaimRun& claim) {
  if (claim.corrected && claim.corrected->verdict == Verdict::proven)
    return item("should read", formula(*claim.corrected));
  if (!claim.true_digits.empty()) return item("should read", escape(claim.true_digits) + "\n");
  if (!claim.corrected) return "";
  return item("corrected", formula(*claim.corrected)) +
         latex_call("SeamVerdict", {word(claim.corrected->verdict)});
}

std::string erratum(const ClaimRun& claim) {
  std::string result =
      latex_call("SeamErratum", {latex_anchor(claim), escape(claim.id), escape(claim.title)});
  result += "\\begin{SeamNamed}\n" + item("printed", formula(claim.printed));
  result += right_version(claim);
  if (!claim.printed.witness.empty())
    result += item("because", latex_witness(claim.printed.witness) + "\n");
  if (!claim.comments.empty()) result += item("remark", latex_note(claim.comments));
  return result + "\\end{SeamNamed}\n";
}

std::string list(const std::vector<const ClaimRun*>& claims) {
  std::string result;
  for (const Place& place : by_place(claims)) {
    result +=
        latex_call("SeamPlace", {place.at.empty() ? "without a place" : escape(place.at)});
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
  std::vector<const ClaimRun*> known, others;
  for (const ClaimRun* claim : claims(file))
    if (claim->printed.verdict == Verdict::refuted)
      (has_right_version(*claim) ? known : others).push_back(claim);
  std::string result;
  if (!known.empty())
    result += latex_heading("Errata") + "To " + whose(file) +
              ". What is printed is refuted, and what should stand there is proven: each by "
              "evidence that the independent checker accepted.\\par\n" +
              list(known);
  if (!others.empty())
    result += latex_heading("Refuted, without a proven correction") + list(others);
  return result;
}

}  // namespace seam::report
