// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How different two colours look.
#pragma once

#include <array>

namespace deltamesh {

/// CIEDE2000 of two colours as a screen shows them (sRGB under D65), components from 0 to 1; 1 is about what
/// an eye can tell. Source: Sharma, Wu, Dalal 2005, "The CIEDE2000 color-difference formula".
double color_difference(const std::array<double, 3>& a, const std::array<double, 3>& b) noexcept;

}  // namespace deltamesh
