// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A step of a sequence as an update of a sender's map.
#pragma once

#include <vector>

#include "deltamesh/map/sender.h"
#include "map/updates.h"
#include "support/errors.h"

namespace deltamesh::bench {

/// Ends the program where the sender refuses it.
inline void take_step(const SequenceStep& step, MapSender& sender) {
  const Mesh nothing;
  std::vector<MapBlock> blocks;
  for (const SequenceBlock& block : step.changed) blocks.push_back({block.id, block.mesh});
  for (const SequenceBlockId& id : step.removed) blocks.push_back({id, nothing});
  check_or_exit(sender.update(blocks));
}

}  // namespace deltamesh::bench
