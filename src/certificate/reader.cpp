// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "certificate/reader.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "certificate/json.h"

namespace seam::certificate {

int Reader::integer() const {
  if (!value_->is_number_integer()) fail("an integer");
  const bool is_large = value_->is_number_unsigned() &&
                        value_->get<std::uint64_t>() > std::numeric_limits<int>::max();
  if (is_large || value_->get<std::int64_t>() < std::numeric_limits<int>::min())
    fail("an integer that is not so large");
  return value_->get<int>();
}

bool Reader::truth() const {
  if (!value_->is_boolean()) fail("true or false");
  return value_->get<bool>();
}

std::string Reader::text() const {
  if (!value_->is_string()) fail("a string");
  return value_->get<std::string>();
}

bool Reader::has(const char* member) const {
  return value_->is_object() && value_->contains(member);
}

void Reader::members(std::initializer_list<std::string_view> names) const {
  if (!value_->is_object()) fail("an object");
  for (const auto& [name, member] : value_->items())
    if (std::ranges::find(names, name) == names.end()) fail("no member '" + name + "'");
  for (const std::string_view name : names)
    if (!value_->contains(std::string(name))) fail("a member '" + std::string(name) + "'");
}

Reader Reader::operator[](const char* member) const {
  if (!has(member)) fail("a member '" + std::string(member) + "'");
  return {(*value_)[member], *this, member, 0};
}

std::string Reader::only_member() const {
  if (!value_->is_object() || value_->size() != 1) fail("an object with one member");
  return value_->items().begin().key();
}

std::vector<int> Reader::integers() const {
  return list([](const Reader& entry) { return entry.integer(); });
}

std::vector<std::string> Reader::texts() const {
  return list([](const Reader& entry) { return entry.text(); });
}

void Reader::fail(std::string_view expected) const {
  throw FormatError(path() + ": expected " + std::string(expected));
}

std::size_t Reader::size() const {
  if (!value_->is_array()) fail("an array");
  return value_->size();
}

Reader Reader::entry(std::size_t index) const {
  return {(*value_)[index], *this, nullptr, index};
}

std::string Reader::path() const {
  if (parent_ == nullptr) return "certificate";
  return parent_->path() +
         (member_ != nullptr ? '.' + std::string(member_) : '[' + std::to_string(index_) + ']');
}

}  // namespace seam::certificate
