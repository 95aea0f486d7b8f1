// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions.h"

#include <algorithm>

#include "base/component.h"

namespace deltamesh::gltf {

std::array<float, 3> position_of(const AccessorRows& rows, std::uint64_t i) noexcept {
  const AccessorShape& shape = rows.shape();
  std::array<float, 3> position{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::byte* component = rows.row(i).data() + k * component_size(shape.type);
    position[k] = static_cast<float>(load_component(shape.type, component));
    if (shape.normalized)
      position[k] = std::max(position[k] / static_cast<float>(normalized_one(shape.type)), -1.0F);
  }
  return position;
}

}  // namespace deltamesh::gltf
