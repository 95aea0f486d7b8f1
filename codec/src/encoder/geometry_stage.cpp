// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/geometry_stage.h"

#include <string_view>

#include "base/large_vector.h"
#include "base/try.h"
#include "encoder/geometry_task.h"
#include "quality/bounds.h"
#include "quality/round_up.h"

namespace deltamesh {
namespace {

std::vector<Vec3> gather_positions(const MeshView& mesh, const std::vector<std::uint32_t>& input_vertices) {
  std::vector<Vec3> positions;
  reserve_large(positions, input_vertices.size());
  for (const std::uint32_t v : input_vertices) {
    const float* p = mesh.positions.data() + 3 * std::size_t{v};
    positions.push_back({p[0], p[1], p[2]});
  }
  return positions;
}

/// All edges of the coded mesh, which the connectivity's writer has mostly met already.
MeshEdges edges_of(const CodedTopology& topology) {
  const CodedConnectivity& coded = topology.connectivity;
  const std::uint32_t count = topology.geometric_count();
  if (coded.new_edges.empty()) return find_edges(coded.triangles, count);
  MeshEdges edges{.triangles = coded.triangles, .visited = coded.new_edges};
  for (auto v = static_cast<std::uint32_t>(count - topology.unreferenced_kept); v < count; ++v)
    edges.lone_vertices.push_back(v);
  return edges;
}

/// Coordinates near the largest float: what is decoded, or its error, would not be a float any more.
constexpr Error kTooLarge{.code = ErrorCode::kInvalidMesh,
                          .message = "the coordinates are too large: decoded ones would not fit float32"};

/// Coordinates that differ by more than the solver's numbers hold.
constexpr Error kTooUneven{.code = ErrorCode::kInvalidMesh,
                           .message = "the coordinates differ too much in size for highpass coding"};

/// What a finite mesh does wrong whose own stream breaks a rule.
Error fault_of_mesh(const Error& error) noexcept {
  const std::string_view rule = error.rule;
  if (rule == "DELT-3" || rule == "GEO-1" || rule == "HDR-9") return kTooLarge;
  return rule == "DELT-4" ? kTooUneven : error;
}

}  // namespace

GeometryStage::GeometryStage(const MeshView& mesh, const CodedTopology& topology)
    : topology_(topology),
      positions_(gather_positions(mesh, topology.geometric_input)),
      graph_(topology.connectivity.triangles, topology.geometric_count()),
      edges_(edges_of(topology)) {}

void GeometryStage::describe(FileHeader& header) const {
  header.components = topology_.connectivity.components;
  if (positions_.empty()) return;
  Vec3 least = positions_.front();
  Vec3 most = positions_.front();
  for (const Vec3& position : positions_) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = position[axis] < least[axis] ? position[axis] : least[axis];
      most[axis] = position[axis] < most[axis] ? most[axis] : position[axis];
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.box_min[axis] = static_cast<float>(least[axis]);
    header.box_max[axis] = static_cast<float>(most[axis]);
  }
}

Result<GeometryChoice> GeometryStage::code(const EncodeOptions& options, const StreamFrame& frame,
                                           const AttributeBytes& attribute_bytes) const {
  auto coded = code_geometry(
      {options, topology_.connectivity.triangles, graph_, edges_, positions_, frame, attribute_bytes});
  if (!coded) return fault_of_mesh(coded.error());
  return coded;
}

Result<void> describe(const GeometryChoice& choice, FileHeader& header) {
  if (!is_declarable(choice.quality)) return kTooLarge;
  header.geometry = choice.geometry;
  header.highpass = choice.highpass;
  header.predictive = choice.predictive;
  header.vde_rms = round_up(choice.quality.vde_rms);
  header.lfe_rms = round_up(choice.quality.lfe_rms);
  header.max_error = round_up(choice.quality.max_error);
  return {};
}

}  // namespace deltamesh
