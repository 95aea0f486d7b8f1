// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_factored_group.h"

#include <utility>
#include <vector>

#include "base/try.h"

namespace deltamesh::multigrid {

Result<std::unique_ptr<FactoredGroup>> FactoredGroup::make(Group group) {
  auto factored = std::make_unique<FactoredGroup>();
  factored->group_ = std::move(group);
  DELTAMESH_TRY(factored->direct_, make_direct_solver(*factored->group_.graph, factored->group_.anchors));
  return factored;
}

Result<void> FactoredGroup::solve(const DeltaView& deltas, std::span<const Vec3> anchor_positions,
                                  std::span<Vec3> x) {
  std::vector<Vec3> own_deltas, targets;
  for (const std::uint32_t v : group_.vertices) own_deltas.push_back(deltas[v]);
  for (const std::uint32_t a : group_.anchor_of) targets.push_back(anchor_positions[a]);
  std::vector<Vec3> solution(group_.vertices.size());
  DELTAMESH_CHECK(direct_->solve(own_deltas, targets, solution));
  for (std::size_t i = 0; i < solution.size(); ++i) x[group_.vertices[i]] = solution[i];
  return {};
}

}  // namespace deltamesh::multigrid
