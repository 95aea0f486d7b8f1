// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours between files: PLY, OBJ, OFF and STL hold what a screen shows, glTF linear light.
#pragma once

#include <vector>

#include "deltamesh/io.h"

namespace deltamesh {

/// `mesh` with its colours of 3 or 4 components as linear light. Bytes become 16 bits, which tell all 256
/// apart; all other types become float32. `kept` owns what was converted, and must outlive the view.
MeshView with_linear_colors(const MeshView& mesh, std::vector<Attribute>& kept);

/// The same as a screen shows them. Bytes stay bytes; 16 bits become bytes where with_linear_colors() would
/// make these 16 bits of them, and stay 16 bits otherwise; all other types become float32. `report` is told
/// how many vertices have a colour that the way back would change.
MeshView with_shown_colors(const MeshView& mesh, std::vector<Attribute>& kept, WriteReport& report);

/// Float colours that are written as numbers up to 255: whole numbers become bytes, others are divided by
/// 255, and `report` is told. Largest values of 1 to 16 that are not whole are taken for bright ones.
void settle_range(Attribute& color, ReadReport& report);

}  // namespace deltamesh
