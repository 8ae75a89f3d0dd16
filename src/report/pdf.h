// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "report/file.h"

namespace seam::report {

/// Typesets `folder/name.tex` to `folder/name.pdf` with pdflatex, without shell escape and in a
/// folder of its own, so that nothing else is left behind. The same input gives the same bytes.
/// On an error, what pdflatex says of it; an earlier PDF then stays as it was.
[[nodiscard]] std::optional<FileError> typeset(const std::filesystem::path& tex);

/// The same of a document that is in no file.
[[nodiscard]] std::optional<FileError> typeset(const std::string& document,
                                               const std::filesystem::path& pdf);

}  // namespace seam::report
