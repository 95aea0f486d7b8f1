// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors of the importers: all are kInvalidFile, with a place.
#pragma once

#include <cstdint>

#include "deltamesh/result.h"

namespace deltamesh {

constexpr Error invalid_file(const char* message, WhereKind kind = WhereKind::kNone,
                             std::uint64_t where = 0) noexcept {
  return {.code = ErrorCode::kInvalidFile, .message = message, .where_kind = kind, .where = where};
}
/// `line` counts from 1.
constexpr Error invalid_line(const char* message, std::uint64_t line) noexcept {
  return invalid_file(message, WhereKind::kLine, line);
}
constexpr Error invalid_byte(const char* message, std::uint64_t byte) noexcept {
  return invalid_file(message, WhereKind::kByte, byte);
}

}  // namespace deltamesh
