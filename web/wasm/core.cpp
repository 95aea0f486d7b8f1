// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The decoder's exports. An outcome lives until the next call.
#include <optional>
#include <utility>

#include "attributes/exceptions/exceptions.h"
#include "attributes/rare/rare.h"
#include "decoder/stream_decoder.h"
#include "format/container.h"
#include "outcome.h"
#include "runtime.h"

namespace deltamesh::web {
namespace {

constexpr std::uint32_t kGeometryOfGrid = 3;  ///< of StreamOutcome

struct Kept {
  Container container;
  std::vector<AttributeOutcome> attributes;
  std::vector<ChunkOutcome> chunks;
  Mesh mesh;
  StreamOutcome outcome;
};
std::optional<Kept> kept;

StreamOutcome* fail(const Error& error) {
  kept->outcome.error = outcome_of(error);
  return &kept->outcome;
}

std::uint32_t count_of(std::uint64_t bytes) noexcept { return static_cast<std::uint32_t>(bytes); }

/// Whether `rare` reads the values of an attribute: plain ones, and some compact ones, which begin with their
/// coding [ATTR-2].
bool reads_elsewhere(ChunkCodec codec, std::span<const std::byte> values) noexcept {
  if (codec != ChunkCodec::kCompact) return true;
  if (values.empty()) return false;
  const auto byte = std::to_integer<std::uint8_t>(values.front());
  return is_rare(static_cast<AttributeCoding>(byte & ~kExceptionsFlag));
}

/// Which parts the stream needs, if it is valid: bits by number.
std::uint32_t parts_of(const Container& container) noexcept {
  const auto bit = [](Part part, bool is_needed) {
    return is_needed ? 1U << static_cast<std::uint32_t>(part) : 0;
  };
  const FileHeader& header = container.header();
  const bool is_highpass = header.geometry == kGeometryHighpass;
  const bool is_grid = is_of_grid(header);
  const bool is_lattice = header.predictive.kind == PositionKind::kLattice;
  std::uint32_t parts = bit(Part::kHighpass, is_highpass) | bit(Part::kGrid, is_grid) |
                        bit(Part::kRare, !is_highpass && !is_grid && !is_lattice);
  for (const ChunkEntry& entry : container.entries()) {
    parts |= bit(Part::kZstd, entry.codec == ChunkCodec::kZstd);
    parts |=
        bit(Part::kRare, entry.tag == kTagAttribute && reads_elsewhere(entry.codec, container.coded(entry)));
  }
  return parts;
}

void describe_chunks() {
  std::size_t next = 0;
  for (const ChunkEntry& entry : kept->container.entries()) {
    kept->chunks.push_back({.tag = entry.tag,
                            .codec = static_cast<std::uint32_t>(entry.codec),
                            .coded_bytes = count_of(entry.coded_bytes),
                            .decoded_bytes = count_of(entry.decoded_bytes)});
    if (entry.tag != kTagAttribute) continue;
    const AttributeDescriptor& a = kept->container.header().attributes[next++];
    kept->attributes.push_back({.error = a.error,
                                .name = a.name.data(),
                                .name_bytes = count_of(a.name.size()),
                                .kind = static_cast<std::uint32_t>(a.kind),
                                .type = static_cast<std::uint32_t>(a.type),
                                .components = a.components,
                                .flags = a.flags,
                                .coded_bytes = count_of(entry.coded_bytes)});
  }
}

void describe_stream() {
  const FileHeader& header = kept->container.header();
  describe_chunks();
  StreamOutcome& outcome = kept->outcome;
  outcome.geometry = is_of_grid(header) ? kGeometryOfGrid : header.geometry;
  outcome.parts = parts_of(kept->container);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    outcome.origin[axis] = header.origin[axis];
    outcome.box[axis] = header.box_min[axis];
    outcome.box[3 + axis] = header.box_max[axis];
  }
  outcome.quality[0] = header.vde_rms;
  outcome.quality[1] = header.lfe_rms;
  outcome.quality[2] = header.max_error;
  outcome.vertices = header.vertices;
  outcome.triangles = header.triangles;
  outcome.keeps_order = header.keeps_order;
  outcome.attribute_count = count_of(kept->attributes.size());
  outcome.attributes = kept->attributes.data();
  outcome.chunk_count = count_of(kept->chunks.size());
  outcome.chunks = kept->chunks.data();
}

void describe_mesh() {
  const Mesh& mesh = kept->mesh;
  StreamOutcome& outcome = kept->outcome;
  outcome.positions = mesh.positions.data();
  outcome.indices = mesh.triangles.data();
  outcome.groups = mesh.face_groups.empty() ? nullptr : mesh.face_groups.data();
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
    kept->attributes[i].values = mesh.attributes[i].values.data();
}

}  // namespace

extern "C" {

/// Of `bytes` at `stream`, without decoding.
DELTAMESH_EXPORT(inspect) StreamOutcome* inspect_stream(const std::byte* stream, std::size_t bytes) {
  kept.emplace();
  auto container = Container::open({stream, bytes});
  if (!container) return fail(container.error());
  kept->container = *std::move(container);
  describe_stream();
  return &kept->outcome;
}

DELTAMESH_EXPORT(decode)
StreamOutcome* decode_stream(const std::byte* stream, std::size_t bytes, double vertices, double triangles,
                             double attributes, double attribute_bytes) {
  StreamOutcome* const outcome = inspect_stream(stream, bytes);
  if (outcome->error.code != 0) return outcome;
  const DecodeOptions options{.limits = {.vertices = static_cast<std::uint64_t>(vertices),
                                         .triangles = static_cast<std::uint64_t>(triangles),
                                         .attributes = static_cast<std::uint32_t>(attributes),
                                         .attribute_bytes = static_cast<std::uint64_t>(attribute_bytes)}};
  auto mesh = decode_container(kept->container, options, nullptr);
  if (!mesh) return fail(mesh.error());
  kept->mesh = *std::move(mesh);
  describe_mesh();
  return outcome;
}

/// Frees what the last call made.
DELTAMESH_EXPORT(forget) void forget() { kept.reset(); }

}  // extern "C"
}  // namespace deltamesh::web
