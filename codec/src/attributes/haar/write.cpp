// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "attributes/haar/coder.h"
#include "attributes/haar/haar.h"
#include "attributes/haar/values.h"
#include "base/byte_writer.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

/// Means of the values of every node, and the choice of numbers.
template <unsigned kAxes>
class HaarSource {
 public:
  HaarSource(std::span<const std::uint8_t> colors, std::span<const HaarLevel> levels)
      : means_(levels.size()) {
    means_[0].resize(levels[0].nodes.size());
    for (std::size_t v = 0; v < means_[0].size(); ++v) {
      const HaarValue value = haar_value_of({colors[3 * v], colors[3 * v + 1], colors[3 * v + 2]});
      for (std::size_t t = 0; t < kAxes; ++t) means_[0][v][t] = value[t];
    }
    for (std::size_t l = 1; l < levels.size(); ++l) join(levels[l - 1], levels[l], l);
    children_.reserve(levels.size());
    for (const HaarLevel& level : levels) children_.push_back(level.children.data());
  }

  std::int32_t root(std::size_t axis) const noexcept {
    return static_cast<std::int32_t>(std::floor(means_.back()[0][axis] + 0.5F));
  }

  /// Rate-distortion optimised quantisation: the number, one less in size, or 0, by squared error in steps
  /// and a tenth of the bits. `node` of `level` is that which is split.
  std::int64_t choose(std::size_t level, std::uint32_t node, std::size_t axis, std::int32_t expected,
                      std::uint32_t step, unsigned shift, const Mixture<2>& mixture) const noexcept {
    const HaarChildren& pair = children_[level][node];
    const float wanted = means_[level - 1][pair.first][axis] - means_[level - 1][pair.second][axis];
    const float steps = (wanted - static_cast<float>(expected)) / static_cast<float>(step);
    const auto nearest = static_cast<std::int64_t>(std::floor(std::abs(steps) + 0.5F));
    const std::int64_t sign = steps < 0 ? -1 : 1;
    if (shift > 0 || nearest == 0) return sign * nearest;
    std::int64_t best = nearest;
    float least = cost(steps, sign * nearest, mixture);
    for (const std::int64_t size : {nearest - 1, std::int64_t{0}}) {
      const float now = cost(steps, sign * size, mixture);
      if (now >= least) continue;
      least = now;
      best = size;
    }
    return sign * best;
  }

 private:
  using Mean = std::array<float, kAxes>;

  void join(const HaarLevel& fine, const HaarLevel& coarse, std::size_t l) {
    means_[l].resize(coarse.nodes.size());
    for (std::size_t i = 0; i < coarse.nodes.size(); ++i) {
      const HaarChildren& pair = coarse.children[i];
      means_[l][i] = means_[l - 1][pair.first];
      if (pair.second == HaarChildren::kNone) continue;
      const auto a = static_cast<float>(fine.nodes[pair.first].weight);
      const auto b = static_cast<float>(fine.nodes[pair.second].weight);
      const Mean& other = means_[l - 1][pair.second];
      for (std::size_t t = 0; t < kAxes; ++t)
        means_[l][i][t] = (means_[l][i][t] * a + other[t] * b) / (a + b);
    }
  }

  static float cost(float steps, std::int64_t number, const Mixture<2>& mixture) noexcept {
    constexpr float kPerBit = 0.1F;
    const float error = steps - static_cast<float>(number);
    return error * error + kPerBit * bits_of(number, mixture);
  }

  static float bits_of(std::int64_t number, const Mixture<2>& mixture) noexcept {
    constexpr std::int64_t kReach = 7;
    constexpr unsigned kEscape = 15;
    const std::int64_t size = std::abs(number);
    const unsigned symbol = size <= kReach ? static_cast<unsigned>(number + kReach) : kEscape;
    float bits = kProbabilityBits - log2_of(interval_of(mixture.starts(), symbol).size);
    if (symbol == kEscape) bits += 2 + 2 * log2_of(static_cast<std::uint64_t>(size - kReach + 1));
    return bits;
  }
  static float log2_of(std::uint64_t x) noexcept { return static_cast<float>(log_class<8>(x)) / 256; }

  std::vector<LargeVector<Mean>> means_;
  std::vector<const HaarChildren*> children_;
};

template <unsigned kAxes>
CodedValues<std::byte> write_haar_axes(std::span<const std::uint8_t> colors,
                                       std::span<const HaarLevel> levels, std::uint32_t step,
                                       ByteWriter& out) {
  CompactWriter writer;
  writer.reserve(kAxes * levels[0].nodes.size());
  const HaarSource<kAxes> source(colors, levels);
  HaarCoder<CompactWriter, kAxes, HaarSource<kAxes>> coder(writer, levels, step, source);
  const auto records = coder.run();
  out.write_bytes(writer.finish());
  return {.bytes = out.take(), .values = haar_colors(records, kAxes)};
}

bool is_grey(std::span<const std::uint8_t> colors) noexcept {
  bool grey = true;
  for (std::size_t i = 0; i + 2 < colors.size() && grey; i += 3)
    grey = colors[i] == colors[i + 1] && colors[i] == colors[i + 2];
  return grey;
}

}  // namespace

CodedValues<std::byte> write_haar_colors(std::span<const std::uint8_t> colors,
                                         std::span<const HaarLevel> levels, std::uint32_t step) {
  const bool grey = is_grey(colors);
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(grey ? 1 : kHaarAxes));
  out.write(static_cast<std::uint16_t>(step));
  if (levels[0].nodes.empty()) return {.bytes = out.take(), .values = {}};
  return grey ? write_haar_axes<1>(colors, levels, step, out) : write_haar_axes<3>(colors, levels, step, out);
}

}  // namespace deltamesh
