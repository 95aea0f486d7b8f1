// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/text.h"

#include <cstdio>

namespace deltamesh::bench {
namespace {

std::string format(const char* pattern, int digits, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, digits, value);
  return text;
}

}  // namespace

std::string join(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text += piece;
  return text;
}

std::string number(std::uint64_t value) { return std::to_string(value); }

std::string fixed(double value, int digits) { return format("%.*f", digits, value); }

std::string significant(double value, int digits) { return format("%.*g", digits, value); }

double ratio(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}

}  // namespace deltamesh::bench
