// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/printer.h"

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

Level binary_level(const std::string& operation) {
  if (operation == "^") return Level::power;
  return operation == "*" || operation == "/" ? Level::product : Level::sum;
}

}  // namespace

Level level(const Expression& e) {
  switch (e.kind) {
    case Kind::for_all:
    case Kind::for_some:
    case Kind::solve:
      return Level::statement;
    case Kind::equivalence:
      return Level::equivalence;
    case Kind::implication:
      return Level::implication;
    case Kind::disjunction:
      return Level::disjunction;
    case Kind::conjunction:
      return Level::conjunction;
    case Kind::negation:
      return Level::negation;
    case Kind::relation:
    case Kind::truncated:
      return Level::relation;
    case Kind::range:
      return Level::range;
    case Kind::plane:
    case Kind::from:
      return Level::prefix;
    case Kind::binary:
      return binary_level(e.text);
    case Kind::negate:
      return Level::factor;
    case Kind::number:
    case Kind::string:
    case Kind::infinity:
    case Kind::read:
    case Kind::half_open:
      return Level::postfix;
    default:
      return Level::callable;
  }
}

}  // namespace seam::claims
