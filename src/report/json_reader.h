// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "report/json_fields.h"
#include "report/json_words.h"
#include "report/read_json.h"

namespace seam::report {

/// A value of a document and where it stands. Whatever is not as expected throws `JsonError`.
class JsonReader {
 public:
  using Json = nlohmann::ordered_json;

  JsonReader(const Json& json, std::string where) : json_(&json), where_(std::move(where)) {}

  [[noreturn]] void fail(std::string message, std::string hint = {}) const {
    throw JsonError{where_, std::move(message), std::move(hint)};
  }

  bool has(const char* key) const {
    demand(json_->is_object(), "an object");
    return json_->contains(key);
  }
  JsonReader at(const char* key) const {
    if (!has(key)) fail("'" + std::string(key) + "' is missing", "written by another version?");
    return {(*json_)[key], where_.empty() ? key : where_ + "." + key};
  }
  std::vector<JsonReader> list(const char* key) const { return at(key).list(); }
  std::vector<JsonReader> list() const {
    demand(json_->is_array(), "a list");
    std::vector<JsonReader> entries;
    for (std::size_t i = 0; i < json_->size(); ++i)
      entries.push_back({(*json_)[i], where_ + "[" + std::to_string(i) + "]"});
    return entries;
  }

  /// A text, or nothing for null.
  std::string text(const char* key) const {
    const JsonReader entry = at(key);
    if (entry.json_->is_null()) return {};
    std::string result;
    entry.read(result);
    return result;
  }

  /// A field, which keeps its value if it is not there.
  template <typename T>
  void operator()(const char* key, T& field) const {
    if (has(key)) at(key).read(field);
  }

  template <typename T>
  void read(T& field) const {
    if constexpr (std::is_same_v<T, bool>) {
      demand(json_->is_boolean(), "true or false");
      field = json_->template get<bool>();
    } else if constexpr (std::is_same_v<T, int>) {
      demand(json_->is_number_integer() && *json_ >= 0 &&
                 *json_ <= std::numeric_limits<int>::max(),
             "a whole number from 0 on");
      field = json_->template get<int>();
    } else if constexpr (std::is_same_v<T, double>) {
      demand(json_->is_number() || json_->is_null(), "a number");
      field = json_->is_null() ? std::numeric_limits<double>::quiet_NaN()
                               : json_->template get<double>();
    } else if constexpr (std::is_same_v<T, std::string>) {
      demand(json_->is_string(), "a text");
      field = json_->template get<std::string>();
    } else if constexpr (std::is_enum_v<T>) {
      read_word(field);
    } else if constexpr (requires { field.push_back({}); }) {
      for (const JsonReader& entry : list()) entry.read(field.emplace_back());
    } else if constexpr (requires { field.fill({}); }) {
      const auto entries = list();
      demand(entries.size() == field.size(), "a list of " + std::to_string(field.size()));
      for (std::size_t i = 0; i < entries.size(); ++i) entries[i].read(field[i]);
    } else {
      demand(json_->is_object(), "an object");
      fields(*this, field);
    }
  }

 private:
  void demand(bool is_so, const std::string& what) const {
    if (!is_so) fail("expected " + what);
  }

  template <typename T>
  void read_word(T& field) const {
    std::string word;
    read(word);
    const auto all = words(field);
    const auto* const found = std::ranges::find(all, word);
    if (found == all.end()) {
      std::string hint = "one of";
      for (const std::string_view known : all) hint += " " + std::string(known);
      fail("'" + word + "' is not known here", hint);
    }
    field = static_cast<T>(found - all.begin());
  }

  const Json* json_;
  std::string where_;
};

}  // namespace seam::report
