// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_errata.h"

#include "report/errata.h"
#include "report/html_escape.h"
#include "report/html_parts.h"

namespace seam::report {
namespace {

std::vector<Term> right_version_of(const ClaimRun& claim) {
  switch (right_version(claim)) {
    case RightVersion::correction:
      return {{"should read", html_formula(claim.corrected->latex)}};
    case RightVersion::digits:
      return {{"should read", html_code(claim.true_digits)}};
    case RightVersion::unproven:
      return {{"corrected",
               html_formula(claim.corrected->latex) + html_verdict(claim.corrected->verdict)}};
    case RightVersion::none:
      break;
  }
  return {};
}

std::string erratum(const ClaimRun& claim) {
  std::vector<Term> terms{{"printed", html_formula(claim.printed.latex)}};
  for (const Term& term : right_version_of(claim)) terms.push_back(term);
  terms.push_back({"because", html_witness(claim.printed.witness)});
  terms.push_back({"remark", html_note(claim.comments)});
  return html_element("li",
                      html_element("p", html_link(claim.id) + " " + html_escape(claim.title)) +
                          html_terms(terms)) +
         "\n";
}

std::string list(const std::vector<ErrataPlace>& places) {
  std::string result;
  for (const ErrataPlace& place : places) {
    std::string items;
    for (const ClaimRun* claim : place.claims) items += erratum(*claim);
    result += html_element("h3", html_escape(place.at)) + "\n" +
              html_element("ul class=\"errata\"", items) + "\n";
  }
  return result;
}

std::string folded(const std::string& words, const std::vector<ErrataPlace>& places) {
  std::size_t count = 0;
  for (const ErrataPlace& place : places) count += place.claims.size();
  return html_element("details",
                      html_element("summary", words + ", by their places in the paper: " +
                                                  std::to_string(count)) +
                          "\n" + list(places)) +
         "\n";
}

}  // namespace

std::string html_errata(const FileRun& file) {
  const Errata all = errata(file);
  std::string result;
  if (!all.known.empty())
    result +=
        html_section("errata", errata_known_title,
                     html_element("p", errata_known_words) + folded("corrections", all.known));
  if (!all.others.empty())
    result += html_section("refuted", errata_others_title, folded("claims", all.others));
  return result;
}

}  // namespace seam::report
