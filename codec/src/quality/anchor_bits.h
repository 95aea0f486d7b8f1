// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How finely anchors must be coded, and how many there are at first.
#pragma once

#include <cstdint>

#include "quality/bounds.h"
#include "quality/trial.h"

namespace deltamesh {

/// Bits per axis, `least` to 24, at which the anchors' own rounding uses up only a part of each bound.
int anchor_bits_for(const Bounds& bounds, int least, TrialCoder& coder);

/// One for 500 solved vertices, at least one per component: with fewer, what is saved is under 0.1 bits per
/// vertex.
std::uint32_t usual_anchors(TrialCoder& coder);

}  // namespace deltamesh
