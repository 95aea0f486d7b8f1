// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/encode.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "attributes/attribute.h"
#include "base/guard.h"
#include "base/try.h"
#include "encoder/check_mesh.h"
#include "encoder/coded_topology.h"
#include "entropy/chunk_codec.h"
#include "format/container.h"
#include "geometry/highpass.h"
#include "geometry/vertex_positions.h"
#include "quality/measure.h"
#include "topology/adjacency.h"

namespace deltamesh {
namespace {

/// Stage ends as shares of the whole time, for the progress callback.
constexpr double kTopologyDone = 0.15;
constexpr double kGeometryDone = 0.75;

void report_progress(const EncodeOptions& options, double share) {
  if (options.progress) options.progress(share);
}

std::vector<Vec3> gather_positions(const MeshView& mesh, const std::vector<std::uint32_t>& input_vertices) {
  std::vector<Vec3> positions;
  positions.reserve(input_vertices.size());
  for (const std::uint32_t v : input_vertices) {
    const float* p = mesh.positions.data() + 3 * std::size_t{v};
    positions.push_back({p[0], p[1], p[2]});
  }
  return positions;
}

void set_box(FileHeader& header, const std::vector<Vec3>& positions) {
  if (positions.empty()) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] =
        std::minmax_element(positions.begin(), positions.end(),
                            [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
    header.box_min[axis] = static_cast<float>((*least)[axis]);
    header.box_max[axis] = static_cast<float>((*most)[axis]);
  }
}

/// The smallest float that is not below `value`: a declared figure is never better than the measured one.
float round_up(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded >= value ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

/// Coordinates near the largest float: what is decoded, or its error, would not be a float any more.
constexpr Error kTooLarge{.code = ErrorCode::kInvalidMesh,
                          .message = "the coordinates are too large: decoded ones would not fit float32"};

Result<void> set_quality(FileHeader& header, const Quality& quality) {
  for (const double figure : {quality.vde_rms, quality.lfe_rms, quality.max_error}) {
    if (!(figure <= static_cast<double>(std::numeric_limits<float>::max()))) return kTooLarge;
  }
  header.vde_rms = round_up(quality.vde_rms);
  header.lfe_rms = round_up(quality.lfe_rms);
  header.max_error = round_up(quality.max_error);
  return {};
}

HighpassRequest highpass_request(const EncodeOptions& options) {
  HighpassRequest request{.bits = options.bits,
                          .step = options.step,
                          .anchors = options.anchors,
                          .anchor_density = options.anchor_density,
                          .anchor_bits = options.anchor_bits};
  if (!request.bits && !request.step) request.bits = 8;
  return request;
}

/// Collects the chunks of a stream; empty payloads are left out.
class ChunkList {
 public:
  explicit ChunkList(Profile profile) : profile_(profile) {}

  /// `compact`: the same payload in the compact form, where it has one.
  Result<void> add(std::uint32_t tag, std::vector<std::byte> payload, std::vector<std::byte> compact = {}) {
    if (payload.empty()) return {};
    if (profile_ == Profile::kZstd) compact.clear();
    DELTAMESH_TRY(auto chunk, code_chunk(tag, std::move(payload), std::move(compact)));
    chunks_.push_back(std::move(chunk));
    return {};
  }
  const std::vector<CodedChunk>& chunks() const noexcept { return chunks_; }

 private:
  Profile profile_;
  std::vector<CodedChunk> chunks_;
};

/// Codes the positions, measures what a decoder will make of them, and sets the header's figures.
Result<void> add_geometry(const MeshView& mesh, const CodedTopology& topology, const EncodeOptions& options,
                          FileHeader& header, ChunkList& chunks) {
  const std::vector<Vec3> positions = gather_positions(mesh, topology.geometric_input);
  const Adjacency graph = build_adjacency(topology.connectivity.triangles, topology.geometric_count());
  const Components components = find_components(graph);
  set_box(header, positions);
  auto coded = write_highpass(graph, components, positions, header.box(), highpass_request(options));
  // The one rule of the stream that a finite mesh can break [DELT-3].
  if (!coded) return coded.error().code == ErrorCode::kInvalidStream ? kTooLarge : coded.error();
  header.components = components.count;
  header.highpass = coded->parameters;
  DELTAMESH_TRY(const auto decoded, to_float_positions(coded->positions));
  DELTAMESH_CHECK(set_quality(header, measure_quality(graph, positions, decoded)));
  DELTAMESH_CHECK(chunks.add(kTagDeltas, std::move(coded->deltas), std::move(coded->compact_deltas)));
  return chunks.add(kTagAnchors, std::move(coded->anchors), std::move(coded->compact_anchors));
}

Result<void> add_attributes(const MeshView& mesh, const CodedTopology& topology, const EncodeOptions& options,
                            ChunkList& chunks) {
  if (mesh.attributes.empty()) return {};
  const Adjacency graph = build_adjacency(topology.seams.split.triangles, topology.vertex_count());
  const AttributeQuantization quantization{
      .normal_bits = options.normal_bits, .color_bits = options.color_bits, .uv_bits = options.uv_bits};
  for (const AttributeView& attribute : mesh.attributes) {
    DELTAMESH_TRY(auto payload, write_attribute(attribute, topology.seams.vertex_order, quantization));
    DELTAMESH_TRY(auto compact,
                  write_compact_attribute(attribute, topology.seams.vertex_order, quantization, graph));
    DELTAMESH_CHECK(chunks.add(kTagAttribute, std::move(payload), std::move(compact)));
  }
  return {};
}

/// The input vertex of every decoded vertex; in the input's order where that is kept.
std::vector<std::uint32_t> decoded_order(const CodedTopology& topology, bool keep_order) {
  std::vector<std::uint32_t> order = topology.seams.vertex_order;
  if (keep_order) std::sort(order.begin(), order.end());
  return order;
}

Result<Encoded> encode_checked(const MeshView& mesh, const EncodeOptions& options) {
  CodedTopology topology = code_topology(mesh, options.keep_unreferenced);
  report_progress(options, kTopologyDone);

  FileHeader header;
  header.keeps_order = options.keep_order;
  header.vertices = topology.vertex_count();
  header.geometric_vertices = topology.geometric_count();
  header.triangles = static_cast<std::uint32_t>(mesh.triangle_count());
  header.attributes = static_cast<std::uint32_t>(mesh.attributes.size());
  header.origin = mesh.origin;

  ChunkList chunks(options.profile);
  DELTAMESH_CHECK(chunks.add(kTagConnectivity, std::move(topology.connectivity.payload),
                             std::move(topology.connectivity.compact)));
  DELTAMESH_CHECK(chunks.add(kTagSeams, std::move(topology.seams.payload)));
  DELTAMESH_CHECK(add_geometry(mesh, topology, options, header, chunks));
  report_progress(options, kGeometryDone);
  DELTAMESH_CHECK(add_attributes(mesh, topology, options, chunks));
  if (options.keep_order)
    DELTAMESH_CHECK(chunks.add(kTagOrder, write_order(original_order(topology, mesh.vertex_count()))));

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
