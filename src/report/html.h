// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// A finished run as one HTML page that needs no other file and no network: it says so to the
/// browser, which then refuses both. Everything can be read without scripts; they add a search,
/// filters, keys and figures that turn. Well-formed XML, too. Equal runs give equal bytes.
std::string html(const Run&);

}  // namespace seam::report
