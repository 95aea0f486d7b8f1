// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The border between internals, whose containers may throw, and the public interface, which does not.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "deltamesh/result.h"

namespace deltamesh {

/// Thrown where a caller's function throws.
struct CallbackFailed {};

/// Calls a caller's function. Errors that it throws are the caller's: guarded() returns kInvalidArgument.
template <class Callback, class... Arguments>
decltype(auto) call_back(const Callback& callback, Arguments&&... arguments) {
  try {
    return callback(std::forward<Arguments>(arguments)...);
  } catch (...) {
    throw CallbackFailed();
  }
}

/// Calls `body` and turns a failed allocation into kOutOfMemory with `message`, and whatever else a library
/// below may throw into kInternal.
template <class Body>
auto guarded(Body&& body, const char* message = "out of memory") noexcept -> decltype(body()) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  } catch (const CallbackFailed&) {
    return Error{.code = ErrorCode::kInvalidArgument, .message = "a callback threw an exception"};
  } catch (const std::exception&) {
    return Error{.code = ErrorCode::kInternal, .message = "an exception that should not be"};
  }
  return Error{.code = ErrorCode::kOutOfMemory, .message = message};
}

}  // namespace deltamesh
