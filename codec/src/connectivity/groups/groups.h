// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// FGRP: the number of every face's group (its material or primitive). Absent where a mesh has no groups.
// NAMe: what files call the groups [FGRP-4]. For information: decoders may skip it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// `groups`: m numbers below kMostGroups, one for each coded face, or empty; `triangles`: m x 3 vertices of
/// the decoded mesh, below `vertex_count`. O(n + m).
/// Empty where there are no groups.
std::vector<std::byte> write_face_groups(std::vector<std::uint32_t> groups,
                                         std::span<const std::uint32_t> triangles,
                                         std::uint32_t vertex_count);

/// m group numbers; none from an empty payload. Errors: kTruncated, kInvalidStream [FGRP-*, CMP-3].
Result<std::vector<std::uint32_t>> read_face_groups(std::span<const std::byte> payload,
                                                    std::span<const std::uint32_t> triangles,
                                                    std::uint32_t vertex_count);

inline constexpr std::size_t kMostNameBytes = 255;
inline constexpr std::size_t kMostNamesBytes = std::size_t{1} << 24;  ///< of all names; else there are none

/// Longer names are cut. Empty where no group has a name, or where all take more than kMostNamesBytes.
std::vector<std::byte> write_group_names(std::span<const GroupName> names);

/// None where the payload is not what [FGRP-4] says.
std::vector<GroupName> read_group_names(std::span<const std::byte> payload);

}  // namespace deltamesh
