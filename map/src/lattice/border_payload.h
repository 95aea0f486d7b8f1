// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The coded border of a part [MAP-11].
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "deltamesh/map/part.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "entropy/coder/learning.h"
#include "lattice/border_coder.h"

namespace deltamesh {

/// `stream`: what `mesh` was decoded from. Errors: those of Container::open().
Result<BorderView> view_border(std::span<const std::byte> stream, const Mesh& mesh,
                               const MapLattice& lattice);

/// `mesh`: as the part's stream has it; `border`: ascending by vertex of it. Empty where there is no border.
/// `start`: the models' first states.
std::vector<std::byte> write_border(const Mesh& mesh, const BorderView& view,
                                    std::vector<BorderVertex> border, const BorderModels& start);

/// `learning.start` is there. Errors: kInvalidStream [MAP-11], kTruncated.
Result<std::vector<BorderVertex>> read_border(std::span<const std::byte> bytes, const Mesh& mesh,
                                              const BorderView& view, const Learning<BorderModels>& learning);

}  // namespace deltamesh
