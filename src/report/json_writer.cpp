// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_writer.h"

#include <array>
#include <charconv>
#include <cmath>

#include "text/utf8.h"

namespace seam::report {

Json json_text(const std::string& text) {
  if (!text::invalid_utf8(text)) return text;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace));
}

Json json_number(double number) {
  if (!std::isfinite(number)) return nullptr;
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                     std::chars_format::general, 6);
  double rounded = 0;
  std::from_chars(digits.data(), written.ptr, rounded);
  return rounded == 0 ? 0.0 : rounded;
}

}  // namespace seam::report
