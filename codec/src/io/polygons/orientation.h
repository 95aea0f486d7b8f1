// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// On which side of a line a point lies, exactly.
#pragma once

#include <array>

namespace deltamesh {

using Vec2 = std::array<double, 2>;

/// 1 where a, b, c turn to the left, -1 to the right, 0 where they lie on a line: the sign of the determinant
/// of b - a and c - a. Exact where no product of two coordinates leaves the range of double.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c) noexcept;

}  // namespace deltamesh
