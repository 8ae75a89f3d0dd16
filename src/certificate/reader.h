// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "certificate/layout.h"

namespace seam::certificate {

/// A place in a JSON document, and what is expected there: whatever is not as expected throws
/// `FormatError` with the path to the place.
class Reader {
 public:
  explicit Reader(const Json& value) : value_(&value) {}

  int integer() const;
  bool truth() const;
  std::string text() const;

  bool is_integer() const { return value_->is_number_integer(); }
  bool is_text() const { return value_->is_string(); }
  bool has(const char* member) const;

  /// The object's members are these and no others.
  void members(std::initializer_list<std::string_view> names) const;
  Reader operator[](const char* member) const;
  /// The name of an object's only member.
  std::string only_member() const;

  /// read_entry(Reader) for every entry of an array.
  template <typename Read>
  auto list(const Read& read_entry) const {
    std::vector<std::invoke_result_t<Read, Reader>> entries;
    const std::size_t count = size();
    entries.reserve(count);
    for (std::size_t i = 0; i < count; ++i) entries.push_back(read_entry(entry(i)));
    return entries;
  }
  std::vector<int> integers() const;
  std::vector<std::string> texts() const;

  [[noreturn]] void fail(std::string_view expected) const;

 private:
  Reader(const Json& value, const Reader& parent, const char* member, std::size_t index)
      : value_(&value), parent_(&parent), member_(member), index_(index) {}

  std::size_t size() const;
  Reader entry(std::size_t index) const;
  std::string path() const;

  const Json* value_;
  const Reader* parent_ = nullptr;  // outlives this one
  const char* member_ = nullptr;    // in an object; none in an array
  std::size_t index_ = 0;
};

}  // namespace seam::certificate
