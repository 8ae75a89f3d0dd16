// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

// For processes that branch off this one.
namespace seam::cli {

/// The exit status of one that was given too little memory.
inline constexpr int no_memory = 71;

/// From now on this process may have so many MiB more than it has, and says nothing.
void limit_memory(long mebibytes);

/// All of it, or the process ends.
void write_all(int to, std::string_view bytes);

}  // namespace seam::cli
