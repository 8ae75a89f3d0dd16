// SPDX-License-Identifier: GPL-3.0-or-later
#include "outcome.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "certificate/json.h"
#include "certificate/to_json.h"
#include "check/judge.h"

// The same statement cannot be proven and refuted. Another statement must have another digest;
// what its evidence shows, whatever the certificate says, must be so.

namespace seam::tampered {
namespace {

using certificate::Json;
using certificate::Verdict;

constexpr long effort = 30'000'000;  // elementary steps: what takes more is rejected

}  // namespace

Original original(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  certificate::Certificate read = certificate::read(text);
  const Verdict verdict = check::judge(read.statement, read.evidence).verdict;
  std::string digest = certificate::digest(read.statement);
  return {file, Json::parse(text), std::move(read.statement), std::move(digest), verdict};
}

Outcome outcome(const Original& original, const Json& changed) {
  if (changed == original.json) return {};
  certificate::Certificate read;
  try {
    read = certificate::read(changed.dump());
  } catch (const certificate::FormatError& error) {
    return {Outcome::Kind::unreadable, error.what()};
  }
  const bool is_same = read.statement == original.statement;
  if (is_same != (certificate::digest(read.statement) == original.digest))
    return {Outcome::Kind::wrong, "the digest does not tell the statements apart"};
  const check::Judgement judgement = check::judge(read.statement, read.evidence, effort);
  const Verdict shown = judgement.verdict;
  if (shown == Verdict::undecided) return {Outcome::Kind::rejected, judgement.reason};
  if (is_same && shown != original.verdict && original.verdict != Verdict::undecided)
    return {Outcome::Kind::wrong, "the same statement is proven and refuted", shown};
  const bool is_conditional =
      read.verdict == Verdict::conditional && !read.using_claims.empty();
  const bool is_accepted = shown == (is_conditional ? Verdict::proven : read.verdict);
  if (!is_accepted) return {Outcome::Kind::rejected, "another verdict is shown", shown};
  return {is_same ? Outcome::Kind::same_statement : Outcome::Kind::other_statement, {}, shown};
}

}  // namespace seam::tampered
