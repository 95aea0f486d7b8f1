// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The vertex of a known mesh that is on the same edge of the grid as another mesh's vertex [MAP-30].
#pragma once

#include <cstdint>
#include <limits>

namespace deltamesh {

/// In place of its number: there is none.
inline constexpr std::uint32_t kNoKnownVertex = std::numeric_limits<std::uint32_t>::max();

}  // namespace deltamesh
