// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>

// What words and characters of a LaTeX source mean to who reads it without expanding macros.
namespace seam::cli {

bool is_letter(char);  ///< of the name of a control word
bool is_digit(char);
bool is_blank(char);

bool among(const std::string& word, std::initializer_list<std::string_view> words);

/// An environment whose text is not read by TeX as usual.
bool is_verbatim(const std::string& environment);

/// Whether the control word that follows is given a meaning.
bool defines(const std::string& word);

/// A conditional of TeX itself, or one of those that `\newif` has made: it has a `\fi`.
bool is_conditional(const std::string& word, const std::set<std::string>& made);

/// A carriage return alone ends a line for TeX, too.
std::string with_line_ends(std::string text);

std::string trimmed(std::string text);

}  // namespace seam::cli
