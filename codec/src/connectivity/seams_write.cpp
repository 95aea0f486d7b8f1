// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstddef>

#include "base/byte_writer.h"
#include "connectivity/seam_vertex.h"
#include "connectivity/seams.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Copies by first use: their number per geometric vertex, and the place of every input vertex among them.
struct Copies {
  std::vector<std::uint32_t> count;  ///< of every geometric vertex
  std::vector<std::uint32_t> copy;   ///< of every input vertex, kNone where no corner uses it
};

Copies count_copies(std::span<const std::uint32_t> geometric_triangles, std::uint32_t geometric_count,
                    std::span<const std::uint32_t> corner_vertices) {
  Copies copies;
  copies.count.assign(geometric_count, 0);
  const auto largest = std::max_element(corner_vertices.begin(), corner_vertices.end());
  copies.copy.assign(largest == corner_vertices.end() ? 0 : std::size_t{*largest} + 1, kNone);
  for (std::size_t c = 0; c < corner_vertices.size(); ++c) {
    std::uint32_t& copy = copies.copy[corner_vertices[c]];
    if (copy == kNone) copy = copies.count[geometric_triangles[c]]++;
  }
  for (std::uint32_t& count : copies.count) count = std::max(count, 1U);  // used by no face
  return copies;
}

std::vector<std::byte> write_payload(std::span<const std::uint32_t> geometric_triangles,
                                     std::span<const std::uint32_t> corner_vertices, const Copies& copies) {
  std::vector<std::uint32_t> slot(copies.count.size(), kNone);
  std::vector<SeamVertex> seam;
  std::vector<std::uint32_t> gaps;
  std::vector<std::uint32_t> extra;
  std::size_t next = 0;
  for (std::size_t g = 0; g < slot.size(); ++g) {
    if (copies.count[g] == 1) continue;
    slot[g] = static_cast<std::uint32_t>(seam.size());
    seam.push_back({.copies = copies.count[g]});
    gaps.push_back(static_cast<std::uint32_t>(g - next));
    extra.push_back(copies.count[g] - 2);
    next = g + 1;
  }
  if (seam.empty()) return {};

  std::vector<std::uint32_t> choices;
  for (std::size_t c = 0; c < corner_vertices.size(); ++c) {
    const std::uint32_t s = slot[geometric_triangles[c]];
    if (s == kNone) continue;
    const std::uint32_t copy = copies.copy[corner_vertices[c]];
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

}  // namespace

CodedSeams write_seams(std::span<const std::uint32_t> geometric_triangles, std::uint32_t geometric_count,
                       std::span<const std::uint32_t> corner_vertices,
                       std::span<const std::uint32_t> lone_vertices) {
  const Copies copies = count_copies(geometric_triangles, geometric_count, corner_vertices);
  CodedSeams coded;
  coded.payload = write_payload(geometric_triangles, corner_vertices, copies);

  std::vector<std::uint32_t> first(geometric_count);
  for (std::uint32_t g = 0; g < geometric_count; ++g) {
    first[g] = static_cast<std::uint32_t>(coded.split.geometric.size());
    coded.split.geometric.insert(coded.split.geometric.end(), copies.count[g], g);
  }
  coded.vertex_order.resize(coded.split.geometric.size());
  std::copy(lone_vertices.begin(), lone_vertices.end(), coded.vertex_order.end() - std::ssize(lone_vertices));
  coded.split.triangles.resize(geometric_triangles.size());
  for (std::size_t c = 0; c < corner_vertices.size(); ++c) {
    const std::uint32_t v = first[geometric_triangles[c]] + copies.copy[corner_vertices[c]];
    coded.split.triangles[c] = v;
    coded.vertex_order[v] = corner_vertices[c];
  }
  return coded;
}

}  // namespace deltamesh
