// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <nettle/sha2.h>

#include <array>
#include <cstdint>

#include "certificate/json.h"
#include "certificate/to_json.h"

namespace seam::certificate {
namespace {

std::string hexadecimal(const std::array<std::uint8_t, SHA256_DIGEST_SIZE>& bytes) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

// Strings that are not UTF-8 have no text.
std::string dumped(const Json& value, bool for_people) {
  try {
    return for_people ? laid_out(value) : value.dump();
  } catch (const Json::exception& error) {
    throw FormatError(error.what());
  }
}

}  // namespace

std::string write(const Certificate& certificate) {
  return dumped(to_json(certificate), true);
}

std::string digest(const Statement& statement) {
  const std::string text = dumped(to_json(statement), false);
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes{};
  sha256_digest(&context, bytes.size(), bytes.data());
  return hexadecimal(bytes);
}

}  // namespace seam::certificate
