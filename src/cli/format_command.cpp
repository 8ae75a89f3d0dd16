// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/outputs.h"

namespace seam::cli {
namespace fs = std::filesystem;

int format_files(const std::vector<std::string>& files, bool in_place) {
  for (const fs::path& file : seam_files(files)) {
    const std::string text = claims::format(parsed(file));
    if (in_place)
      write(file, text);
    else
      std::cout << text;
  }
  return ok;
}

}  // namespace seam::cli
