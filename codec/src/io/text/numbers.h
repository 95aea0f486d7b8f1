// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers to and from text, independent of the locale.
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace deltamesh {

/// The whole of `text` as a decimal number, "nan" or "inf", with or without a sign. Nothing where it is not
/// one, or does not fit a double.
inline std::optional<double> parse_number(std::string_view text) noexcept {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Appends the shortest text that reads back to the same value.
template <class T>
void append_number(std::string& out, T value) {
  char digits[32];  // shortest double: at most 24 characters; 64-bit integer: 20
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  static_cast<void>(error);
  out.append(digits, end);
}

}  // namespace deltamesh
