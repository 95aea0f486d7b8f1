// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/result.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <string_view>

namespace deltamesh {
namespace {

/// By WhereKind.
constexpr std::array<const char*, 9> kUnits{"",           "byte ",    "line ",     "vertex ", "triangle ",
                                            "attribute ", "element ", "accessor ", ""};

bool is_continuation(char c) noexcept { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

/// Bytes of the UTF-8 character that `bytes` begin with; 0 where that is none, or a control.
std::size_t shown_size(std::string_view bytes) noexcept {
  const auto first = static_cast<unsigned char>(bytes[0]);
  if (first < 0x80) return first >= ' ' && first <= '~' ? 1 : 0;
  const std::size_t size = first >= 0xf0 && first <= 0xf4 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || bytes.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if (!is_continuation(bytes[i])) return 0;
  const auto second = static_cast<unsigned char>(bytes[1]);
  const bool is_control = first == 0xc2 && second < 0xa0;
  const bool is_longer_than_needed = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  return is_control || is_longer_than_needed || is_no_character ? 0 : size;
}

/// In quotes; bytes that a terminal may not show as they are become '?'.
std::string quoted(std::string_view bytes) {
  std::string text = "'";
  while (!bytes.empty()) {
    const std::size_t size = shown_size(bytes);
    text += size > 0 ? bytes.substr(0, size) : "?";
    bytes.remove_prefix(size > 0 ? size : 1);
  }
  return text + "'";
}

/// Four significant digits.
std::string short_number(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  return text;
}

}  // namespace

std::string describe(const Error& error) {
  std::string text = error.message;
  if (error.found[0] != '\0') text += ": " + quoted(error.found.data());
  if (error.where_kind != WhereKind::kNone && error.where_kind != WhereKind::kPrimitive)
    text +=
        std::string(", ") + kUnits[static_cast<std::size_t>(error.where_kind)] + std::to_string(error.where);
  if (error.chunk_tag != 0) {
    text += ", chunk ";
    for (unsigned i = 0; i < 4; ++i) text += static_cast<char>((error.chunk_tag >> (8 * i)) & 0x7f);
  }
  if (error.best_value > 0) text += ", the best is " + short_number(error.best_value);
  if (error.best_bytes > 0)
    text += std::string(error.best_value > 0 ? " in " : ", the smallest found has ") +
            std::to_string(error.best_bytes) + " bytes";
  if (*error.rule != '\0') text += std::string(" [") + error.rule + "]";
  return text;
}

}  // namespace deltamesh
