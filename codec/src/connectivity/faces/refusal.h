// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Why a reader's traversal did not end.
#pragma once

#include "base/broken_rule.h"
#include "connectivity/faces/border.h"
#include "deltamesh/result.h"
#include "format/chunk/tags.h"

namespace deltamesh {

/// A fault in a stream and the rule that it breaks.
struct Refusal {
  const char* message;
  const char* rule;

  Error error() const noexcept { return broken_rule(message, rule, kTagConnectivity); }
};

/// The fault if the border rejected the guide's step.
inline Refusal refusal_of(const Border& border) noexcept {
  if (border.is_full()) return {"more faces than declared", "CONN-2"};
  return {"op does not fit the border", "CONN-7"};
}

}  // namespace deltamesh
