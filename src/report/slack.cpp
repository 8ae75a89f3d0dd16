// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "report/run.h"

// Decimals are compared as doubles: which of two slacks is shown first decides nothing.

namespace seam::report {
namespace {

double about(const std::string& decimal) {
  const std::size_t bar = decimal.find('/');
  const double numerator = std::strtod(decimal.c_str(), nullptr);
  return bar == std::string::npos ? numerator
                                  : numerator / std::strtod(decimal.c_str() + bar + 1, nullptr);
}

}  // namespace

const ObligationRun* closest_to_failing(const Outcome& outcome) {
  const ObligationRun* closest = nullptr;
  for (const ObligationRun& obligation : outcome.obligations) {
    const Slack& slack = obligation.slack;
    if (slack.high.empty() || slack.low == "0") continue;
    if (!closest || is_closer(slack, closest->slack)) closest = &obligation;
  }
  return closest;
}

bool is_closer(const Slack& a, const Slack& b) {
  return about(a.high) < about(b.high);
}

std::string in_words(const Slack& slack) {
  if (!slack.unknown.empty()) return "not computed: " + slack.unknown;
  const std::string of = slack.of.empty() ? "" : " (" + slack.of + ")";
  if (slack.high.empty()) return slack.low + " or more" + of;
  if (slack.low == slack.high)
    return slack.low + (slack.at.empty() ? "" : ", attained at " + slack.at) + of;
  return "between " + slack.low + " and " + slack.high +
         (slack.at.empty() ? "" : ", the latter at " + slack.at) + of;
}

}  // namespace seam::report
