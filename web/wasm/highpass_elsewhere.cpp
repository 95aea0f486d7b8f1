// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// read_highpass() for `core`: the module `highpass` does it.
#include "highpass/highpass.h"
#include "part.h"

namespace deltamesh {
namespace web {

/// Takes the graph and the components, and leaves them empty.
DELTAMESH_OF_PART(highpass, read_highpass)
Result<LargeVector<Vec3>> read_highpass_there(Payload deltas, Payload anchors, Adjacency& graph,
                                              Components& components, const Box& box,
                                              const HighpassParameters& parameters);

}  // namespace web

Result<LargeVector<Vec3>> read_highpass(Payload deltas, Payload anchors, Adjacency graph,
                                        Components components, const Box& box,
                                        const HighpassParameters& parameters, ThreadTeam* /*none*/) {
  return web::read_highpass_there(deltas, anchors, graph, components, box, parameters);
}

}  // namespace deltamesh
