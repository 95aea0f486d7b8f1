// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/haar.h"
#include "attributes/lattice/lattice.h"
#include "attributes/models.h"
#include "attributes/rare/rare.h"

namespace deltamesh {

Result<std::vector<std::byte>> read_rare_values(AttributeCoding coding, std::span<const std::byte> bytes,
                                                const Attribute& shape, const AttributeSurface& surface,
                                                std::span<const JointRow> joints,
                                                const Learning<AttributeModels>& learning) {
  if (coding == AttributeCoding::kJoints) return read_joints(bytes, shape, surface);
  if (coding == AttributeCoding::kWeights) return read_weights(bytes, shape, surface, joints);
  if (coding == AttributeCoding::kMean)
    return read_haar_values(
        bytes, shape, surface,
        {mean_models(learning.start), learning.end != nullptr ? &learning.end->mean.emplace() : nullptr});
  return read_lattice(bytes, shape, surface);
}

}  // namespace deltamesh
