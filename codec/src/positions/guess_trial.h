// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whether coordinates are so often one of their guesses that these pay. Encoder only.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "positions/blend/blend.h"

namespace deltamesh {

/// `cells`: all vertices of `faces`, of which some 1000 are looked at; `largest`: the most that a coordinate
/// may be, per axis.
bool guesses_pay(const KnownFaces& faces, std::span<const Cell> cells,
                 const std::array<std::uint32_t, 3>& largest, const BlendTable& blends);

}  // namespace deltamesh
