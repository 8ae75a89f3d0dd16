// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "certificate/layout.h"

namespace seam::tampered {

using certificate::Json;

/// One change at one place of a certificate.
struct Change {
  std::string kind;          ///< what is done, such as "element dropped"
  std::string part;          ///< where: the kind of the obligation, or nodes, generators ...
  Json::json_pointer place;  ///< the value that is changed
  std::function<void(Json&)> apply;
};

/// All changes of the verdict, the statement and the evidence of a certificate, in their order.
std::vector<Change> changes(const Json& certificate);

}  // namespace seam::tampered
