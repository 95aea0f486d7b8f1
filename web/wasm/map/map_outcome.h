// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What `map` hands to JavaScript (packages/decoder/map.js), beside what is in outcome.h.
#pragma once

#include "outcome.h"

namespace deltamesh::web {

struct PartOutcome {
  double quality[3]{};  ///< VDE, LFE, largest error
  float box[6]{};       ///< relative to the map's origin
  std::uint32_t level = 0;
  std::int32_t cell[3]{};
  std::uint32_t revision[2]{};  ///< low, high
  std::uint32_t hash[2]{};
  std::uint32_t bytes = 0;
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t is_finest = 0;  ///< none of the map's other parts shows the same with more detail
};

struct MapOutcome {
  ErrorOutcome error;
  double origin[3]{};
  std::uint32_t part_count = 0;
  const PartOutcome* parts = nullptr;
};

struct KeyOutcome {
  std::uint32_t level = 0;
  std::int32_t cell[3]{};
};

/// What a receiver shows since the last time.
struct ChangeOutcome {
  std::uint32_t changed_count = 0;
  const KeyOutcome* changed = nullptr;
  std::uint32_t removed_count = 0;
  const KeyOutcome* removed = nullptr;
  std::uint32_t lacking = 0;  ///< parts that are announced and have not come
  std::uint32_t faults = 0;   ///< parts that the sender cannot send as the view asks
};

struct MessageOutcome {
  std::uint32_t bytes = 0;
  const std::byte* octets = nullptr;
};

struct MessagesOutcome {
  ErrorOutcome error;
  std::uint32_t count = 0;
  const MessageOutcome* messages = nullptr;
};

static_assert(sizeof(KeyOutcome) == 16 && sizeof(ChangeOutcome) == 24 &&
              offsetof(MessagesOutcome, count) == 32);
static_assert(sizeof(PartOutcome) == 96 && offsetof(MapOutcome, part_count) == 56);

}  // namespace deltamesh::web
