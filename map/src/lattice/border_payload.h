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

/// `stream`: what `mesh` was decoded from. `base`: what the part is coded beside, or null; must outlive the
/// view. Errors: those of Container::open().
Result<BorderView> view_border(std::span<const std::byte> stream, const Mesh& mesh, const MapLattice& lattice,
                               const MapPart* base = nullptr);

/// The source's colours of one attribute at the border [MAP-24].
struct BorderColors {
  std::uint32_t step = 0;              ///< levels of 8 bits, at most kMostBorderStep; 0: as in the stream
  std::vector<std::uint8_t> levels{};  ///< by border vertex and component, where there is a step
};

/// `mesh`: as the part's stream has it; gets the border's colours. `border`: ascending by vertex of it. Empty
/// where there is no border. `start`: the models' first states. `colors`: of each attribute that is colours.
std::vector<std::byte> write_border(Mesh& mesh, const BorderView& view, std::vector<BorderVertex> border,
                                    const BorderModels& start, std::span<const BorderColors> colors);

/// Gives `mesh` the border's colours. `learning.start` is there. Errors: kInvalidStream [MAP-11, MAP-24],
/// kTruncated.
Result<std::vector<BorderVertex>> read_border(std::span<const std::byte> bytes, Mesh& mesh,
                                              const BorderView& view, const Learning<BorderModels>& learning);

}  // namespace deltamesh
