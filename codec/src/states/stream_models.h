// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The adaptive models at the end of a stream [CMP-16].
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "attributes/models.h"
#include "connectivity/faces/op_models.h"
#include "entropy/coder/learning.h"
#include "grid/grid_models.h"
#include "positions/lattice/coder.h"

namespace deltamesh {

/// Members are empty for parts that the stream does not have in the compact form.
struct StreamModels {
  std::optional<OpModels> ops;
  std::optional<LatticeModels> lattice;
  std::unique_ptr<GridModels> grid;
  std::vector<AttributeModels> attributes;
  std::uint32_t levels = 0;  ///< along a voxel's edge; 0 of a stream without

  const OpModels* of_ops() const noexcept { return ops ? &*ops : nullptr; }
  const LatticeModels* of_lattice() const noexcept { return lattice ? &*lattice : nullptr; }
  const AttributeModels* of_attribute(std::size_t attribute) const noexcept {
    return attribute < attributes.size() ? &attributes[attribute] : nullptr;
  }

  void limit_counts(std::uint8_t most) noexcept {
    if (ops) ops->limit_counts(most);
    if (lattice) lattice->limit_counts(most);
    if (grid) grid->limit_counts(most);
    for (AttributeModels& models : attributes) models.limit_counts(most);
  }
};

}  // namespace deltamesh
