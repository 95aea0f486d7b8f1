// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "decoder/check_limits.h"

namespace deltamesh {
namespace {

Error limit_exceeded(const char* message) noexcept {
  return {.code = ErrorCode::kLimitExceeded, .message = message};
}

}  // namespace

Result<void> check_limits(const FileHeader& header, const DecodeLimits& limits) noexcept {
  if (header.vertices > limits.vertices) return limit_exceeded("more vertices than the caller's limit");
  if (header.triangles > limits.triangles) return limit_exceeded("more triangles than the caller's limit");
  if (header.attributes.size() > limits.attributes)
    return limit_exceeded("more attributes than the caller's limit");
  return {};
}

}  // namespace deltamesh
