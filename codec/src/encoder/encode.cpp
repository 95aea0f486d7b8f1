// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/encode.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "attributes/error.h"
#include "base/byte_writer.h"
#include "base/guard.h"
#include "base/numbers/short_float.h"
#include "base/progress.h"
#include "base/try.h"
#include "connectivity/check_mesh.h"
#include "connectivity/groups/groups.h"
#include "deltamesh/color_content.h"
#include "deltamesh/model_states.h"
#include "encoder/coded_parts.h"
#include "encoder/coded_topology.h"
#include "entropy/chunk_list.h"
#include "format/container.h"
#include "search/request.h"
#include "states/stream_models.h"

namespace deltamesh {
namespace {

/// End of the first stage as a share of the whole time, for the progress callback.
constexpr double kTopologyDone = 0.15;
constexpr double kPartsDone = 0.95;

CodedTopology topology_of(const MeshView& mesh, const EncodeOptions& options) {
  if (options.profile == Profile::kZstd)
    return code_plain_topology(mesh, options.keep_unreferenced, options.keep_order);
  return code_topology(
      mesh, options.keep_unreferenced,
      options.starting_states != nullptr ? options.starting_states->models().of_ops() : nullptr);
}

/// The input vertex of every decoded vertex; in the input's order where that is kept.
std::vector<std::uint32_t> decoded_order(const CodedTopology& topology, bool keep_order) {
  std::vector<std::uint32_t> order = topology.vertex_order();
  if (keep_order) std::sort(order.begin(), order.end());
  return order;
}

std::uint64_t count_dropped_lengths(const MeshView& mesh, const EncodeOptions& options) {
  if (options.lossless || options.profile != Profile::kSmallest) return 0;
  std::uint64_t count = 0;
  for (const AttributeView& attribute : mesh.attributes)
    count += count_dropped_lengths(attribute, options.attributes);
  return count;
}

/// All that does not depend on how the geometry is coded.
FileHeader header_of(const MeshView& mesh, const EncodeOptions& options, const CodedTopology& topology,
                     const Box& box) {
  FileHeader header;
  header.keeps_order = options.keep_order;
  header.vertices = topology.vertex_count();
  header.geometric_vertices = topology.geometric_count();
  header.triangles = static_cast<std::uint32_t>(mesh.triangle_count());
  header.components = topology.connectivity.components;
  header.origin = mesh.origin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.box_min[axis] = static_cast<float>(box.min[axis]);
    header.box_max[axis] = static_cast<float>(box.max[axis]);
  }
  return header;
}

/// Of a mesh with stray vertices [SIZ-1].
std::vector<std::byte> write_extent(const Extent& extent) {
  ByteWriter out;
  if (extent.strays == 0) return {};
  out.write(extent.diagonal);
  out.write_varint(extent.strays);
  return out.take();
}

/// What depends on no order.
ChunkList code_informative(const MeshView& mesh, const EncodeOptions& options, const Extent& extent) {
  ChunkList chunks(options.profile, options.effort);
  chunks.add_plain(kTagExtent, write_extent(extent));
  chunks.add_plain(kTagGroupNames, write_group_names(mesh.group_names));
  return chunks;
}

void declare(const Candidate& geometry, double source_error, FileHeader& header) noexcept {
  geometry.set_parameters(header);
  const Quality quality = with_source_error(geometry.quality, source_error);
  header.vde_rms = short_float_above(quality.vde_rms);
  header.lfe_rms = short_float_above(quality.lfe_rms);
  header.max_error = short_float_above(quality.max_error);
}

/// Nothing where it does not decide on colours.
Result<ColorContent> color_content(const MeshView& mesh, const EncodeOptions& options) {
  ColorContent content;
  const bool is_asked = options.lossless || options.attributes.color_error || options.attributes.color_rms;
  if (!is_asked) DELTAMESH_CHECK(content.add(mesh));
  return content;
}

/// Different colours, over all attributes of colours.
std::uint64_t count_colors(const MeshView& mesh) {
  using Row = std::array<std::byte, kMaxComponents * sizeof(double)>;
  std::uint64_t count = 0;
  for (const AttributeView& attribute : mesh.attributes) {
    if (attribute.kind != AttributeKind::kColor) continue;
    const std::size_t size = attribute.components * component_size(attribute.type);
    std::vector<Row> rows(mesh.vertex_count());
    for (std::size_t v = 0; v < rows.size(); ++v)
      std::copy_n(attribute.values.data() + v * size, size, rows[v].data());
    std::sort(rows.begin(), rows.end());
    count += static_cast<std::uint64_t>(std::unique(rows.begin(), rows.end()) - rows.begin());
  }
  return count;
}

/// What a stream says of itself, and the box, of which a stream may have but that of its lattice.
Result<StreamInfo> report_of(std::span<const std::byte> bytes, const SourceGeometry& source) {
  DELTAMESH_TRY(StreamInfo info, inspect(bytes));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    info.box_min[axis] = static_cast<float>(source.box.min[axis]);
    info.box_max[axis] = static_cast<float>(source.box.max[axis]);
  }
  info.diagonal = source.box.diagonal();
  info.extent = source.extent.diagonal;
  return info;
}

/// `mesh` and `options` have been checked.
Result<Encoded> encode_checked(const MeshView& mesh, const EncodeOptions& options) {
  Progress progress(options.progress);
  progress.reach(0, kTopologyDone);
  const CodedTopology topology = topology_of(mesh, options);
  const SourceGeometry source = source_geometry(mesh, topology);
  progress.reach(kTopologyDone, kPartsDone);

  FileHeader header = header_of(mesh, options, topology, source.box);
  TopologyChunks topology_chunks = code_topology_chunks(mesh, options, topology);
  ChunkList informative = code_informative(mesh, options, source.extent);
  DELTAMESH_TRY(CodedParts parts, code_parts({options, mesh, topology, topology_chunks, source, header,
                                              informative.bytes(), progress}));
  declare(parts.geometry, options.source_error, header);
  if (parts.in_grid) topology_chunks = std::move(parts.in_grid->chunks);
  ChunkList chunks = std::move(topology_chunks.faces);
  chunks.append(std::move(topology_chunks.splits));
  chunks.append(std::move(parts.geometry.chunks));
  chunks.append(std::move(parts.attributes));
  chunks.append(std::move(topology_chunks.order));
  chunks.append(std::move(informative));

  Encoded encoded;
  encoded.bytes = write_container(header, chunks.chunks());
  encoded.order = decoded_order(parts.in_grid ? parts.in_grid->topology : topology, options.keep_order);
  encoded.report.input_vertices = mesh.vertex_count();
  encoded.report.unreferenced_vertices = topology.unreferenced;
  encoded.report.dropped_lengths = count_dropped_lengths(mesh, options);
  DELTAMESH_TRY(encoded.report.stream, report_of(encoded.bytes, source));
  progress.reach(1, 1);
  return encoded;
}

}  // namespace

Result<Encoded> encode(const MeshView& mesh, const EncodeOptions& options) noexcept {
  return guarded([&]() -> Result<Encoded> {
    DELTAMESH_CHECK(validate(options));
    DELTAMESH_CHECK(check_mesh(mesh));
    DELTAMESH_TRY(const ColorContent content, color_content(mesh, options));
    EncodeOptions completed = options;
    completed.attributes = content.complete(std::move(completed.attributes));
    DELTAMESH_TRY(Encoded encoded, encode_checked(mesh, completed));
    if (content.has_labels()) encoded.report.labels = count_colors(mesh);
    return encoded;
  });
}

}  // namespace deltamesh
