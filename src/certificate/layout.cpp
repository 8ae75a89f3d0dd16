// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "certificate/layout.h"

namespace seam::certificate {
namespace {

constexpr std::size_t width = 96;
constexpr std::size_t short_entry = 32;  // so short ones share a line in a long list

// Appends `entry` on the current line if it fits there, else on a line of its own.
class Page {
 public:
  void print(const Json& value, std::size_t indent) {
    const std::string line = value.dump();
    if (!value.is_structured() || column() + line.size() < width) {
      text_ += line;
      return;
    }
    text_ += value.is_object() ? '{' : '[';
    bool is_first = true;
    bool was_short = false;
    for (const auto& [key, entry] : value.items()) {
      if (!is_first) text_ += ',';
      const std::string whole = entry.dump();
      const bool is_short = value.is_array() && whole.size() <= short_entry;
      if (is_short && was_short && column() + whole.size() + 2 < width)
        text_ += ' ';
      else
        break_line(indent + 1);
      if (value.is_object()) text_ += Json(key).dump() + ": ";
      print(entry, indent + 1);
      is_first = false;
      was_short = is_short;
    }
    break_line(indent);
    text_ += value.is_object() ? '}' : ']';
  }

  std::string text() && { return std::move(text_); }

 private:
  std::size_t column() const { return text_.size() - line_start_; }

  void break_line(std::size_t indent) {
    text_ += '\n';
    line_start_ = text_.size();
    text_.append(indent, ' ');
  }

  std::string text_;
  std::size_t line_start_ = 0;
};

}  // namespace

std::string laid_out(const Json& value) {
  Page page;
  page.print(value, 0);
  return std::move(page).text() + '\n';
}

}  // namespace seam::certificate
