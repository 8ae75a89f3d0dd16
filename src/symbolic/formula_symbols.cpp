// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/formula.h"

// What a formula holds by name. Shared parts are walked once.

namespace seam::symbolic {
namespace {

void collect(const Formula& f, std::set<std::string>& found, std::set<const void*>& seen) {
  const bool is_arbitrary = f.kind() == Formula::Kind::applied && !is_elementary(f.name());
  if (f.kind() == Formula::Kind::symbol || is_arbitrary) found.insert(f.name());
  if (f.operands().empty() || !seen.insert(f.identity()).second) return;
  for (const Formula& operand : f.operands()) collect(operand, found, seen);
}

}  // namespace

std::set<std::string> symbols(const Formula& f) {
  std::set<std::string> found;
  std::set<const void*> seen;
  collect(f, found, seen);
  return found;
}

bool is_elementary(const std::string& function) {
  return function == "sin" || function == "cos" || function == "exp" || function == "log";
}

bool is_generator(const std::string& name) {
  return name.find('(') != std::string::npos;
}

std::set<std::string> variables(const Formula& f) {
  std::set<std::string> found = symbols(f);
  std::erase_if(found, is_generator);
  return found;
}

bool is_number(const Formula& f) {
  return variables(f).empty();
}

}  // namespace seam::symbolic
