// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/library.h"

#include <boost/version.hpp>

namespace seam::check {

std::string library() {
  return "Boost " + std::to_string(BOOST_VERSION / 100000) + "." +
         std::to_string(BOOST_VERSION / 100 % 1000) + "." + std::to_string(BOOST_VERSION % 100);
}

}  // namespace seam::check
