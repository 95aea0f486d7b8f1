// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstddef>

#include "base/byte_writer.h"
#include "connectivity/faces/cut.h"
#include "connectivity/seams/coder.h"
#include "connectivity/seams/corner_copies.h"
#include "connectivity/seams/seams.h"
#include "connectivity/seams/vertex.h"
#include "entropy/coder/writer.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

/// Copies by first use.
CornerCopies count_copies(std::span<const std::uint32_t> geometric_triangles, std::uint32_t geometric_count,
                          std::span<const std::uint32_t> corner_vertices) {
  CornerCopies copies;
  copies.of_vertex.assign(geometric_count, 0);
  copies.of_corner.reserve(corner_vertices.size());
  const auto largest = std::max_element(corner_vertices.begin(), corner_vertices.end());
  std::vector<std::uint32_t> copy(largest == corner_vertices.end() ? 0 : std::size_t{*largest} + 1, kNoIndex);
  for (std::size_t c = 0; c < corner_vertices.size(); ++c) {
    std::uint32_t& own = copy[corner_vertices[c]];
    if (own == kNoIndex) own = copies.of_vertex[geometric_triangles[c]]++;
    copies.of_corner.push_back(own);
  }
  for (std::uint32_t& count : copies.of_vertex) count = std::max(count, 1U);  // used by no face
  return copies;
}

std::vector<std::byte> write_plain(std::span<const std::uint32_t> geometric_triangles,
                                   const CornerCopies& copies) {
  std::vector<std::uint32_t> slot(copies.of_vertex.size(), kNoIndex);
  std::vector<SeamVertex> seam;
  std::vector<std::uint32_t> gaps;
  std::vector<std::uint32_t> extra;
  std::size_t next = 0;
  for (std::size_t g = 0; g < slot.size(); ++g) {
    if (copies.of_vertex[g] == 1) continue;
    slot[g] = static_cast<std::uint32_t>(seam.size());
    seam.push_back({.copies = copies.of_vertex[g]});
    gaps.push_back(static_cast<std::uint32_t>(g - next));
    extra.push_back(copies.of_vertex[g] - 2);
    next = g + 1;
  }

  std::vector<std::uint32_t> choices;
  for (std::size_t c = 0; c < geometric_triangles.size(); ++c) {
    const std::uint32_t s = slot[geometric_triangles[c]];
    if (s == kNoIndex) continue;
    const std::uint32_t copy = copies.of_corner[c];
    if (seam[s].used != 0) choices.push_back(seam[s].choice_of(copy));
    seam[s].take(copy);
  }

  ByteWriter out;
  out.write_varint(seam.size());
  write_planes(out, gaps);
  write_planes(out, extra);
  write_planes(out, choices);
  return out.take();
}

std::vector<std::byte> write_compact(std::span<const std::uint32_t> geometric_triangles, CornerCopies& copies,
                                     std::uint32_t extra_copies) {
  CompactWriter writer;
  SeamCoder<CompactWriter> coder(writer, static_cast<std::uint32_t>(copies.of_vertex.size()), extra_copies);
  coder.code(geometric_triangles, copies);
  return writer.finish();
}

}  // namespace

CodedSeams write_seams(std::span<const std::uint32_t> geometric_triangles, std::uint32_t geometric_count,
                       std::span<const std::uint32_t> corner_vertices,
                       std::span<const std::uint32_t> lone_vertices) {
  CornerCopies copies = count_copies(geometric_triangles, geometric_count, corner_vertices);
  CodedSeams coded;
  coded.split = split_vertices(geometric_triangles, copies);
  const auto vertex_count = static_cast<std::uint32_t>(coded.split.geometric.size());
  if (vertex_count > geometric_count) {
    coded.payload = write_plain(geometric_triangles, copies);
    coded.compact = write_compact(geometric_triangles, copies, vertex_count - geometric_count);
  }
  coded.vertex_order.resize(vertex_count);
  std::copy(lone_vertices.begin(), lone_vertices.end(), coded.vertex_order.end() - std::ssize(lone_vertices));
  for (std::size_t c = 0; c < corner_vertices.size(); ++c)
    coded.vertex_order[coded.split.triangles[c]] = corner_vertices[c];
  return coded;
}

}  // namespace deltamesh
