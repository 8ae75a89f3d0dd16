// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/libraries.h"

#include <mpfr.h>

#include "exact/flint.h"

namespace seam::exact {

std::vector<std::string> libraries() {
  return {std::string("FLINT ") + flint_version, std::string("Arb ") + arb_version,
          std::string("GMP ") + gmp_version, std::string("MPFR ") + mpfr_get_version()};
}

}  // namespace seam::exact
