// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// New numbers for the elements of a list of which some are dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "io/gltf/json.h"

namespace deltamesh::gltf {

struct Renumbering {
  std::vector<std::size_t> old_of_new;
  std::vector<std::size_t> new_of_old;  ///< the largest value where the element is dropped
};

/// A pinned element keeps its number, used or not; the other used ones fill the lowest free numbers in their
/// order. A number below a pinned one that none is left for keeps its old element.
Renumbering renumber(const std::vector<bool>& used, const std::set<std::uint64_t>& pinned);

/// Puts the list in its new order.
void reorder(Json& list, const Renumbering& numbers);

}  // namespace deltamesh::gltf
