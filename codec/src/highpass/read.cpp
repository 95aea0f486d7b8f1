// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>
#include <utility>

#include "base/broken_rule.h"
#include "base/memory/large_vector.h"
#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "field/field_coder.h"
#include "format/chunk/tags.h"
#include "highpass/compact.h"
#include "highpass/highpass.h"
#include "highpass/plain/plain.h"
#include "highpass/symbols.h"
#include "laplacian/anchors/anchors.h"

namespace deltamesh {
namespace {

/// Ranges of the parameters that the arithmetic below relies on.
Result<void> check_parameters(const HighpassParameters& parameters, std::size_t vertex_count) {
  if (!(parameters.step > 0 && std::isfinite(parameters.step)))
    return broken_rule("the step is not a finite number above 0", "DELT-1", kTagDeltas);
  if (parameters.anchor_bits < kLeastAnchorBits || parameters.anchor_bits > kMostAnchorBits)
    return broken_rule("anchor bits outside 4 to 24", "ANCH-1", kTagAnchors);
  if (parameters.cycles < 1 || parameters.cycles > kMostCycles)
    return broken_rule("no cycles, or too many", "DELT-7", kTagDeltas);
  if (parameters.anchors > vertex_count)
    return broken_rule("more anchors than vertices", "ANCH-1", kTagAnchors);
  return {};
}

/// Anchors from the gaps between them.
Result<std::vector<std::uint32_t>> anchor_vertices(const AnchorList& list, std::size_t vertex_count) {
  std::vector<std::uint32_t> vertices;
  vertices.reserve(list.gaps.size());
  std::uint64_t expected = 0;
  for (const std::uint32_t gap : list.gaps) {
    expected += gap;
    if (expected >= vertex_count) return broken_rule("anchor beyond the last vertex", "ANCH-3", kTagAnchors);
    vertices.push_back(static_cast<std::uint32_t>(expected++));
  }
  return vertices;
}

Result<std::vector<AnchorCell>> anchor_cells(const AnchorList& list, int bits) {
  const std::size_t count = list.gaps.size();
  std::vector<AnchorCell> cells(count);
  AnchorCell cell{};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] += static_cast<std::uint32_t>(unzigzag(list.steps[axis * count + i]));  // wraps; caught next
      if (cell[axis] >> bits != 0) return broken_rule("anchor outside its lattice", "ANCH-4", kTagAnchors);
    }
    cells[i] = cell;
  }
  return cells;
}

/// Every solved component has an anchor, and every vertex of the others is one [ANCH-2].
Result<void> check_coverage(std::span<const std::uint32_t> anchors, const Components& components) {
  std::vector<std::uint32_t> anchors_in(components.count, 0);
  for (const std::uint32_t anchor : anchors) ++anchors_in[components.label[anchor]];
  for (std::uint32_t c = 0; c < components.count; ++c) {
    const bool small = components.size[c] < kSmallestSolvedComponent;
    if (anchors_in[c] < (small ? components.size[c] : 1))
      return broken_rule("a component with too few anchors", "ANCH-2", kTagAnchors);
  }
  return {};
}

/// Everything but the deltas. Errors: kTruncated, kInvalidStream [ANCH-*].
Result<HighpassSymbols> read_anchor_symbols(Payload anchors, const Components& components,
                                            const HighpassParameters& parameters) {
  HighpassSymbols symbols;
  if (anchors.is_compact) {
    DELTAMESH_TRY(const AnchorList list, read_anchors(anchors.bytes, parameters.anchors));
    DELTAMESH_TRY(symbols.anchors, anchor_vertices(list, components.label.size()));
    DELTAMESH_TRY(symbols.cells, anchor_cells(list, parameters.anchor_bits));
  } else {
    DELTAMESH_CHECK(read_plain_anchors(anchors.bytes, components.label.size(), parameters, symbols));
  }
  DELTAMESH_CHECK(check_coverage(symbols.anchors, components));
  return symbols;
}

}  // namespace

Result<AnchorList> read_anchors(std::span<const std::byte> payload, std::uint32_t count) {
  CompactReader reader(payload);
  AnchorList list{.gaps = std::vector<std::uint32_t>(count),
                  .steps = std::vector<std::uint32_t>(3 * std::size_t{count})};
  code_anchors(reader, list);
  DELTAMESH_CHECK(reader.finish(kTagAnchors));
  return list;
}

Result<LargeVector<std::int32_t>> read_compact_deltas(std::span<const std::byte> payload,
                                                      const Adjacency& graph) {
  const std::size_t n = graph.vertex_count();
  LargeVector<std::int32_t> deltas(3 * n);
  CompactReader reader(payload);
  FieldCoder<CompactReader> field(reader, graph);
  for (std::uint32_t v = 0; v < n && !reader.failed(); ++v) {
    FieldNumbers q{};
    if (!field.code_vertex(v, q)) return broken_rule("a delta beyond 2^30 steps", "FLD-1", kTagDeltas);
    for (std::size_t axis = 0; axis < q.size(); ++axis) deltas[axis * n + v] = q[axis];
  }
  DELTAMESH_CHECK(reader.finish(kTagDeltas));
  return deltas;
}

Result<LargeVector<Vec3>> read_highpass(Payload deltas, Payload anchors, Adjacency graph,
                                        Components components, const Box& box,
                                        const HighpassParameters& parameters, ThreadTeam* team) {
  DELTAMESH_CHECK(check_parameters(parameters, graph.vertex_count()));
  DELTAMESH_TRY(const HighpassSymbols symbols, read_anchor_symbols(anchors, components, parameters));
  SolvedPart part = extract_solved_part(std::move(graph), std::move(components));
  const auto read = [&](const Adjacency& solved) -> Result<SymbolRows> {
    DELTAMESH_TRY(const auto planar, deltas.is_compact
                                         ? read_compact_deltas(deltas.bytes, solved)
                                         : read_plain_deltas(deltas.bytes, solved.vertex_count()));
    return SymbolRows(planar);
  };
  return reconstruct_highpass_once(read, symbols, std::move(part), box, parameters, team);
}

}  // namespace deltamesh
