// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/text/scanner.h"

#include "base/with_found.h"
#include "io/text/numbers.h"

namespace deltamesh {
namespace {

constexpr bool is_line_end(char c) noexcept { return c == '\n' || c == '\r'; }
constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

TextScanner::TextScanner(std::string_view text, Syntax syntax, std::uint64_t first_line) noexcept
    : text_(text), line_(first_line), syntax_(syntax) {
  if (first_line == 1 && text_.starts_with(kByteOrderMark)) position_ = kByteOrderMark.size();
}

/// Whether a backslash here joins this line with the next.
bool TextScanner::is_joint() const noexcept {
  return syntax_.joined_lines && text_[position_] == '\\' && position_ + 1 < text_.size() &&
         is_line_end(text_[position_ + 1]);
}

void TextScanner::skip_blanks(bool across_lines) noexcept {
  const auto to_line_end = [this] {
    while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
  };
  bool joined = false;
  for (; position_ < text_.size(); ++position_) {
    if (syntax_.hash_comments && text_[position_] == '#') {
      to_line_end();
      if (position_ == text_.size()) return;
    }
    const char c = text_[position_];
    if (is_blank(c)) continue;
    if (is_joint()) {
      joined = true;
      continue;
    }
    if (!is_line_end(c) || !(across_lines || joined)) return;
    // CR LF counts once, at its LF.
    const bool pair = c == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
    if (pair) continue;
    ++line_;
    joined = false;
  }
}

std::string_view TextScanner::take_token() noexcept {
  const std::size_t start = position_;
  while (position_ < text_.size() && !is_line_end(text_[position_]) && !is_blank(text_[position_]) &&
         !is_joint())
    ++position_;
  return text_.substr(start, position_ - start);
}

std::string_view TextScanner::next_token() noexcept {
  skip_blanks(true);
  return take_token();
}

std::string_view TextScanner::next_token_on_line() noexcept {
  skip_blanks(false);
  return take_token();
}

Result<double> TextScanner::read_number() noexcept {
  const std::string_view token = next_token();
  if (token.empty()) return error("the file ends where a number is expected");
  const auto value = parse_number(token);
  if (!value) return error("not a number, or one that does not fit a double", token);
  return *value;
}

Result<std::uint64_t> TextScanner::read_count(std::uint64_t max) noexcept {
  const std::string_view token = next_token();
  if (token.empty()) return error("the file ends where an integer is expected");
  const auto value = parse_integer(token);
  if (!value || *value < 0 || static_cast<std::uint64_t>(*value) > max)
    return error("not an integer, or out of range", token);
  return static_cast<std::uint64_t>(*value);
}

Result<void> TextScanner::end_line(const char* message) noexcept {
  const std::string_view token = next_token_on_line();
  if (!token.empty()) return error(message, token);
  return {};
}

Error TextScanner::error(const char* message, std::string_view found) const noexcept {
  return with_found(invalid_line(message, line_), found);
}

}  // namespace deltamesh
