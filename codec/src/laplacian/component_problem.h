// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A graph's components, each of which is solved by itself [DELT-4].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/memory/large_vector.h"
#include "base/numbers/vec3.h"
#include "laplacian/operator/delta_view.h"
#include "laplacian/operator/symbol_rows.h"
#include "topology/adjacency.h"
#include "topology/vertex_subset.h"

namespace deltamesh {

/// One component; its vertices become rows.
struct ComponentProblem {
  VertexSubset vertices{};
  std::vector<std::uint32_t> anchors{};  ///< rows, ascending
  std::vector<std::uint32_t> numbers{};  ///< which anchors of the graph they are

  std::vector<Vec3> pick_targets(std::span<const Vec3> all) const;
};

/// In order of their first vertices. `anchors`: vertices, ascending. O(n + runs of vertices).
std::vector<ComponentProblem> split_components(const Components& components,
                                               std::span<const std::uint32_t> anchors);

/// A component's deltas, from those of the graph, which must outlive this; copied where they do not follow
/// each other.
class ComponentDeltas {
 public:
  ComponentDeltas(const DeltaView& all, const VertexSubset& vertices);
  ComponentDeltas(const ComponentDeltas&) = delete;
  ComponentDeltas& operator=(const ComponentDeltas&) = delete;

  const DeltaView& view() const noexcept { return view_; }

 private:
  LargeVector<LongSymbols> symbols_;
  std::vector<Vec3> values_;
  DeltaView view_;
};

}  // namespace deltamesh
