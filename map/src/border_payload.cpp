// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "border_payload.h"

#include <algorithm>

#include "base/try.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"

namespace deltamesh {
namespace {

Error invalid(const char* message) noexcept {
  return {.code = ErrorCode::kInvalidStream, .message = message, .rule = "MAP-11"};
}

/// Positions beyond the lattice have its outermost points.
std::vector<LatticePoint> nearest_points(const Mesh& mesh, const MapLattice& lattice) {
  const auto most = static_cast<float>(kMostLatticeSteps * lattice.step());
  std::vector<LatticePoint> points;
  points.reserve(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    std::array<float, 3> position{};
    for (std::size_t k = 0; k < 3; ++k) position[k] = std::clamp(mesh.positions[3 * v + k], -most, most);
    points.push_back(lattice.nearest(position));
  }
  return points;
}

}  // namespace

std::vector<std::byte> write_border(const Mesh& stream, const MapLattice& lattice,
                                    std::vector<BorderVertex> border, bool follows,
                                    const BorderModels& start) {
  if (border.empty()) return {};
  const auto nearest = nearest_points(stream, lattice);
  const OpenEdges edges(stream.triangles, stream.vertex_count());
  CompactWriter writer;
  BorderModels models = start;
  BorderCoder coder(writer, models, nearest, edges, follows);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < nearest.size(); ++v) coder.code(v, border, next);
  return writer.finish();
}

Result<std::vector<BorderVertex>> read_border(std::span<const std::byte> bytes, const Mesh& stream,
                                              const MapLattice& lattice, const BorderModels& start) {
  std::vector<BorderVertex> border;
  if (bytes.empty()) return border;
  const auto nearest = nearest_points(stream, lattice);
  const OpenEdges edges(stream.triangles, stream.vertex_count());
  CompactReader reader(bytes);
  BorderModels models = start;
  BorderCoder coder(reader, models, nearest, edges, false);
  std::size_t next = 0;
  for (std::uint32_t v = 0; v < nearest.size() && !reader.failed(); ++v)
    if (!coder.code(v, border, next) && !reader.failed())
      return invalid("a border vertex beyond the lattice");
  DELTAMESH_CHECK(reader.finish(0));
  if (border.empty()) return invalid("a coded border without vertices");
  return border;
}

}  // namespace deltamesh
