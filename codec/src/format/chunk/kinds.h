// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Kinds of chunks: the first byte of a chunk header [DIR-2, DIR-4].
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "format/chunk/tags.h"

namespace deltamesh {

/// The tags that a kind stands for, from kind 1 on [DIR-2].
inline constexpr std::array<std::uint32_t, 9> kKinds{kTagConnectivity, kTagSeams,   kTagFaceGroups,
                                                     kTagDeltas,       kTagAnchors, kTagPositions,
                                                     kTagAttribute,    kTagOrder,   kTagGrid};
inline constexpr unsigned kLetters = 0;  ///< the kind of all other tags, which follow it
inline constexpr unsigned kCodecShift = 4;
inline constexpr unsigned kKindMask = (1U << kCodecShift) - 1;

inline unsigned kind_of(std::uint32_t tag) noexcept {
  const auto* const found = std::find(kKinds.begin(), kKinds.end(), tag);
  return found == kKinds.end() ? kLetters : static_cast<unsigned>(found - kKinds.begin()) + 1;
}

}  // namespace deltamesh
