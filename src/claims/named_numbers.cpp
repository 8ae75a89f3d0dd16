// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/named_numbers.h"

#include <algorithm>

#include "claims/item_reader.h"
#include "claims/stating.h"

// A number printed with a power of ten is compared as a plain decimal with the point moved, or,
// where the digits end before the units, after the named number is divided by a power of ten:
// either way half a unit of the last printed digit is what it is on paper.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

constexpr int longest_exponent = 1000;
constexpr int more_places = 3;  // that a number is known to before it is cut off

Expression whole_number(const std::string& digits) {
  return {Kind::number, digits, {}, {}};
}

// The digits with the point moved by so many places, to the right where `by` is positive; `by`
// is at most the number of places.
std::string moved(const PrintedNumber& number, int by) {
  std::string digits = number.digits;
  std::erase(digits, '.');
  const int places = number.places() - by;
  if (std::ssize(digits) <= places) digits.insert(0, places + 1 - digits.size(), '0');
  if (places > 0) digits.insert(digits.size() - places, ".");
  return digits;
}

}  // namespace

int PrintedNumber::places() const {
  const std::size_t point = digits.find('.');
  return point == std::string::npos ? 0 : static_cast<int>(digits.size() - point - 1);
}

std::optional<PrintedNumber> printed_number(const Expression& e) {
  if (e.kind == Kind::number) return PrintedNumber{e.text};
  if (e.kind != Kind::negate || e.children[0].kind != Kind::number) return std::nullopt;
  return PrintedNumber{e.children[0].text, true};
}

std::string text(const PrintedNumber& number) {
  return (number.negative ? "-" : "") + number.digits + (number.truncated ? "…" : "") +
         (number.exponent == 0 ? "" : "·10^" + std::to_string(number.exponent));
}

// ---- what a reader knows of places

const Reader::Place& Reader::place(const std::string& id) const {
  static const Place nowhere;
  const auto found = places_.find(id);
  return found == places_.end() ? nowhere : found->second;
}

Lowered Reader::lower(const Expression& statement, const Place& place) {
  evaluator_.standing = place.standing;
  Lowered result = lower(statement, place.scope, ", " + format(statement));
  evaluator_.standing.clear();
  return result;
}

std::string Reader::likely_decimal(const Expression& number, const Place& place, int digits) {
  Numbers& numbers = *meaning_.numbers;
  const Value value = evaluator_.evaluate(number, place.scope);
  try {
    return numbers.decimal(as_number(evaluator_, evaluator_.resolved(value, number), number),
                           digits);
  } catch (const Unsupported&) {
    const auto* extremum = value.as<Extremum>();
    if (!extremum) throw;
    return numbers.decimal(nearly_attained(evaluator_, *extremum, digits * 10L / 3 + 64).value,
                           digits);
  }
}

bool Reader::defines_number(const std::string& name) const {
  const auto found = evaluator_.globals.find(name);
  if (found == evaluator_.globals.end() || !found->second.value) return false;
  const Value& value = *found->second.value;
  return value.as<Extremum>() || (value.as<Scalar>() && is_number(*value.as<Scalar>()));
}

// ---- names

