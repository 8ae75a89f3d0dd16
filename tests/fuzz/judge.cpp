// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes may be fed to the checker: it answers, or the reader says that they are no
// certificate.

#include "check/judge.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "certificate/json.h"

using namespace seam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const certificate::Certificate certificate = certificate::read(bytes);
    (void)check::judge(certificate.statement, certificate.evidence, 1'000'000);
  } catch (const certificate::FormatError&) {
  }
  return 0;
}
