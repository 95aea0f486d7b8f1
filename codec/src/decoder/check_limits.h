// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a caller is willing to receive.
#pragma once

#include "deltamesh/decode.h"
#include "deltamesh/result.h"
#include "format/header.h"

namespace deltamesh {

/// Errors: kLimitExceeded.
Result<void> check_limits(const FileHeader& header, const DecodeLimits& limits) noexcept;

}  // namespace deltamesh
