// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The vertex of a known mesh that is on the same edge of the grid as another mesh's vertex [MAP-30].
#pragma once

#include <cstdint>
#include <limits>

namespace deltamesh {

struct KnownVertex {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t row = kNone;  ///< in the known mesh
  bool stays = false;         ///< a face that stays has it
};

}  // namespace deltamesh
