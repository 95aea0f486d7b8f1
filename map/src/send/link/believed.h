// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a sender believes that a receiver has of a part.
#pragma once

#include <cstdint>
#include <vector>

#include "deltamesh/map/part_key.h"

namespace deltamesh {

/// A version, or that the part is gone.
struct Believed {
  enum class Stage : std::uint8_t {
    kSent,     ///< its message is on the way
    kArrived,  ///< its message has come; perhaps it waits for an earlier one
    kTold,     ///< the receiver says in a view that it has it
  };

  std::uint64_t revision = 0;
  std::uint64_t since = 0;  ///< the first revision with these octets, as far as it is known
  std::uint32_t version = 0;
  Stage stage = Stage::kTold;
  bool is_waiting = false;          ///< the receiver has told that it does not show it
  bool is_gone = false;             ///< its removal was sent
  std::vector<PartKey> in_place{};  ///< what that removal waits for
  std::uint64_t number = 0;         ///< of its message; 0: the receiver told of it
  PartKey base{};                   ///< of the part that the message is a patch of; else its own
};

}  // namespace deltamesh
