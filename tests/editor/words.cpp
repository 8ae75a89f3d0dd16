// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the words that the language brings along, `function gauss`, `predicate G1`,
// `part net`, one a line.
#include "claims/words.h"

#include <iostream>

#include "claims/evaluate.h"
#include "claims/stating.h"

int main() {
  for (const auto& name : seam::claims::builtin_names())
    std::cout << "function " << name << "\n";
  for (const auto& name : seam::claims::predicate_names())
    std::cout << "predicate " << name << "\n";
  for (const auto& name : seam::claims::figure_parts()) std::cout << "part " << name << "\n";
}
