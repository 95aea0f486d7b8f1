// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors that several sources of this library return.
#pragma once

#include <cstdint>

#include "deltamesh/result.h"

namespace deltamesh {

inline Error invalid_argument(const char* message, const char* rule = "") noexcept {
  return {.code = ErrorCode::kInvalidArgument, .message = message, .rule = rule};
}

inline Error invalid_mesh(const char* message, WhereKind kind = WhereKind::kNone,
                          std::uint64_t where = 0) noexcept {
  return {.code = ErrorCode::kInvalidMesh, .message = message, .where_kind = kind, .where = where};
}

inline Error broken_patch(const char* message) noexcept {
  return {.code = ErrorCode::kInvalidStream, .message = message, .rule = "MAP-17"};
}

}  // namespace deltamesh
