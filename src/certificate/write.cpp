// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "certificate/json.h"
#include "certificate/sha256.h"
#include "certificate/to_json.h"

namespace seam::certificate {
namespace {

// Strings that are not UTF-8 have no text.
std::string dumped(const Json& value, bool for_people) {
  try {
    return for_people ? laid_out(value) : value.dump();
  } catch (const Json::exception& error) {
    throw FormatError(error.what());
  }
}

}  // namespace

std::string write(const Certificate& certificate) {
  return dumped(to_json(certificate), true);
}

std::string digest(const Statement& statement) {
  return sha256(dumped(to_json(statement), false));
}

}  // namespace seam::certificate
