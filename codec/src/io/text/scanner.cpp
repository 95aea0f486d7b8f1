// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/text/scanner.h"

#include <charconv>

#include "io/text/numbers.h"

namespace deltamesh {
namespace {

constexpr bool is_line_end(char c) noexcept { return c == '\n' || c == '\r'; }
constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

void TextScanner::skip_line() noexcept {
  while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
}

void TextScanner::skip_blanks(bool across_lines) noexcept {
  for (; position_ < text_.size(); ++position_) {
    const char c = text_[position_];
    if (hash_comments_ && c == '#') {
      skip_line();
      if (position_ == text_.size()) return;
    }
    const char now = text_[position_];
    if (is_blank(now)) continue;
    if (!across_lines || !is_line_end(now)) return;
    // CR LF counts once, at its LF.
    const bool pair = now == '\r' && position_ + 1 < text_.size() && text_[position_ + 1] == '\n';
    if (!pair) ++line_;
  }
}

std::string_view TextScanner::take_token() noexcept {
  const std::size_t start = position_;
  while (position_ < text_.size() && !is_line_end(text_[position_]) && !is_blank(text_[position_]) &&
         !(hash_comments_ && text_[position_] == '#'))
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
  if (!value) return error("not a number, or one that does not fit a double");
  return *value;
}

Result<std::uint64_t> TextScanner::read_count(std::uint64_t max) noexcept {
  const std::string_view token = next_token();
  if (token.empty()) return error("the file ends where an integer is expected");
  std::uint64_t value = 0;
  const auto [end, failure] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (failure != std::errc{} || end != token.data() + token.size() || value > max)
    return error("not an integer, or out of range");
  return value;
}

}  // namespace deltamesh
