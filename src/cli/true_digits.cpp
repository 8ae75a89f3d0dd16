// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/true_digits.h"

#include <map>
#include <memory>
#include <new>

#include "cli/decide.h"
#include "cli/files.h"
#include "cli/supervisor.h"

// The digits are searched for without proof; that they are right is a statement of its own,
// which the checker accepts or not. The file is read again for that, only where something is
// wrong.

namespace seam::cli {
namespace {

using certificate::Verdict;
using claims::Expression;
using claims::PrintedNumber;

// What a statement `E ~ 0.25` prints; nothing of any other statement.
std::optional<PrintedNumber> printed_in(const Expression& statement) {
  const bool truncated = statement.kind == Expression::Kind::truncated;
  const Expression& relation = truncated ? statement.children[0] : statement;
  if (relation.kind != Expression::Kind::relation || relation.text != "~") return std::nullopt;
  auto printed = claims::printed_number(relation.children[1]);
  if (printed) printed->truncated = truncated;
  return printed;
}

// Whether two statements `E ~ 0.25` print the same E.
bool is_of_same_value(const Expression& a, const Expression& b) {
  const auto value = [](const Expression& e) -> const Expression& {
    const bool truncated = e.kind == Expression::Kind::truncated;
    return (truncated ? e.children[0] : e).children[0];
  };
  return printed_in(b) && claims::same(value(a), value(b));
}

std::map<std::string, const claims::Claim*> claims_of(const claims::Meaning& meaning) {
  std::map<std::string, const claims::Claim*> all;
  for (const auto& item : meaning.items) {
    if (const auto* claim = std::get_if<claims::MeantClaim>(&item))
      all[claim->claim.id] = &claim->claim;
    if (const auto* table = std::get_if<claims::MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const auto& cell : row.cells) all[cell.claim.id] = &cell.claim;
  }
  return all;
}

}  // namespace

Decided decide(const claims::NamedNumbers::Statement& statement, const VerifyOptions& options) {
  const Question question{"", &statement.lowered, &statement.written};
  return decide({question}, options, [](const symbolic::Formula& f) { return f; }).front();
}

std::optional<CertifiedDigits> certified(claims::NamedNumbers& numbers, const std::string& name,
                                         int places, bool truncated,
                                         const VerifyOptions& options) {
  try {
    const auto likely = numbers.likely(name, places, truncated);
    if (!likely) return std::nullopt;
    const auto statement = numbers.printed_as(name, *likely);
    Decided decided = decide(statement, options);
    if (decided.outcome.verdict == Verdict::proven)
      return CertifiedDigits{*likely, statement.lowered.exported->statement,
                             std::move(decided)};
  } catch (const claims::Unsupported&) {
  } catch (const std::bad_alloc&) {
  }
  return std::nullopt;
}

void add_true_digits(Verified& verified, const claims::Meaning& meaning,
                     const std::filesystem::path& file, const VerifyOptions& options) {
  const auto written = claims_of(meaning);
  std::unique_ptr<claims::NamedNumbers> numbers;
  for (report::ClaimRun* claim : report::claims(verified.run)) {
    if (claim->printed.verdict != Verdict::refuted) continue;
    const claims::Claim& as_written = *written.at(claim->id);
    const auto printed = printed_in(as_written.statement);
    if (!printed) continue;
    if (claim->corrected && claim->corrected->verdict == Verdict::proven &&
        is_of_same_value(as_written.statement, *as_written.corrected)) {
      claim->true_digits = claims::text(*printed_in(*as_written.corrected));
      claim->digits_confirmed = {claim->corrected->digest, claim->corrected->certificate, {}};
      continue;
    }
    if (!numbers)
      numbers = std::make_unique<claims::NamedNumbers>(parsed(file), opener_beside(file),
                                                       limits(options, file.string()));
    auto right = certified(*numbers, claim->id, printed->places(), printed->truncated, options);
    if (!right) continue;
    claim->true_digits = claims::text(right->number);
    const std::string name = claim->id + "~digits";  // no id: those have no '~'
    claim->digits_confirmed = {right->decided.outcome.digest, certificate_file(name), {}};
    verified.certificates[claim->digits_confirmed.certificate] = {
        name,
        false,
        Verdict::proven,
        {},
        std::move(right->statement),
        std::move(right->decided.evidence)};
  }
}

}  // namespace seam::cli
