// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "report/run.h"

namespace seam::report {

/// Why a text is no run.
struct JsonError {
  std::string where;    ///< `files[0].claims[3].line`, or `byte 17`; empty: the document
  std::string message;  ///< `expected a text`
  std::string hint;     ///< may be empty
};

/// Reads what `json` writes; json(read_json(json(run))) == json(run). Any bytes may be passed
/// in. Of a run that is returned, all indices and lengths fit. Counts, summaries and
/// `as_expected` are not read but follow from the rest; times and paths are not there.
std::variant<Run, JsonError> read_json(std::string_view bytes);

}  // namespace seam::report