NamedNumbers::NamedNumbers(const File& file, const Opener& open, const Limits& limits)
    : open_(open), limits_(limits) {
  meaning_.numbers = std::make_shared<Numbers>();
  reader_ = std::make_unique<Reader>(meaning_, open_, limits_);
  reader_->read(file);
  const auto add_sides = [this](const std::string& id, const Expression& statement,
                                bool is_correction) {
    const Expression& e = statement.kind == Kind::truncated ? statement.children[0] : statement;
    if (e.kind != Kind::relation || e.children.size() != 2) return;
    if (is_correction) {
      named_.insert({id + ".corrected", {id, e.children[1]}});
      return;
    }
    for (const char* key : {"", ".value", ".left"})
      named_.insert({id + key, {id, e.children[0]}});
    named_.insert({id + ".right", {id, e.children[1]}});
  };
  const auto add_claim = [&](const MeantClaim& claim) {
    add_sides(claim.claim.id, claim.claim.statement, false);
    if (claim.claim.corrected) add_sides(claim.claim.id, *claim.claim.corrected, true);
  };
  for (const MeantItem& item : meaning_.items)
    if (const auto* ask = std::get_if<MeantAsk>(&item))
      for (const char* key : {"", ".value"})
        named_.insert({ask->id + key, {ask->id, ask->expression}});
  for (const MeantItem& item : meaning_.items)
    if (const auto* table = std::get_if<MeantTable>(&item))
      for (const auto& row : table->rows) std::ranges::for_each(row.cells, add_claim);
  for (const MeantItem& item : meaning_.items)
    if (const auto* claim = std::get_if<MeantClaim>(&item)) add_claim(*claim);
  for (const MeantItem& item : meaning_.items)
    if (const auto* definition = std::get_if<MeantDefinition>(&item);
        definition && reader_->defines_number(definition->item.name))
      named_.insert(
          {definition->item.name,
           {{}, {Kind::name, definition->item.name, {}, definition->item.name_span}}});
}

NamedNumbers::~NamedNumbers() = default;

const NamedNumbers::Named* NamedNumbers::find(const std::string& name) const {
  const auto found = named_.find(name);
  return found == named_.end() ? nullptr : &found->second;
}

std::vector<std::string> NamedNumbers::names() const {
  std::vector<std::string> all;
  for (const auto& entry : named_) all.push_back(entry.first);
  return all;
}

std::vector<std::string> NamedNumbers::claim_ids() const {
  std::vector<std::string> ids;
  for (const MeantItem& item : meaning_.items) {
    if (const auto* claim = std::get_if<MeantClaim>(&item)) ids.push_back(claim->claim.id);
    if (const auto* table = std::get_if<MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const MeantClaim& cell : row.cells) ids.push_back(cell.claim.id);
  }
  return ids;
}

NamedNumbers::Statement NamedNumbers::printed_as(const std::string& name,
                                                 const PrintedNumber& number) {
  const Named& named = *find(name);
  if (std::abs(number.exponent) > longest_exponent)
    throw Unsupported("a power of ten beyond 1000");
  Expression value = named.value;
  const int by = std::min(number.exponent, number.places());
  if (number.exponent > by)
    value = {Kind::binary,
             "/",
             {value, whole_number("1" + std::string(number.exponent - by, '0'))},
             named.value.span};
  Expression printed = whole_number(moved(number, by));
  printed.span = named.value.span;
  if (number.negative) printed = {Kind::negate, {}, {printed}, printed.span};
  Expression statement = {Kind::relation, "~", {value, printed}, named.value.span};
  if (number.truncated) statement = {Kind::truncated, {}, {statement}, statement.span};

  const std::size_t errors_before = meaning_.errors.size();
  try {
    Statement result{statement, reader_->lower(statement, reader_->place(named.id))};
    if (meaning_.errors.size() == errors_before) return result;
  } catch (const Problem& problem) {
    throw Unsupported(problem.diagnostic.message);
  }
  const std::string message = meaning_.errors.back().message;
  meaning_.errors.resize(errors_before);
  throw Unsupported(message);
}

std::optional<PrintedNumber> NamedNumbers::likely(const std::string& name, int places,
                                                  bool truncated) {
  const Named& named = *find(name);
  try {
    std::string digits;
    const int wanted = truncated ? places + more_places : places;
    const auto refusal = limits_("the digits of " + name + ", " + std::to_string(wanted), [&] {
      digits = reader_->likely_decimal(named.value, reader_->place(named.id), wanted);
    });
    if (refusal) return std::nullopt;
    if (truncated) digits.resize(digits.size() - more_places);
    if (digits.ends_with('.')) digits.pop_back();
    const bool negative = digits.starts_with('-');
    return PrintedNumber{digits.substr(negative ? 1 : 0), negative, truncated};
  } catch (const std::runtime_error&) {  // whatever stands in the way: it is only a search
  }
  return std::nullopt;
}

}  // namespace seam::claims
