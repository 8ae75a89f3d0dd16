// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "certificate/evidence.h"
#include "report/run.h"

namespace seam::cli {

/// Judges the certificates below a folder again, without the prover, and holds the verdicts of
/// a run to them. A verdict that its certificate does not bear out becomes `undecided` with an
/// alarm; a claim that rests on one so lost becomes conditional. Afterwards each verdict that
/// decides has a certificate that was judged, and each proven claim rests on proven ones alone.
///
/// Returns the certificates that could be read, by file name. That the statements in them say
/// what the text of the claims says is not looked at.
std::map<std::string, certificate::Certificate> judge_again(report::FileRun&,
                                                            const std::filesystem::path& folder,
                                                            int jobs);

}  // namespace seam::cli
