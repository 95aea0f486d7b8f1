// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Names of attributes and groups of faces: what they may be, and how writers tell groups apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "deltamesh/io.h"

namespace deltamesh {

/// UTF-8 (RFC 3629: shortest form, no surrogates), 1 to 255 bytes.
bool is_attribute_name(std::string_view name) noexcept;

/// One for every group of the mesh, no two alike: where a group has the names of one before, or none at all
/// while there are others, its `group` becomes or gets "group_N". Line ends and bytes that are not UTF-8
/// become '_'. Empty where the mesh has one group without names.
std::vector<GroupName> distinct_names(const MeshView& mesh);

/// The corners of the faces of each of `count` groups.
std::vector<std::vector<std::uint32_t>> corners_by_group(const MeshView& mesh, std::size_t count);

}  // namespace deltamesh
