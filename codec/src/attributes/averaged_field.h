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
    const FieldNumbers prediction = predict(vertex, numbers);
    FieldNumbers& coded = numbers[vertex];
    FieldNumbers residual{};
    for (std::size_t c = 0; c < axes_; ++c) residual[c] = coded[c] - prediction[c];
    if (!field_.code_vertex(vertex, residual, axes_)) return false;
    for (std::size_t c = 0; c < axes_; ++c) coded[c] = prediction[c] + residual[c];
    return true;
  }

 private:
  static constexpr std::size_t kMostAveraged = 16;

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

  /// The mean of the coded neighbours' numbers, rounded to the nearest; the numbers of the vertex before
  /// where there are none.
  FieldNumbers predict(std::uint32_t vertex, std::span<const FieldNumbers> coded) const noexcept {
    const auto neighbors = coded_neighbors(vertex);
    if (neighbors.empty()) return vertex == 0 ? FieldNumbers{} : coded[vertex - 1];
    const auto count = static_cast<std::int64_t>(neighbors.size());
    FieldNumbers mean{};
    for (std::size_t c = 0; c < axes_; ++c) {
      std::int64_t sum = 0;
      for (const std::uint32_t neighbor : neighbors) sum += coded[neighbor][c];
      mean[c] = static_cast<std::int32_t>(divide_down(2 * sum + count, 2 * count));
    }
    return mean;
  }

  const Adjacency& graph_;
  unsigned axes_;
  FieldCoder<Coder> field_;
};

}  // namespace deltamesh
