// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The smallest form of a POSN payload among those a writer may choose.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "predictive/positions.h"

namespace deltamesh {

/// The payload in a given form.
using WritePositions = std::function<std::vector<std::byte>(const PositionForm&)>;

/// Tries the forms that `kind` has, one after the other: two to seven calls of `write`, one at effort 0. A
/// coding order costs a decoder time, so up to effort 7 it has to earn it.
std::vector<std::byte> write_smallest(const WritePositions& write, PositionKind kind, int effort);

}  // namespace deltamesh
