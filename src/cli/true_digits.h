// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "claims/named_numbers.h"
#include "cli/outcome.h"
#include "cli/verify.h"

namespace seam::cli {

/// The statement proved or refuted, and judged, within the time and effort of the options.
Decided decide(const claims::NamedNumbers::Statement&, const VerifyOptions&);

/// Digits that the checker confirmed, and by what.
struct CertifiedDigits {
  claims::PrintedNumber number;
  certificate::Statement statement;
  Decided decided;  ///< proven
};

/// What the named number is, with so many digits after the point; nothing unless the checker
/// confirmed it.
std::optional<CertifiedDigits> certified(claims::NamedNumbers&, const std::string& name,
                                         int places, bool truncated, const VerifyOptions&);

/// The true digits to each refuted claim that a number is printed so: those of its correction
/// where that is proven, else certified ones, with a certificate of their own.
void add_true_digits(Verified&, const claims::Meaning&, const std::filesystem::path& file,
                     const VerifyOptions&);

}  // namespace seam::cli
