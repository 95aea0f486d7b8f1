// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// NAMe: what files call the groups of faces [FGRP-4]. For information: decoders may skip it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh {

inline constexpr std::size_t kMostNameBytes = 255;
inline constexpr std::size_t kMostNamesBytes = std::size_t{1} << 24;  ///< of all names; else there are none

/// Longer names are cut. Empty where no group has a name, or where all take more than kMostNamesBytes.
std::vector<std::byte> write_group_names(std::span<const GroupName> names);

/// None where the payload is not what [FGRP-4] says.
std::vector<GroupName> read_group_names(std::span<const std::byte> payload);

}  // namespace deltamesh
