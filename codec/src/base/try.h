// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Propagation of errors, and the check for what cannot happen.
#pragma once

#include <cstdlib>
#include <utility>

#include "deltamesh/result.h"

#define DELTAMESH_CONCAT_INNER(a, b) a##b
#define DELTAMESH_CONCAT(a, b) DELTAMESH_CONCAT_INNER(a, b)

/// `DELTAMESH_TRY(auto x, f())`: x takes the value of f(), or the calling function returns its error.
#define DELTAMESH_TRY(declaration, expression) \
  DELTAMESH_TRY_IMPL(DELTAMESH_CONCAT(deltamesh_result_, __LINE__), declaration, expression)
#define DELTAMESH_TRY_IMPL(result, declaration, expression) \
  auto result = (expression);                               \
  if (!result) return result.error();                       \
  declaration = *std::move(result)

/// The same for Result<void>.
#define DELTAMESH_CHECK(expression)                                                                  \
  do {                                                                                               \
    if (auto deltamesh_checked = (expression); !deltamesh_checked) return deltamesh_checked.error(); \
  } while (false)

/// For what cannot happen: stops in debug and fuzz builds, returns kInternal in release builds.
#ifdef NDEBUG
#define DELTAMESH_ENSURE(condition)                                        \
  do {                                                                     \
    if (!(condition))                                                      \
      return ::deltamesh::Error{.code = ::deltamesh::ErrorCode::kInternal, \
                                .message = "failed: " #condition};         \
  } while (false)
#else
#define DELTAMESH_ENSURE(condition) \
  do {                              \
    if (!(condition)) std::abort(); \
  } while (false)
#endif
