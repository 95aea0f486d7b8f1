// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Smooth random fields.
#pragma once

#include <cstdint>

#include "point.h"
#include "random.h"

namespace deltamesh::scenes {

/// A number in [-1, 1) for an integer place: white noise.
double place_noise(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) noexcept;

/// Value noise in (-1, 1), features about one unit in size, twice differentiable. About 30 ns.
double smooth_noise(const Point& p, std::uint64_t seed) noexcept;

/// Sum of `octaves` smooth noises, each of half the size and half the height of the one before; in (-2, 2).
double fractal_noise(const Point& p, int octaves, std::uint64_t seed) noexcept;

/// The same with crests where a noise changes its sign, finer features weaker in the valleys, as erosion
/// leaves them; in (0, 2).
double ridged_noise(const Point& p, int octaves, std::uint64_t seed) noexcept;

}  // namespace deltamesh::scenes
