// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a peer says that refuses a mesh or a stream.
#pragma once

#include "deltamesh/result.h"

namespace deltamesh::bench {

inline Error failure(const char* message) noexcept {
  return {.code = ErrorCode::kInternal, .message = message};
}

}  // namespace deltamesh::bench
