// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "claims/meaning.h"
#include "text/source.h"

namespace seam::cli {

/// Exit statuses of docs/command-line.md, from sysexits.
enum Exit {
  ok = 0,
  alarm = 3,
  usage = 64,
  bad_file = 65,
  missing_input = 66,
  internal = 70,
  io_error = 74
};

/// A command ends with this status; the message goes to standard error.
struct Failure {
  int status;
  std::string message;
  std::vector<text::Diagnostic> errors = {};  ///< of a file: what `message` says, one by one
};

/// The file's bytes under the name it was asked for. Throws `Failure` (66) if it cannot be
/// read.
std::shared_ptr<const text::Source> open(const std::filesystem::path&);

/// Opens files at or below the folder of `file` only.
claims::Opener opener_beside(const std::filesystem::path& file);

/// The .seam files among the arguments and in the folders among them, sorted within each
/// folder.
std::vector<std::filesystem::path> seam_files(const std::vector<std::string>& arguments);

/// Parsed; all errors rendered into a `Failure` (65).
claims::File parsed(const std::filesystem::path&);

/// Parsed and given meaning; all errors rendered into a `Failure` (65).
claims::Meaning meant(const std::filesystem::path&, const claims::Limits&);

}  // namespace seam::cli
