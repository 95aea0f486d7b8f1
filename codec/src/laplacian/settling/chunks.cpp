// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/chunks.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "laplacian/settling/level.h"

namespace deltamesh::settling {
namespace {

/// Of a finest level that is shared at all, and of one chunk where there are more than kFewestChunks. Every
/// thread more adds to the rim: on meshes of a million vertices 0.9 to 1.8 % for four chunks.
constexpr std::uint32_t kFewestNodes = std::uint32_t{1} << 16;
constexpr std::uint32_t kNodesPerChunk = std::uint32_t{1} << 18;
constexpr std::uint32_t kFewestChunks = 4;

struct Range {
  std::uint32_t begin = 0;
  std::uint32_t size = 0;
  bool has(std::uint32_t node) const noexcept { return node - begin < size; }
};

Range range_of(const std::vector<std::uint32_t>& bounds, std::uint32_t chunk) noexcept {
  return {bounds[chunk], bounds[chunk + 1] - bounds[chunk]};
}

/// Whether a node from `begin` to `end` has a neighbour below `first`.
bool reach_below(std::uint32_t first, const Level& level, std::uint32_t begin, std::uint32_t end) noexcept {
  const std::uint32_t* const offsets = level.offsets.data();
  const std::uint32_t* const neighbors = level.neighbors.data();
  std::uint32_t below = 0;
  if (level.has_unit_weights()) {  // rows ascend
    for (; begin < end; ++begin) {
      if (offsets[begin] < offsets[begin + 1]) below += neighbors[offsets[begin]] < first ? 1 : 0;
    }
  } else {  // no branch: that lets processors compare many at once
    for (std::uint32_t e = offsets[begin]; e < offsets[end]; ++e) below += neighbors[e] < first ? 1 : 0;
  }
  return below != 0;
}

/// Whether one of `rows` is interpolated from elsewhere. Three counts: so processors compare many at once.
bool leave(Range range, std::span<const Interpolation> rows) noexcept {
  std::array<std::uint32_t, 3> left{};
  for (const Interpolation& p : rows) {
    for (std::size_t k = 0; k < 3; ++k) left[k] += range.has(p.node(k)) ? 0 : 1;
  }
  return left[0] + left[1] + left[2] != 0;
}

/// Whether one of the nodes from `begin` to `end` is on the rim.
bool has_rim(const Level& level, std::uint32_t begin, std::uint32_t end, Range own, Range coarse) noexcept {
  if (own.begin > 0 && reach_below(own.begin, level, begin, end)) return true;
  const std::span<const Interpolation> interpolation = level.interpolation;
  return !interpolation.empty() && leave(coarse, interpolation.subspan(begin, end - begin));
}

std::vector<std::uint32_t> find_rim(const Level& level, Range own, Range coarse) {
  constexpr std::uint32_t kAtOnce = 32;
  std::vector<std::uint32_t> rim;
  const std::uint32_t last = own.begin + own.size;
  for (std::uint32_t begin = own.begin; begin < last; begin += kAtOnce) {
    const std::uint32_t end = std::min(begin + kAtOnce, last);
    if (!has_rim(level, begin, end, own, coarse)) continue;
    for (std::uint32_t node = begin; node < end; ++node) {
      if (has_rim(level, node, node + 1, own, coarse)) rim.push_back(node);
    }
  }
  return rim;
}

}  // namespace

Chunks make_chunks(const Level& level, std::vector<std::uint32_t> bounds,
                   const std::vector<std::uint32_t>& coarse_bounds) {
  Chunks chunks;
  chunks.bounds = std::move(bounds);
  chunks.first_rim.assign(chunks.bounds.size(), 0);
  if (chunks.count() == 1) return chunks;
  std::vector<std::vector<std::uint32_t>> rims(chunks.count());
  for (std::uint32_t k = 0; k < chunks.count(); ++k) {
    const Range own = range_of(chunks.bounds, k);
    const Range coarse = coarse_bounds.empty() ? Range{} : range_of(coarse_bounds, k);
    rims[k] = find_rim(level, own, coarse);
  }
  chunks.is_on_rim.resize(level.node_count());
  for (std::uint32_t k = 0; k < chunks.count(); ++k) {
    chunks.rim.insert(chunks.rim.end(), rims[k].begin(), rims[k].end());
    chunks.first_rim[k + 1] = static_cast<std::uint32_t>(chunks.rim.size());
  }
  for (const std::uint32_t node : chunks.rim) chunks.is_on_rim[node] = true;
  return chunks;
}

std::vector<std::uint32_t> chunk_bounds(std::uint32_t nodes) {
  const std::uint32_t count =
      nodes < kFewestNodes ? 1 : std::clamp(nodes / kNodesPerChunk, kFewestChunks, kMostChunks);
  std::vector<std::uint32_t> bounds;
  for (std::uint32_t k = 0; k <= count; ++k)
    bounds.push_back(static_cast<std::uint32_t>(std::uint64_t{nodes} * k / count));
  return bounds;
}

}  // namespace deltamesh::settling
