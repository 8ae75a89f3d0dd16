// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "report/json_fields.h"
#include "report/json_words.h"

namespace seam::report {

using Json = nlohmann::ordered_json;

/// What is not UTF-8 is replaced, never a reason to fail.
Json json_text(const std::string&);
/// To 6 significant digits; null for what is no number.
Json json_number(double);

/// Writes fields into an object. What is empty, 0 or false is left out.
class JsonWriter {
 public:
  template <typename T>
  void operator()(const char* name, const T& field) {
    if constexpr (std::is_enum_v<T>)
      object[name] = value(field);
    else if (!is_nothing(field))
      object[name] = value(field);
  }

  template <typename T>
  static Json value(const T& field) {
    if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int>) {
      return field;
    } else if constexpr (std::is_same_v<T, double>) {
      return json_number(field);
    } else if constexpr (std::is_same_v<T, std::string>) {
      return json_text(field);
    } else if constexpr (std::is_enum_v<T>) {
      return words(field)[static_cast<std::size_t>(field)];
    } else if constexpr (requires { field.begin(); }) {
      Json list = Json::array();
      for (const auto& entry : field) list.push_back(value(entry));
      return list;
    } else {
      JsonWriter writer;
      fields(writer, field);
      return std::move(writer.object);
    }
  }

  Json object = Json::object();

 private:
  template <typename T>
  static bool is_nothing(const T& field) {
    if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int>)
      return field == T{};
    else
      return field.empty();
  }
};

}  // namespace seam::report
