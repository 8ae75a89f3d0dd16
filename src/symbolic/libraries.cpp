// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/libraries.h"

#include <cln/version.h>
#include <ginac/ginac.h>

#include "exact/libraries.h"

namespace seam::symbolic {
namespace {

std::string version(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

std::vector<std::string> libraries() {
  std::vector<std::string> all = {
      "GiNaC " + version(GiNaC::version_major, GiNaC::version_minor, GiNaC::version_micro),
      "CLN " + version(cln::version_major, cln::version_minor, cln::version_patchlevel)};
  for (const std::string& library : exact::libraries()) all.push_back(library);
  return all;
}

}  // namespace seam::symbolic
