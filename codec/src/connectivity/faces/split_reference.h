// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How an S op names its target: by a few steps along the loop where that reaches, else by the item's number
// [CONN-10]. The bound on these keeps hostile streams linear.
#pragma once

#include <cstdint>

#include "connectivity/faces/border.h"
#include "connectivity/faces/cut.h"

namespace deltamesh {

/// References 1, 3, 5 ... go 2, 3, 4 ... items forward from the gate, 2, 4, 6 ... go 1, 2, 3 ... items
/// back.
inline constexpr std::uint32_t kFarReference = 0;
inline constexpr std::uint32_t kLargestReference = 255;

/// The item that a reference from 1 to kLargestReference names. At most 129 steps.
inline std::uint32_t follow_reference(const Border& border, std::uint32_t gate, std::uint32_t reference) {
  std::uint32_t i = gate;
  if (reference % 2 == 0) {
    for (std::uint32_t steps = reference / 2; steps > 0; --steps) i = border.item(i).previous;
  } else {
    for (std::uint32_t steps = (reference + 3) / 2; steps > 0; --steps) i = border.item(i).next;
  }
  return i;
}

/// The smallest reference to `target`, or kFarReference. At most 258 steps.
inline std::uint32_t find_reference(const Border& border, std::uint32_t gate, std::uint32_t target) {
  std::uint32_t forward = border.item(gate).next;
  std::uint32_t backward = gate;
  for (std::uint32_t reference = 1; reference <= kLargestReference; ++reference) {
    std::uint32_t& i = reference % 2 == 0 ? backward : forward;
    i = reference % 2 == 0 ? border.item(i).previous : border.item(i).next;
    if (i == target) return reference;
  }
  return kFarReference;
}

}  // namespace deltamesh
