// SPDX-License-Identifier: GPL-3.0-or-later
// judge_certificate FILE...: whether each certificate shows what it says.
#include <seamproof/certificate/json.h>
#include <seamproof/check/judge.h>

#include <fstream>
#include <iostream>
#include <iterator>

int main(int argc, char** argv) {
  bool all_accepted = argc > 1;
  for (int i = 1; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto certificate = seam::certificate::read(text);
    const auto judgement = seam::check::judge(certificate.statement, certificate.evidence);
    const bool accepted = judgement.verdict == certificate.verdict;
    std::cout << certificate.claim << (accepted ? ": accepted\n" : ": rejected\n");
    all_accepted = all_accepted && accepted;
  }
  return all_accepted ? 0 : 1;
}
