// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/slack.h"

#include <algorithm>
#include <cstdlib>

#include "cli/refutation.h"
#include "prove/slack.h"

// A decimal has three digits that count, and is rounded down where it bounds from below, up
// where it bounds from above; a short fraction stands as it is.

namespace seam::cli {
namespace {

using certificate::Relation;
using exact::Integer;
using exact::Rational;

constexpr int digits = 3;
constexpr std::size_t longest_fraction = 12;

enum class Rounding { down, up };

Integer power_of_ten(int exponent) {
  Integer result;
  mpz_ui_pow_ui(result.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return result;
}

// value = digits * 10^exponent, rounded; value > 0.
std::pair<Integer, int> scaled(const Rational& value, Rounding rounding) {
  const auto length = [](const Integer& n) {
    return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 10));
  };
  int exponent = length(value.get_num()) - length(value.get_den()) - digits;
  for (;;) {
    const Rational whole = exponent < 0 ? Rational(value * power_of_ten(-exponent))
                                        : Rational(value / power_of_ten(exponent));
    Integer n;
    if (rounding == Rounding::down)
      mpz_fdiv_q(n.get_mpz_t(), whole.get_num().get_mpz_t(), whole.get_den().get_mpz_t());
    else
      mpz_cdiv_q(n.get_mpz_t(), whole.get_num().get_mpz_t(), whole.get_den().get_mpz_t());
    if (n <= power_of_ten(digits)) return {n, exponent};
    ++exponent;
  }
}

std::string decimal(const Rational& value, Rounding rounding) {
  if (value == 0) return "0";
  const Rounding outward = value > 0                    ? rounding
                           : rounding == Rounding::down ? Rounding::up
                                                        : Rounding::down;
  auto [n, exponent] = scaled(abs(value), outward);
  while (n % 10 == 0 && exponent < 0) {
    n /= 10;
    ++exponent;
  }
  std::string text = n.get_str();
  if (exponent > 6 || exponent < -12) {
    text += "e" + std::to_string(exponent);
  } else if (exponent >= 0) {
    text += std::string(static_cast<std::size_t>(exponent), '0');
  } else {
    const auto places = static_cast<std::size_t>(-exponent);
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, ".");
  }
  return (value < 0 ? "-" : "") + text;
}

std::string number(const Rational& value, Rounding rounding) {
  const std::string exact = value.get_str();
  return exact.size() <= longest_fraction ? exact : decimal(value, rounding);
}

std::string place(const std::vector<prove::Slack::Coordinate>& at) {
  std::string result;
  for (const auto& [variable, low, high] : at)
    result += (result.empty() ? "" : ", ") + readable(variable) +
              (low == high && low.get_str().size() <= longest_fraction
                   ? " = " + low.get_str()
                   : " = about " + decimal(low, Rounding::down));
  return result;
}

report::Slack in_digits(const prove::Slack& slack, const std::string& unit) {
  report::Slack result;
  result.of = unit;
  result.unknown = slack.unknown;
  if (!slack.unknown.empty()) return result;
  if (slack.high && slack.low == *slack.high) {
    result.low = number(slack.low, Rounding::down);
    result.high = number(slack.low, Rounding::up);
  } else {
    result.low = decimal(slack.low, Rounding::down);
    if (slack.high) result.high = decimal(*slack.high, Rounding::up);
  }
  result.at = place(slack.at);
  return result;
}

bool is_inequality(const certificate::Sign& sign) {
  return sign.relation != Relation::zero && sign.relation != Relation::nonzero;
}

// Of an equation it is looked at only whether there is a point that it speaks of.
bool is_measured(const certificate::Obligation& obligation) {
  const auto* sign = std::get_if<certificate::Sign>(&obligation);
  return sign && (is_inequality(*sign) || !sign->domain.where.empty());
}

}  // namespace

void add_slacks(report::Outcome& outcome, const claims::Exported& exported) {
  if (outcome.verdict != report::Verdict::proven) return;
  const std::set<int> denied = only_denied(exported.statement);
  std::vector<prove::Measured> measured;
  for (std::size_t i = 0; i < outcome.obligations.size(); ++i) {
    const report::ObligationRun& run = outcome.obligations[i];
    const int number = static_cast<int>(i);
    if (!run.guard && run.status == report::ObligationRun::Status::holds &&
        is_measured(exported.statement.obligations[i]) && !denied.contains(number))
      measured.push_back({number, exported.measures[i].scale});
  }
  if (measured.empty()) return;
  certificate::Statement with_scales = exported.statement;
  with_scales.nodes.insert(with_scales.nodes.end(), exported.further.begin(),
                           exported.further.end());
  const std::vector<prove::Slack> found = prove::slacks(with_scales, measured);
  for (std::size_t k = 0; k < measured.size(); ++k) {
    const int i = measured[k].obligation;
    const auto& sign = std::get<certificate::Sign>(exported.statement.obligations[i]);
    if (!is_inequality(sign) && found[k].unknown != prove::no_point) continue;
    outcome.obligations[i].slack = in_digits(found[k], exported.measures[i].unit);
  }
}

}  // namespace seam::cli
