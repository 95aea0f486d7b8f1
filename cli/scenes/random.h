// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The scenes' own random numbers: the same on every machine, unlike the standard library's distributions.
#pragma once

#include <cstdint>

namespace deltamesh::scenes {

/// The finaliser of splitmix64 (Steele, Lea, Flood 2014): a bijection that scatters its input over 64 bits.
constexpr std::uint64_t scatter(std::uint64_t x) noexcept {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// The upper 53 bits as a number in [0, 1).
constexpr double unit_interval(std::uint64_t bits) noexcept {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// splitmix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(scatter(seed)) {}

  std::uint64_t bits() noexcept { return scatter(state_ += 0x9e3779b97f4a7c15U); }

  /// In [low, high).
  double between(double low, double high) noexcept { return low + (high - low) * unit_interval(bits()); }

  /// In 0 .. count - 1; `count` above 0. The bias of the remainder, below 2^-32, does not matter here.
  std::uint32_t below(std::uint32_t count) noexcept { return static_cast<std::uint32_t>(bits() % count); }

  bool chance(double probability) noexcept { return unit_interval(bits()) < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace deltamesh::scenes
