// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cmath>

#include "base/byte_reader.h"
#include "base/guard.h"
#include "base/small_code.h"
#include "deltamesh/stream_info.h"
#include "format/chunk/tags.h"
#include "format/container.h"

namespace deltamesh {
namespace {

/// By ChunkCodec.
constexpr std::array<const char*, 3> kCodecNames{"raw", "zstd", "compact"};

ChunkInfo describe_chunk(const ChunkEntry& entry) {
  ChunkInfo chunk{.codec = kCodecNames[static_cast<std::size_t>(entry.codec)],
                  .offset = entry.offset,
                  .coded_bytes = entry.coded_bytes,
                  .decoded_bytes = entry.decoded_bytes};
  for (unsigned i = 0; i < 4; ++i) chunk.tag[i] = static_cast<char>(entry.tag >> (8 * i) & 0xff);
  return chunk;
}

void add_sizes(StreamInfo& info, const ChunkEntry& entry) {
  switch (entry.tag) {
    case kTagConnectivity:
    case kTagSeams:
    case kTagFaceGroups:
    case kTagOrder:
      info.connectivity_bytes += entry.coded_bytes;
      break;
    case kTagDeltas:
    case kTagPositions:
    case kTagGrid:
      info.geometry_bytes += entry.coded_bytes;
      break;
    case kTagAnchors:
      info.anchor_bytes += entry.coded_bytes;
      break;
    case kTagAttribute:
      info.attribute_bytes += entry.coded_bytes;
      break;
    default:
      break;
  }
}

/// [SIZ-1]; for information, so that a chunk of another form changes nothing.
void read_extent(StreamInfo& info, const Container& container) {
  info.extent = info.diagonal;
  if constexpr (kSmallCode) return;  // no module hands it out
  const ChunkEntry* const entry = container.find(kTagExtent);
  if (entry == nullptr || entry->codec != ChunkCodec::kRaw) return;
  ByteReader in(container.coded(*entry), kTagExtent);
  const auto diagonal = in.read<double>();
  const auto strays = in.read_varint();
  if (!diagonal || !strays || !std::isfinite(*diagonal) || *diagonal < 0) return;
  info.extent = *diagonal;
  info.stray_vertices = *strays;
}

/// The header's descriptors with the sizes of their chunks, as far as there are any.
void add_attributes(StreamInfo& info, const Container& container) {
  for (const AttributeDescriptor& a : container.header().attributes)
    info.attributes.push_back({a.name, a.kind, a.type, a.components, 0, a.error, a.rms, a.is_linear()});
  std::size_t next = 0;
  for (const ChunkEntry& entry : container.entries())
    if (entry.tag == kTagAttribute && next < info.attributes.size())
      info.attributes[next++].coded_bytes = entry.coded_bytes;
}

StreamInfo summarize(const Container& container) {
  const FileHeader& h = container.header();
  StreamInfo info;
  info.format_major = kFormatMajor;  // no other is read
  info.format_minor = kFormatMinor;
  info.format_draft = kFormatDraft;
  info.vertices = h.vertices;
  info.geometric_vertices = h.geometric_vertices;
  info.triangles = h.triangles;
  info.components = h.components;
  info.origin = h.origin;
  info.box_min = h.box_min;
  info.box_max = h.box_max;
  info.diagonal = is_of_grid(h) ? 0 : h.box().diagonal();
  read_extent(info, container);
  info.keeps_order = h.keeps_order;
  if (h.geometry == kGeometryPredictive) {
    info.geometry = is_of_grid(h) ? "grid" : "predictive";
    info.bits = h.predictive.bits;
    info.step = *std::max_element(h.predictive.lattice.step.begin(), h.predictive.lattice.step.end());
    if (h.predictive.kind == PositionKind::kFloats) info.step = 0;
    if (is_of_grid(h)) info.step *= 2;  // a level along an edge
  } else {
    info.geometry = "highpass";
    info.bits = h.highpass.bits;
    info.step = h.highpass.step;
    info.anchors = h.highpass.anchors;
    info.anchor_density = h.highpass.anchor_density;
    info.cycles = h.highpass.cycles;
  }
  info.quality = {h.vde_rms, h.lfe_rms, h.max_error};
  for (const ChunkEntry& entry : container.entries()) {
    info.chunks.push_back(describe_chunk(entry));
    add_sizes(info, entry);
  }
  add_attributes(info, container);
  info.bytes = container.size();
  info.container_bytes =
      info.bytes - info.connectivity_bytes - info.geometry_bytes - info.anchor_bytes - info.attribute_bytes;
  return info;
}

}  // namespace

Result<StreamInfo> inspect(std::span<const std::byte> stream) noexcept {
  return guarded([&]() -> Result<StreamInfo> {
    DELTAMESH_TRY(const auto container, Container::open(stream));
    return summarize(container);
  });
}

}  // namespace deltamesh
