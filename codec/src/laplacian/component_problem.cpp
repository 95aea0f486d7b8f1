// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/component_problem.h"

#include <bit>

#include "topology/subgraph.h"

namespace deltamesh {

std::vector<Vec3> ComponentProblem::pick_targets(std::span<const Vec3> all) const {
  std::vector<Vec3> targets;
  targets.reserve(numbers.size());
  for (const std::uint32_t number : numbers) targets.push_back(all[number]);
  return targets;
}

std::vector<ComponentProblem> split_components(const Components& components,
                                               std::span<const std::uint32_t> anchors) {
  std::vector<ComponentProblem> problems(components.count);
  std::uint32_t number = 0;
  for_each_run(components, [&](std::uint32_t begin, std::uint32_t end, std::uint32_t component) {
    ComponentProblem& problem = problems[component];
    const auto row = static_cast<std::uint32_t>(problem.vertices.size());
    problem.vertices.append(begin, end);
    for (; number < anchors.size() && anchors[number] < end; ++number) {
      problem.anchors.push_back(anchors[number] - begin + row);
      problem.numbers.push_back(number);
    }
  });
  return problems;
}

ComponentDeltas::ComponentDeltas(const DeltaView& all, const VertexSubset& vertices) {
  const auto& runs = vertices.runs();
  if (runs.size() == 1) {
    view_ = all.part(runs.front().begin, runs.front().size());
    return;
  }
  for (const auto& run : runs) {
    for (std::uint32_t vertex = run.begin; vertex < run.end; ++vertex) {
      if (all.has_symbols()) {
        symbols_.push_back(std::bit_cast<LongSymbols>(all.symbols()[vertex]));
      } else {
        values_.push_back(all[vertex]);
      }
    }
  }
  view_ = all.has_symbols() ? DeltaView(SymbolView(symbols_), all.scale()) : DeltaView(values_);
}

}  // namespace deltamesh
