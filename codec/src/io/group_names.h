// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Names by which writers tell groups of faces apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deltamesh/io.h"

namespace deltamesh {

/// One for every group of the mesh, no two alike: where a group has the names of one before, or none at all
/// while there are others, its `group` becomes or gets "group_N". Line ends and bytes that are not UTF-8
/// become '_'. Empty where the mesh has one group without names.
std::vector<GroupName> distinct_names(const MeshView& mesh);

/// The corners of the faces of each of `count` groups.
std::vector<std::vector<std::uint32_t>> corners_by_group(const MeshView& mesh, std::size_t count);

}  // namespace deltamesh
