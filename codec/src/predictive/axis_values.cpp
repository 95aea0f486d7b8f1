// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/axis_values.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace deltamesh {
namespace {

constexpr std::size_t kFew = 2048;
constexpr std::size_t kFewestRepeats = kFew / 25;

constexpr unsigned kDigits = 3;
constexpr unsigned kDigitBits = 11;
constexpr std::uint32_t kDigitValues = 1U << kDigitBits;

/// Ascends as floats do.
std::uint32_t key_of(double value) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
  return bits ^ ((0U - (bits >> 31)) | 0x80000000U);
}
float value_of(std::uint32_t key) noexcept {
  return std::bit_cast<float>(key ^ (((key >> 31) - 1U) | 0x80000000U));
}

constexpr std::uint32_t digit_of(std::uint32_t key, unsigned digit) noexcept {
  return key >> (digit * kDigitBits) & (kDigitValues - 1);
}

}  // namespace

std::vector<float> sort_values(std::span<const Vec3> positions, std::size_t axis, std::size_t stride) {
  std::vector<std::uint32_t> keys;
  keys.reserve(positions.size() / stride + 1);
  std::array<std::array<std::uint32_t, kDigitValues>, kDigits> places{};
  for (std::size_t v = 0; v < positions.size(); v += stride) {
    const std::uint32_t key = key_of(positions[v][axis]);
    keys.push_back(key);
    for (unsigned digit = 0; digit < kDigits; ++digit) ++places[digit][digit_of(key, digit)];
  }
  std::vector<std::uint32_t> next(keys.size());
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    std::uint32_t sum = 0;
    for (std::uint32_t& place : places[digit]) {
      const std::uint32_t count = place;
      place = sum;
      sum += count;
    }
    for (const std::uint32_t key : keys) next[places[digit][digit_of(key, digit)]++] = key;
    keys.swap(next);
  }
  std::vector<float> values(keys.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value_of(keys[i]);
  return values;
}

const std::vector<float>& AxisValues::few(std::size_t axis) const {
  if (few_[axis].empty()) {
    const std::size_t stride = std::max<std::size_t>(positions_.size() / kFew, 1);
    few_[axis] = sort_values(positions_.first(std::min(positions_.size(), kFew * stride)), axis, stride);
  }
  return few_[axis];
}

bool AxisValues::has_repeats(std::size_t axis) const {
  if (positions_.size() <= kFew) return true;
  const std::vector<float>& values = few(axis);
  std::size_t repeats = 0;
  for (std::size_t i = 1; i < values.size(); ++i) repeats += values[i] == values[i - 1] ? 1 : 0;
  return repeats >= kFewestRepeats;
}

std::size_t AxisValues::count_distances(std::size_t axis, double least, double most) const {
  const std::vector<float>& values = few(axis);
  std::size_t count = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double distance = double{values[i]} - values[i - 1];
    count += distance > least && distance < most ? 1 : 0;
  }
  return count;
}

std::span<const float> AxisValues::sorted(std::size_t axis) const {
  if (sorted_[axis].empty()) sorted_[axis] = sort_values(positions_, axis, stride_);
  return sorted_[axis];
}

}  // namespace deltamesh
