// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/outputs.h"

namespace seam::cli {
namespace fs = std::filesystem;

int start_file(const std::string& name) {
  const fs::path path =
      fs::path(name).extension() == ".seam" ? fs::path(name) : fs::path(name + ".seam");
  if (fs::exists(path)) throw Failure{usage, "'" + path.string() + "' exists already\n"};
  write(path, R"(# A paper's mathematics: definitions first, then its claims.
paper "Title of the paper" by "Its authors"

section "1  An example"

# Numbers are exact: the golden ratio, not a decimal.
let phi = (1 + sqrt(5))/2

claim golden.square "the golden ratio solves x^2 = x + 1" at "p. 1":
    phi^2 = phi + 1

claim golden.digits "its printed digits are rounded correctly" at "p. 1":
    phi ~ 1.618

# A cubic triangle patch, its control points printed in rows.
let p = triangle_patch [
    (0,0,3), (0,2,3), (0,3,2), (0,3,0);
    (2,0,3), (3,3,3), (2,3,0);
    (3,0,2), (3,2,0);
    (3,0,0) ]

claim patch.regular "it has a tangent plane everywhere" at "§1":
    regular(p)
)");
  std::cout << path.string() << "\n";
  return ok;
}

}  // namespace seam::cli
