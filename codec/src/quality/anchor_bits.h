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

/// At least one per component; and one for so many solved vertices:
/// - 500 where only VDE is asked for: with fewer, what is saved is under 0.1 bits per vertex;
/// - 200 for an LFE, 50 for a maximum error: near what is best on open maps.
std::uint32_t usual_anchors(const Bounds& bounds, TrialCoder& coder);

}  // namespace deltamesh
