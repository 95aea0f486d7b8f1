// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The error of a coded payload, whose fault lies at no byte.
#pragma once

#include <cstdint>

#include "deltamesh/result.h"

namespace deltamesh {

/// kInvalidStream: what was decoded of the chunk with `chunk_tag` breaks `rule`. A function of its own, as
/// such errors are made in many places and seldom.
[[gnu::noinline]] inline Error broken_rule(const char* message, const char* rule,
                                           std::uint32_t chunk_tag) noexcept {
  return {.code = ErrorCode::kInvalidStream, .message = message, .rule = rule, .chunk_tag = chunk_tag};
}

}  // namespace deltamesh
