// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes may stand in a file: reading it ends with a tree or with messages, and what was
// read without a message has a canonical layout that reads back as itself.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>

#include "claims/syntax.h"

using namespace seam;

namespace {

claims::Parsed parse(std::string bytes) {
  return claims::parse(
      std::make_shared<const text::Source>(text::Source{"fuzz.seam", std::move(bytes)}));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const claims::Parsed parsed = parse({reinterpret_cast<const char*>(data), size});
  for (const text::Diagnostic& error : parsed.errors) (void)text::render(error);
  if (!parsed.errors.empty()) return 0;

  const std::string once = claims::format(parsed.file);
  const claims::Parsed again = parse(once);
  if (!again.errors.empty() || claims::format(again.file) != once) std::abort();
  return 0;
}
