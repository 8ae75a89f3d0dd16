// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// A claim as an `article`, its obligations and evidence folded away.
std::string html_claim(const ClaimRun&);

/// A printed table with a mark in each cell that leads to the claim of the cell, and those
/// claims.
std::string html_table(const TableRun&);

/// A question with its certified answer.
std::string html_ask(const AskRun&);

}  // namespace seam::report
