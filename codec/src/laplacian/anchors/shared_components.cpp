// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/anchors/shared_components.h"

namespace deltamesh {

std::vector<std::uint8_t> shared_components(const Components& components,
                                            std::span<const std::uint32_t> anchors) {
  std::vector<std::uint32_t> count(components.count, 0);
  for (const std::uint32_t anchor : anchors) ++count[components.label[anchor]];
  std::vector<std::uint8_t> shared;
  for (const std::uint32_t anchor : anchors) shared.push_back(count[components.label[anchor]] > 1 ? 1 : 0);
  return shared;
}

}  // namespace deltamesh
