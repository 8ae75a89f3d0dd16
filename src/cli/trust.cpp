// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <set>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/one_claim.h"

namespace seam::cli {
namespace {

using report::ClaimRun;

// A text under a heading, its further lines as deep as the first.
std::string indented(std::string text, const std::string& margin) {
  for (std::size_t at = text.find('\n'); at != std::string::npos;
       at = text.find('\n', at + 1 + margin.size()))
    text.insert(at + 1, margin);
  return margin + text + "\n";
}

// The definitions that the claims speak of: parameters, or all others.
std::string definitions(const report::FileRun& file, const std::vector<const ClaimRun*>& claims,
                        bool parameters) {
  std::set<std::string> needed;
  for (const ClaimRun* claim : claims)
    needed.insert(claim->definitions.begin(), claim->definitions.end());
  std::string result;
  for (const auto& item : file.items)
    if (const auto* definition = std::get_if<report::DefinitionRun>(&item);
        definition && definition->is_parameter == parameters &&
        std::ranges::any_of(definition->names,
                            [&](const std::string& name) { return needed.contains(name); }))
      result += indented(definition->text, "       ");
  return result;
}

void print_statement(const char* heading, const report::Outcome& outcome) {
  std::cout << "   " << heading << " " << report::word(outcome.verdict) << "\n"
            << indented(outcome.text, "       ");
}

void print_obligations(const ClaimRun& claim, const report::Outcome& outcome) {
  std::cout << "   " << claim.id << ", digest " << outcome.digest.substr(0, 16) << ", "
            << (outcome.certificate.empty() ? "no certificate" : outcome.certificate) << "\n";
  for (const auto& o : outcome.obligations)
    std::cout << "       " << status_word(o.status) << "  " << o.text
              << (o.about.empty() ? "" : "  [" + o.about + "]") << "\n";
}

std::string listed(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
  return result;
}

}  // namespace

int trust(const std::string& file, const std::string& id, const VerifyOptions& options) {
  const Verified verified = one_claim(file, id, options);
  const ClaimRun& claim = find(verified.run, id);
  const std::vector<const ClaimRun*> behind =
      report::claims(verified.run);  // it and all it uses

  std::cout << id << ": " << report::word(claim.printed.verdict)
            << "\n\nWhoever believes this, believes\n\n"
            << "1. that these words say what the paper says"
            << (claim.at.empty() ? "" : ", at " + claim.at) << ":\n";
  print_statement("statement:", claim.printed);
  if (claim.corrected) print_statement("corrected:", *claim.corrected);
  if (const std::string text = definitions(verified.run, behind, false); !text.empty())
    std::cout << "   with these definitions:\n" << text;

  std::cout << "\n2. these assumptions:\n";
  const std::string parameters = definitions(verified.run, behind, true);
  std::cout << (parameters.empty() ? "       none\n" : parameters);
  for (const ClaimRun* used : behind)
    if (used != &claim)
      std::cout << "       the claim " << used->id << ", "
                << report::word(used->printed.verdict) << "\n";

  std::cout << "\n3. that the language turned it into the right obligations:\n";
  for (const ClaimRun* used : behind) {
    print_obligations(*used, used->printed);
    if (used->corrected) print_obligations(*used, *used->corrected);
  }
  std::set<std::string> predicates;
  for (const ClaimRun* used : behind)
    predicates.insert(used->predicates.begin(), used->predicates.end());
  if (!predicates.empty())
    std::cout << "   by the meaning of " << listed({predicates.begin(), predicates.end()})
              << " (docs/language.md)\n";

  const std::vector<std::string> all = libraries();
  std::cout << "\n4. that the checker judges rightly: seamproof-check " << SEAMPROOF_VERSION
            << ", which uses the integers of " << all.back()
            << ", and the\n   compiler and the machine.\n\n"
            << "The search for evidence need not be believed. It uses "
            << listed({all.begin(), all.end() - 1})
            << ";\nof these, geometry and the reading of the file build the obligations too.\n";
  return ok;
}

}  // namespace seam::cli
