// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/style.h"

#include "embedded/report_preamble.h"
#include "embedded/seamproof_sty.h"

namespace seam::report {

const std::string_view style = embedded::seamproof_sty;
const std::string_view preamble = embedded::report_preamble;

}  // namespace seam::report
