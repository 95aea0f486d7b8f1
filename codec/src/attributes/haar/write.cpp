// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>
#include <cstdlib>
#include <utility>

#include "attributes/haar/coder.h"
#include "attributes/haar/values.h"
#include "attributes/haar/writer.h"
#include "base/byte_writer.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

/// The choice of numbers.
template <unsigned kAxes>
class HaarSource {
 public:
  /// Both must outlive the source.
  HaarSource(const HaarMeans& means, std::span<const HaarLevel> levels) : means_(means) {
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

  const HaarMeans& means_;
  std::vector<const HaarChildren*> children_;
};

void join_means(HaarMeans& means, std::span<const HaarLevel> levels, std::size_t l) {
  const HaarLevel& fine = levels[l - 1];
  const HaarLevel& coarse = levels[l];
  means[l].resize(coarse.nodes.size());
  for (std::size_t i = 0; i < coarse.nodes.size(); ++i) {
    const HaarChildren& pair = coarse.children[i];
    means[l][i] = means[l - 1][pair.first];
    if (pair.second == HaarChildren::kNone) continue;
    const auto a = static_cast<float>(fine.nodes[pair.first].weight);
    const auto b = static_cast<float>(fine.nodes[pair.second].weight);
    for (std::size_t t = 0; t < kHaarAxes; ++t)
      means[l][i][t] = (means[l][i][t] * a + means[l - 1][pair.second][t] * b) / (a + b);
  }
}

/// `values`: of the vertices.
HaarMeans means_of(LargeVector<HaarMean> values, std::span<const HaarLevel> levels) {
  HaarMeans means(levels.size());
  means[0] = std::move(values);
  for (std::size_t l = 1; l < levels.size(); ++l) join_means(means, levels, l);
  return means;
}

template <unsigned kAxes>
LargeVector<HaarRecord> write_haar_axes(CompactWriter& writer, const HaarMeans& means,
                                        std::span<const HaarLevel> levels, std::uint32_t step,
                                        const HaarModels* start) {
  const HaarSource<kAxes> source(means, levels);
  HaarCoder<CompactWriter, kAxes, HaarSource<kAxes>> coder(writer, levels, step, source, start);
  return coder.run([](std::size_t) {});
}

}  // namespace

HaarWriter::HaarWriter(HaarPicture picture, std::span<const HaarLevel> levels)
    : levels_(levels),
      fields_(picture.fields),
      components_(picture.components),
      values_(means_of(std::move(picture.values), levels)) {
  if (fields_.alpha == HaarAlpha::kCoded) alpha_ = means_of(std::move(picture.alpha), levels);
}

CodedValues<std::byte> HaarWriter::code(std::uint32_t step, ComponentType type,
                                        const HaarModels* start) const {
  HaarFields fields = fields_;
  fields.step = step;
  ByteWriter out;
  write_haar_fields(out, fields, components_);
  const auto rows = static_cast<std::uint32_t>(levels_[0].nodes.size());
  HaarValues values(type, components_, rows);
  if (rows > 0) {
    CompactWriter writer;
    writer.reserve(std::size_t{fields_.axes} * rows);
    const auto records = fields_.axes == 1
                             ? write_haar_axes<1>(writer, values_, levels_, step, start)
                             : write_haar_axes<kHaarAxes>(writer, values_, levels_, step, start);
    if (components_ == 1) {
      values.set_numbers(records, fields_.scale);
    } else {
      values.set_colors(records, fields_.axes);
    }
    if (fields_.alpha == HaarAlpha::kConstant) values.set_alpha(fields_.alpha_level);
    if (fields_.alpha == HaarAlpha::kCoded)
      values.set_alpha(write_haar_axes<1>(writer, alpha_, levels_, step, nullptr));
    out.write_bytes(writer.finish());
  }
  return {.bytes = out.take(), .values = values.take()};
}

}  // namespace deltamesh
