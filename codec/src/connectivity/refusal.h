// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Why a reader's traversal did not end.
#pragma once

#include "base/broken_rule.h"
#include "connectivity/border.h"
#include "deltamesh/result.h"
#include "format/tags.h"

namespace deltamesh {

/// What is wrong with a stream, and the rule that it breaks.
struct Refusal {
  const char* message;
  const char* rule;

  Error error() const noexcept { return broken_rule(message, rule, kTagConnectivity); }
};

/// Where the guide had a step, and the border did not take it.
inline Refusal refusal_of(const Border& border) noexcept {
  if (border.is_full()) return {"more faces than declared", "CONN-2"};
  return {"op does not fit the border", "CONN-7"};
}

}  // namespace deltamesh
