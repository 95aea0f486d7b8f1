// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers to and from text, independent of the locale.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace deltamesh {

/// The whole of `text` as a decimal number, "nan" or "inf", with or without a sign; what is too small for a
/// double is 0. Nothing where it is not a number, or too large for a double.
std::optional<double> parse_number(std::string_view text) noexcept;

/// The whole of `text` as an integer of 64 bits, which may have a minus in front.
std::optional<std::int64_t> parse_integer(std::string_view text) noexcept;

/// Appends the shortest text that reads back to the same value.
template <class T>
void append_number(std::string& out, T value) {
  char digits[32];  // shortest double: at most 24 characters; 64-bit integer: 20
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  static_cast<void>(error);
  out.append(digits, end);
}

}  // namespace deltamesh
