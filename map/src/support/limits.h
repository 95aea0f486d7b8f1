// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Ranges that spec/map.md gives.
#pragma once

#include <cstddef>
#include <cstdint>

namespace deltamesh {

inline constexpr int kLeastStepExponent = -40;                           // [MAP-2]
inline constexpr int kMostStepExponent = 20;                             // [MAP-2]
inline constexpr std::uint32_t kMostCellSteps = std::uint32_t{1} << 24;  // [MAP-3]
inline constexpr std::size_t kMostNameBytes = 255;                       // [MAP-5]
inline constexpr std::size_t kMostPartOctets = std::size_t{1} << 16;     // [MAP-7]
inline constexpr std::uint64_t kPartElementsPerByte = 32;                // [MAP-7]
inline constexpr std::size_t kMostLinks = 4096;                          // [MAP-12]
inline constexpr std::uint32_t kOthersInPlace = 1;                       // [MAP-13]
inline constexpr std::uint32_t kCopiesInPlace = 2;                       // [MAP-13]
inline constexpr std::size_t kMostPrimers = 255;                         // [MAP-6]
inline constexpr std::size_t kMostMapAttributes = 255;                   // [MAP-5]

}  // namespace deltamesh
