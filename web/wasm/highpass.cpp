// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The solver's exports.
#include "highpass/highpass.h"

#include <utility>

#include "part.h"

namespace deltamesh::web {

DELTAMESH_EXPORT(read_highpass)
Result<LargeVector<Vec3>> read_highpass_here(Payload deltas, Payload anchors, Adjacency& graph,
                                             Components& components, const Box& box,
                                             const HighpassParameters& parameters) {
  return read_highpass(deltas, anchors, std::move(graph), std::move(components), box, parameters);
}

}  // namespace deltamesh::web
