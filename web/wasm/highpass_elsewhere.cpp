// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// read_highpass() for `core`: the module `highpass` does it.
#include "base/try.h"
#include "highpass/highpass.h"
#include "parts.h"

namespace deltamesh {

Result<LargeVector<Vec3>> read_highpass(Payload deltas, Payload anchors, Adjacency graph,
                                        Components components, const Box& box,
                                        const HighpassParameters& parameters, ThreadTeam*) {
  const auto hand_over = [](const auto& array) { return web::hand_over(web::Part::kHighpass, array); };
  web::HighpassCall call{.box = box, .parameters = parameters};
  call.deltas = hand_over(deltas.bytes);
  call.anchors = hand_over(anchors.bytes);
  call.deltas_are_compact = deltas.is_compact;
  call.anchors_are_compact = anchors.is_compact;
  call.offsets = hand_over(graph.offsets);
  call.neighbors = hand_over(graph.neighbors);
  graph = {};
  call.labels = hand_over(components.label);
  call.sizes = hand_over(components.size);
  components = {};
  DELTAMESH_TRY(const auto returned, web::call_part(web::Part::kHighpass, call));
  LargeVector<Vec3> positions;
  web::take_array(web::Part::kHighpass, returned.arrays[0], positions);
  return positions;
}

}  // namespace deltamesh
