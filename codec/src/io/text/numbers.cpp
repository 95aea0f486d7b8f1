// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/text/numbers.h"

namespace deltamesh {
namespace {

/// Whether a number that no double holds is too small rather than too large, by the place of its first digit
/// that is not 0.
bool is_tiny(std::string_view number) noexcept {
  std::int64_t exponent = 0;
  if (const std::size_t e = number.find_first_of("eE"); e != number.npos) {
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    static_cast<void>(end);
    if (error != std::errc{}) return digits.starts_with('-');
    number = number.substr(0, e);
  }
  const std::size_t point = number.find('.');
  const std::size_t first = number.find_first_of("123456789");
  const auto place = static_cast<std::int64_t>(point == number.npos ? number.size() : point);
  return place - static_cast<std::int64_t>(first) + exponent < 0;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) noexcept {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc{}) return value;
  if (error != std::errc::result_out_of_range || !is_tiny(text)) return std::nullopt;
  return text.starts_with('-') ? -0.0 : 0.0;
}

std::optional<std::int64_t> parse_integer(std::string_view text) noexcept {
  std::int64_t value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace deltamesh
