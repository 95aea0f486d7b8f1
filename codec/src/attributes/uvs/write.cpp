// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "attributes/prediction/pair_choice.h"
#include "attributes/uvs/coder.h"
#include "attributes/uvs/uvs.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

/// Coordinates so much larger than the bound are left to other codings: floats are too coarse for it.
constexpr double kMostRange = 0x1p18;

/// Of the bound: however a distance is computed, it is kept.
constexpr double kKeptDistance = 1 - 1e-12;

/// In size; infinity where one is not finite.
double largest(std::span<const float> uvs) noexcept {
  double most = 0;
  for (const float x : uvs)
    most = std::isnan(x) ? std::numeric_limits<double>::infinity()
                         : std::max(most, std::fabs(static_cast<double>(x)));
  return most;
}

/// Chooses what to code so that no coordinates are farther from the source's than the bound.
class UvChoice {
 public:
  using Coder = UvCoder<CompactWriter, UvChoice>;

  UvChoice(std::span<const float> uvs, double bound, double step) : uvs_(uvs), bound_(bound), step_(step) {}

  bool is_within(std::uint32_t vertex, TwoDoubles value) const noexcept {
    const TwoDoubles off = value - source(vertex);
    return std::sqrt(dot(off, off)) <= bound_;
  }

  NumberPair nearest(std::uint32_t vertex, TwoDoubles prediction) const noexcept {
    const TwoDoubles steps = (source(vertex) - prediction) / step_;
    return choose_pair({steps[0], steps[1]}, [&](const NumberPair& pair) {
      return is_within(vertex, Coder::at(prediction, pair, step_));
    });
  }

 private:
  TwoDoubles source(std::uint32_t vertex) const noexcept {
    return TwoDoubles{static_cast<double>(uvs_[std::size_t{2} * vertex]),
                      static_cast<double>(uvs_[std::size_t{2} * vertex + 1])};
  }

  std::span<const float> uvs_;
  double bound_;
  double step_;
};

}  // namespace

std::optional<CodedValues<float>> write_surface_uvs(std::span<const float> uvs, double max_distance,
                                                    const AttributeSurface& surface) {
  const double most = largest(uvs);
  // Rounding to floats takes half a unit in the last place of each coordinate.
  const double left = max_distance - most * 0x1p-23;
  if (!(left > 0) || !(most <= max_distance * kMostRange)) return std::nullopt;
  const auto step = static_cast<float>(left * 1.4142);  // below the square root of 2: the cell's diagonal
  if (!(step >= kLeastUvStep && step <= kMostUvStep)) return std::nullopt;
  CompactWriter writer;
  UvCoder coder(writer, surface, static_cast<double>(step),
                UvChoice(uvs, max_distance * kKeptDistance, static_cast<double>(step)));
  for (std::size_t i = 0; i < coder.count(); ++i)
    if (!coder.code(i)) return std::nullopt;
  return CodedValues<float>{.bytes = step_and_stream(step, writer.finish()),
                            .values = std::move(coder.values())};
}

}  // namespace deltamesh
