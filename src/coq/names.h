// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace seam::coq {

/// Letters, digits and `_` alone, with a letter first: `sqrt(5)` becomes `sqrt_5`. Different
/// texts may become the same.
std::string as_identifier(std::string_view);

/// Names for the symbols of one theorem, all different, none with another meaning in Coq.
class Names {
 public:
  /// The same for the same symbol.
  const std::string& of(const std::string& symbol);
  /// A name that is given to nothing else.
  std::string fresh(const std::string& wish);

 private:
  std::map<std::string, std::string> known_;
  std::set<std::string> taken_;
};

}  // namespace seam::coq
