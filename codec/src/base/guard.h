// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The border between internals, whose containers may throw, and the public interface, which does not.
#pragma once

#include <new>
#include <stdexcept>

#include "deltamesh/result.h"

namespace deltamesh {

/// Calls `body` and turns a failed allocation into kOutOfMemory with `message`.
template <class Body>
auto guarded(Body&& body, const char* message = "out of memory") noexcept -> decltype(body()) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return Error{.code = ErrorCode::kOutOfMemory, .message = message};
}

}  // namespace deltamesh
