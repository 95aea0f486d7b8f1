// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Ranges of SplitOptions.
#pragma once

#include "deltamesh/map/split.h"
#include "deltamesh/result.h"

namespace deltamesh {

inline Result<void> check_options(const SplitOptions& options) noexcept {
  if (options.most_triangles == 0)
    return Error{.code = ErrorCode::kInvalidArgument, .message = "parts of no triangles"};
  if (options.most_level > kMostPartLevel || options.copy_level > kMostPartLevel)
    return Error{
        .code = ErrorCode::kInvalidArgument, .message = "a level of parts above 24", .rule = "MAP-3"};
  return {};
}

}  // namespace deltamesh
