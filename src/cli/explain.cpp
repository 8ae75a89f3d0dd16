// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/one_claim.h"
#include "report/terminal.h"

namespace seam::cli {
namespace {

void print_outcome(const char* heading, const report::Outcome& outcome) {
  std::cout << heading << ": " << outcome.text << "\n  " << report::shape(outcome.verdict)
            << " " << report::word(outcome.verdict);
  if (!outcome.witness.empty()) std::cout << ", " << outcome.witness;
  if (!outcome.reason.empty()) std::cout << ", " << outcome.reason << ": " << outcome.detail;
  std::cout << "\n";
  int number = 0;
  for (const auto& o : outcome.obligations) {
    std::cout << "  " << ++number << ". " << status_word(o.status) << "  " << o.kind
              << (o.guard ? " (guard)" : "");
    if (!o.about.empty()) std::cout << "  " << o.about;
    std::cout << "\n     " << o.text << "\n     " << o.evidence << "\n";
    if (!o.slack.empty()) std::cout << "     slack " << report::in_words(o.slack) << "\n";
  }
}

}  // namespace

int explain(const std::string& file, const std::string& id, const VerifyOptions& options) {
  const Verified verified = one_claim(file, id, options);
  const report::ClaimRun& claim = find(verified.run, id);
  std::cout << id << (claim.title.empty() ? "" : "  \"" + claim.title + "\"")
            << (claim.at.empty() ? "" : "  at " + claim.at) << "\n";
  for (const std::string& comment : claim.comments) std::cout << "  # " << comment << "\n";
  print_outcome("statement", claim.printed);
  if (claim.corrected) print_outcome("corrected", *claim.corrected);
  for (const report::WarningRun& warning : verified.run.warnings)
    if (warning.claim == id)
      std::cout << "warning: " << warning.message << " [" << warning.rule << "]\n";
  for (const std::string& used : claim.using_claims)
    std::cout << "rests on " << used << ": "
              << report::word(find(verified.run, used).printed.verdict) << "\n";
  return ok;
}

}  // namespace seam::cli
