// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Up to three whole numbers at every vertex of a graph, predicted by the mean of the neighbours that are
// coded already [ATTR-9]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "field/field_coder.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class AveragedFieldCoder {
 public:
  /// `axes`: 1 to 3; the other numbers are 0. `graph` must outlive the coder.
  AveragedFieldCoder(Coder& coder, const Adjacency& graph, unsigned axes)
      : graph_(graph), axes_(axes), field_(coder, graph) {}

  /// Codes numbers[vertex], those before it being coded, all at most 2^28 in size; a reader fills it in.
  /// False where a difference is beyond kLargestFieldValue.
  bool code_vertex(std::uint32_t vertex, std::span<FieldNumbers> numbers) {
    const Prediction prediction = predict(vertex, numbers);
    FieldNumbers& coded = numbers[vertex];
    FieldNumbers residual{};
    for (std::size_t c = 0; c < axes_; ++c) residual[c] = coded[c] - prediction.mean[c];
    if (!field_.code_vertex(vertex, residual, axes_, &prediction.hint)) return false;
    for (std::size_t c = 0; c < axes_; ++c) coded[c] = prediction.mean[c] + residual[c];
    return true;
  }

 private:
  static constexpr std::size_t kMostAveraged = 16;

  struct Prediction {
    FieldNumbers mean{};
    FieldHint hint;
  };

  /// a / b rounded down, `b` above 0.
  static constexpr std::int64_t divide_down(std::int64_t a, std::int64_t b) noexcept {
    return a / b - (a % b < 0 ? 1 : 0);
  }

  /// The coded neighbours of `vertex` that count.
  std::span<const std::uint32_t> coded_neighbors(std::uint32_t vertex) const noexcept {
    const auto row = graph_.of(vertex);
    std::size_t count = 0;
    while (count < row.size() && count < kMostAveraged && row[count] < vertex) ++count;
    return row.first(count);
  }

  /// The mean of the coded neighbours' numbers, rounded to the nearest, and how far they are from it; the
  /// numbers of the vertex before where there are none.
  Prediction predict(std::uint32_t vertex, std::span<const FieldNumbers> coded) const noexcept {
    constexpr std::int32_t kWidest = 8191;
    constexpr std::int32_t kUnit = 16;
    const auto neighbors = coded_neighbors(vertex);
    if (neighbors.empty()) return {.mean = vertex == 0 ? FieldNumbers{} : coded[vertex - 1], .hint = {}};
    const auto count = static_cast<std::int64_t>(neighbors.size());
    Prediction prediction;
    for (std::size_t c = 0; c < prediction.mean.size(); ++c) {
      std::int64_t sum = 0;
      for (const std::uint32_t neighbor : neighbors) sum += coded[neighbor][c];
      const auto mean = static_cast<std::int32_t>(divide_down(2 * sum + count, 2 * count));
      std::int32_t distance = 0;
      for (const std::uint32_t neighbor : neighbors)
        distance += std::min(std::abs(coded[neighbor][c] - mean), kWidest);
      prediction.mean[c] = mean;
      prediction.hint.spread[c] = distance * kUnit / static_cast<std::int32_t>(count);
      prediction.hint.offset[c] =
          static_cast<std::int32_t>(divide_down(kUnit * sum, count) - std::int64_t{kUnit} * mean);
    }
    return prediction;
  }

  const Adjacency& graph_;
  unsigned axes_;
  FieldCoder<Coder> field_;
};

}  // namespace deltamesh
