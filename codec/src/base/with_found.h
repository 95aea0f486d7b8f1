// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Errors that show the text or the name at fault.
#pragma once

#include <algorithm>
#include <string_view>

#include "deltamesh/result.h"

namespace deltamesh {

/// `found`: cut where there is no room. Precondition: `error` shows nothing yet.
inline Error with_found(Error error, std::string_view found) noexcept {
  std::copy_n(found.begin(), std::min(found.size(), error.found.size() - 1), error.found.begin());
  return error;
}

}  // namespace deltamesh
