// SPDX-License-Identifier: GPL-3.0-or-later
// decide_claims FILE: whether every claim of a .seam file is proven.
#include <seamproof/check/judge.h>
#include <seamproof/claims/meaning.h>
#include <seamproof/prove/prove.h>

#include <fstream>
#include <iostream>
#include <iterator>

using namespace seam;

int main(int argc, char** argv) {
  if (argc != 2) return 64;
  std::ifstream file(argv[1], std::ios::binary);
  const auto source = std::make_shared<const text::Source>(
      argv[1], std::string{std::istreambuf_iterator<char>(file), {}});
  const claims::Parsed parsed = claims::parse(source);
  const claims::Meaning meaning =
      claims::mean(parsed.file, [](const auto&) { return nullptr; });
  if (!parsed.errors.empty() || !meaning.errors.empty()) return 65;

  bool all_proven = true;
  for (const auto& item : meaning.items) {
    const auto* claim = std::get_if<claims::MeantClaim>(&item);
    if (!claim || !claim->printed.exported) continue;
    const certificate::Statement& statement = claim->printed.exported->statement;
    const auto judgement = check::judge(statement, prove::prove(statement));
    const bool proven = judgement.verdict == certificate::Verdict::proven;
    std::cout << claim->claim.id << (proven ? ": proven\n" : ": not proven\n");
    all_proven = all_proven && proven;
  }
  return all_proven ? 0 : 1;
}
