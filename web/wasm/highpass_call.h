// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What `core` hands to `highpass`, whose memory is another. Both are built alike, so structures are copied as
// they are.
#pragma once

#include <cstdint>

#include "base/vec3.h"
#include "format/highpass_parameters.h"
#include "outcome.h"

namespace deltamesh::web {

/// In the memory of `highpass`, which releases it.
struct HandedArray {
  std::uint32_t address = 0;
  std::uint32_t bytes = 0;
};

/// The arguments of read_highpass().
struct HighpassCall {
  Box box;
  HighpassParameters parameters;
  HandedArray deltas;
  HandedArray anchors;
  std::uint32_t deltas_are_compact = 0;
  std::uint32_t anchors_are_compact = 0;
  HandedArray offsets;
  HandedArray neighbors;
  HandedArray labels;
  HandedArray sizes;
};

struct HighpassOutcome {
  ErrorOutcome error;
  const Vec3* positions = nullptr;  ///< one for every vertex
};

}  // namespace deltamesh::web
