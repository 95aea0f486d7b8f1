// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `grid`, for surfaces in the cubes of a grid.
#include "grid/grid.h"

#include <optional>
#include <vector>

#include "part.h"

namespace deltamesh::web {
namespace {

struct Kept {
  GridMesh mesh;
  PartOutcome outcome;
};
std::optional<Kept> kept;

}  // namespace

extern "C" {

/// Releases `handed` and its arrays. The outcome lives until the next call, or until forget().
DELTAMESH_EXPORT(call) PartOutcome* call(GridCall* handed) {
  const GridCall call = *handed;
  release(handed);
  using Bytes = std::vector<std::byte>;
  const GridPayloads payloads{.surface = take_array<Bytes>(call.chunks[0]),
                              .rest_faces = take_array<Bytes>(call.chunks[1])};
  kept.emplace();
  auto mesh = read_grid(chunks_of(payloads), call.parameters, call.vertices, call.triangles);
  if (!mesh) {
    kept->outcome.error = outcome_of(mesh.error());
    return &kept->outcome;
  }
  kept->mesh = *std::move(mesh);
  kept->outcome.returned.add(kept->mesh.triangles);
  kept->outcome.returned.add(kept->mesh.positions);
  return &kept->outcome;
}

DELTAMESH_EXPORT(forget) void forget() { kept.reset(); }

}  // extern "C"
}  // namespace deltamesh::web
