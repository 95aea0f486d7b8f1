// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/anchors/anchors.h"

#include "laplacian/anchors/anchor_sequence.h"

namespace deltamesh {
namespace {

constexpr std::uint32_t kVerticesPerAnchor = 200;

}  // namespace

std::uint32_t default_anchor_count(std::size_t solved_vertices) noexcept {
  return static_cast<std::uint32_t>((solved_vertices + kVerticesPerAnchor - 1) / kVerticesPerAnchor);
}

Anchors place_anchors(const Adjacency& graph, const Components& components, const AnchorRequest& request) {
  AnchorSequence sequence(graph, components);
  if (request.density) return sequence.first(graph, sequence.count_for_density(graph, *request.density));
  return sequence.first(graph, request.count.value_or(default_anchor_count(sequence.most())));
}

}  // namespace deltamesh
