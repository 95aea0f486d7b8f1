// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/encode.h"

#include <algorithm>
#include <string_view>

#include "attributes/attribute.h"
#include "base/guard.h"
#include "base/large_vector.h"
#include "base/try.h"
#include "encoder/check_mesh.h"
#include "encoder/chunk_list.h"
#include "encoder/coded_geometry.h"
#include "encoder/coded_topology.h"
#include "encoder/geometry_task.h"
#include "encoder/lazy_graph.h"
#include "format/container.h"
#include "quality/bounds.h"
#include "quality/round_up.h"
#include "topology/adjacency.h"
#include "topology/mesh_edges.h"

namespace deltamesh {
namespace {

/// Stage ends as shares of the whole time, for the progress callback.
constexpr double kTopologyDone = 0.15;
constexpr double kAttributesDone = 0.3;
constexpr double kGeometryDone = 0.95;

void report_progress(const EncodeOptions& options, double share) {
  if (options.progress) options.progress(share);
}

std::vector<Vec3> gather_positions(const MeshView& mesh, const std::vector<std::uint32_t>& input_vertices) {
  std::vector<Vec3> positions;
  reserve_large(positions, input_vertices.size());
  for (const std::uint32_t v : input_vertices) {
    const float* p = mesh.positions.data() + 3 * std::size_t{v};
    positions.push_back({p[0], p[1], p[2]});
  }
  return positions;
}

void set_box(FileHeader& header, const std::vector<Vec3>& positions) {
  if (positions.empty()) return;
  Vec3 least = positions.front();
  Vec3 most = positions.front();
  for (const Vec3& position : positions) {
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

Result<void> set_quality(FileHeader& header, const Quality& quality) {
  if (!is_declarable(quality)) return kTooLarge;
  header.vde_rms = round_up(quality.vde_rms);
  header.lfe_rms = round_up(quality.lfe_rms);
  header.max_error = round_up(quality.max_error);
  return {};
}

/// The chunks around the geometry's.
struct OtherChunks {
  ChunkList before;
  ChunkList after;
};

/// Codes the positions, measures what a decoder will make of them, sets the header's figures and returns the
/// chunks of the stream.
Result<ChunkList> add_geometry(const MeshView& mesh, const CodedTopology& topology, const OtherChunks& other,
                               const EncodeOptions& options, FileHeader& header) {
  const std::vector<Vec3> positions = gather_positions(mesh, topology.geometric_input);
  const LazyGraph graph(topology.connectivity.triangles, topology.geometric_count());
  const MeshEdges edges = edges_of(topology);
  set_box(header, positions);
  header.components = topology.connectivity.components;

  const StreamFrame frame{header, other.before, other.after};
  const auto coded =
      code_geometry({options, topology.connectivity.triangles, graph, edges, positions, frame});
  if (!coded) return fault_of_mesh(coded.error());

  header.geometry = coded->geometry;
  header.highpass = coded->highpass;
  header.predictive = coded->predictive;
  DELTAMESH_CHECK(set_quality(header, coded->quality));
  ChunkList chunks = other.before;
  chunks.append(coded->chunks);
  chunks.append(other.after);
  return chunks;
}

Result<void> add_attributes(const MeshView& mesh, const CodedTopology& topology, const EncodeOptions& options,
                            ChunkList& chunks) {
  if (mesh.attributes.empty()) return {};
  const Adjacency graph = build_adjacency(topology.triangles(), topology.vertex_count());
  const AttributeQuantization quantization{.normal_bits = options.normal_bits,
                                           .color_bits = options.color_bits,
                                           .uv_bits = options.uv_bits,
                                           .exact = options.lossless};
  for (const AttributeView& attribute : mesh.attributes) {
    DELTAMESH_TRY(auto payload, write_attribute(attribute, topology.vertex_order(), quantization));
    DELTAMESH_TRY(auto compact,
                  write_compact_attribute(attribute, topology.vertex_order(), quantization, graph));
    DELTAMESH_CHECK(chunks.add(kTagAttribute, std::move(payload), std::move(compact)));
  }
  return {};
}

/// The input vertex of every decoded vertex; in the input's order where that is kept.
std::vector<std::uint32_t> decoded_order(const CodedTopology& topology, bool keep_order) {
  std::vector<std::uint32_t> order = topology.vertex_order();
  if (keep_order) std::sort(order.begin(), order.end());
  return order;
}

Result<Encoded> encode_checked(const MeshView& mesh, const EncodeOptions& options) {
  // A quick encode does not look whether another form is smaller.
  const bool compact_alone = options.effort == 0 && options.profile == Profile::kSmallest;
  CodedTopology topology = code_topology(mesh, options.keep_unreferenced,
                                         compact_alone ? PayloadForms::kCompact : PayloadForms::kBoth);
  report_progress(options, kTopologyDone);

  FileHeader header;
  header.keeps_order = options.keep_order;
  header.vertices = topology.vertex_count();
  header.geometric_vertices = topology.geometric_count();
  header.triangles = static_cast<std::uint32_t>(mesh.triangle_count());
  header.attributes = static_cast<std::uint32_t>(mesh.attributes.size());
  header.origin = mesh.origin;

  OtherChunks other{ChunkList(options.profile, options.effort), ChunkList(options.profile, options.effort)};
  if (compact_alone) {
    other.before.add_compact(kTagConnectivity, std::move(topology.connectivity.compact));
  } else {
    DELTAMESH_CHECK(other.before.add(kTagConnectivity, std::move(topology.connectivity.payload),
                                     std::move(topology.connectivity.compact)));
  }
  DELTAMESH_CHECK(
      other.before.add(kTagSeams, std::move(topology.seams.payload), std::move(topology.seams.compact)));
  DELTAMESH_CHECK(add_attributes(mesh, topology, options, other.after));
  if (options.keep_order) {
    CodedOrder order = write_order(original_order(topology, mesh.vertex_count()), topology.triangles());
    DELTAMESH_CHECK(other.after.add(kTagOrder, std::move(order.payload), std::move(order.compact)));
  }
  report_progress(options, kAttributesDone);
  DELTAMESH_TRY(const ChunkList chunks, add_geometry(mesh, topology, other, options, header));
  report_progress(options, kGeometryDone);

  Encoded encoded;
  encoded.bytes = write_container(header, chunks.chunks());
  encoded.order = decoded_order(topology, options.keep_order);
  encoded.report.input_vertices = mesh.vertex_count();
  encoded.report.unreferenced_vertices = topology.unreferenced;
  DELTAMESH_TRY(encoded.report.stream, inspect(encoded.bytes));
  report_progress(options, 1);
  return encoded;
}

}  // namespace

Result<Encoded> encode(const MeshView& mesh, const EncodeOptions& options) noexcept {
  return guarded([&]() -> Result<Encoded> {
    DELTAMESH_CHECK(validate(options));
    DELTAMESH_CHECK(check_mesh(mesh));
    return encode_checked(mesh, options);
  });
}

}  // namespace deltamesh
