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
constexpr std::array<const char*, 7> kUnits{"",          "byte ",      "line ",   "vertex ",
                                            "triangle ", "attribute ", "element "};

/// In quotes; bytes that a terminal may not show as they are become '?'.
std::string quoted(std::string_view bytes) {
  std::string text = "'";
  for (const char c : bytes) text += c >= ' ' && c <= '~' ? c : '?';
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
  if (error.where_kind != WhereKind::kNone)
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
