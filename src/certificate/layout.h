// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace seam::certificate {

using Json = nlohmann::ordered_json;

/// A JSON document for people: what fits on a line stands on one, the rest is broken at its
/// outermost brackets; ends with a newline. Depends on the value alone.
std::string laid_out(const Json& value);

}  // namespace seam::certificate
