// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/field_columns.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "base/try.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"
#include "field/field_coder.h"
#include "format/tags.h"

namespace deltamesh {
namespace {

constexpr std::size_t kGroup = 3;  ///< components of one field
using Numbers = std::array<std::int32_t, kGroup>;

constexpr std::size_t kMostAveraged = 16;

/// a / b rounded down, `b` above 0.
constexpr std::int64_t divide_down(std::int64_t a, std::int64_t b) noexcept {
  return a / b - (a % b < 0 ? 1 : 0);
}

struct Prediction {
  Numbers mean{};
  FieldHint hint;
};

/// The coded neighbours of `vertex` that count.
std::span<const std::uint32_t> coded_neighbors(const Adjacency& graph, std::uint32_t vertex) noexcept {
  const auto row = graph.of(vertex);
  std::size_t count = 0;
  while (count < row.size() && count < kMostAveraged && row[count] < vertex) ++count;
  return row.first(count);
}

/// The mean of the coded neighbours' numbers, rounded to the nearest, and how far they are from it; the
/// numbers of the vertex before where there are none [ATTR-9].
Prediction predict(const Adjacency& graph, std::uint32_t vertex, const std::vector<Numbers>& coded) noexcept {
  constexpr std::int32_t kWidest = 8191;
  constexpr std::int32_t kUnit = 16;
  const auto neighbors = coded_neighbors(graph, vertex);
  if (neighbors.empty()) return {.mean = vertex == 0 ? Numbers{} : coded[vertex - 1], .hint = {}};
  const auto count = static_cast<std::int64_t>(neighbors.size());
  Prediction prediction;
  for (std::size_t c = 0; c < kGroup; ++c) {
    std::int64_t sum = 0;
    for (const std::uint32_t neighbor : neighbors) sum += coded[neighbor][c];
    const auto mean = static_cast<std::int32_t>(divide_down(2 * sum + count, 2 * count));
    std::int32_t distance = 0;
    for (const std::uint32_t neighbor : neighbors)
      distance += std::min(std::abs(coded[neighbor][c] - mean), kWidest);
    prediction.mean[c] = mean;
    prediction.hint.spread[c] = distance * kUnit / static_cast<std::int32_t>(count);
    prediction.hint.offset[c] = static_cast<std::int32_t>(divide_down(kUnit * sum, count) - kUnit * mean);
  }
  return prediction;
}

/// Codes `axes` numbers per vertex; `numbers` are read by a writer and filled in by a reader. False where a
/// number is out of range.
template <class Coder, class Check>
bool code_group(Coder& coder, const Adjacency& graph, std::vector<Numbers>& numbers, unsigned axes,
                Check check) {
  FieldCoder<Coder> field(coder, graph);
  for (std::uint32_t v = 0; v < numbers.size(); ++v) {
    const Prediction prediction = predict(graph, v, numbers);
    Numbers residual{};
    for (std::size_t c = 0; c < axes; ++c) residual[c] = numbers[v][c] - prediction.mean[c];
    if (!field.code_vertex(v, residual, axes, &prediction.hint)) return false;
    for (std::size_t c = 0; c < axes; ++c) numbers[v][c] = prediction.mean[c] + residual[c];
    if (!check(numbers[v])) return false;
  }
  return true;
}

bool is_green_based(const FieldShape& shape, std::size_t first) noexcept {
  return shape.is_color && first == 0 && shape.components >= 3;
}

unsigned axes_of(const FieldShape& shape, std::size_t first) noexcept {
  return static_cast<unsigned>(std::min(kGroup, shape.components - first));
}

}  // namespace

std::vector<std::byte> write_field_columns(const FieldColumns& columns, const Adjacency& graph,
                                           const FieldShape& shape) {
  CompactWriter writer;
  std::vector<Numbers> numbers(graph.vertex_count());
  for (std::size_t first = 0; first < shape.components; first += kGroup) {
    const unsigned axes = axes_of(shape, first);
    for (std::size_t v = 0; v < numbers.size(); ++v) {
      for (std::size_t c = 0; c < axes; ++c) numbers[v][c] = static_cast<std::int32_t>(columns[first + c][v]);
      const auto [red, green, blue] = numbers[v];
      if (is_green_based(shape, first)) numbers[v] = {green, red - green, blue - green};
    }
    code_group(writer, graph, numbers, axes, [](const Numbers&) { return true; });
  }
  return writer.finish();
}

Result<FieldColumns> read_field_columns(std::span<const std::byte> bytes, const Adjacency& graph,
                                        const FieldShape& shape) {
  const auto invalid = [](const char* message) {
    return Error{
        .code = ErrorCode::kInvalidStream, .message = message, .rule = "ATTR-9", .chunk_tag = kTagAttribute};
  };
  if (shape.width > kWidestField) return invalid("an attribute too wide for the compact form");
  const std::int32_t limit = std::int32_t{1} << shape.width;
  CompactReader reader(bytes);
  FieldColumns columns(shape.components);
  std::vector<Numbers> numbers(graph.vertex_count());
  for (std::size_t first = 0; first < shape.components && !reader.failed(); first += kGroup) {
    const unsigned axes = axes_of(shape, first);
    const bool green_based = is_green_based(shape, first);
    for (std::size_t c = 0; c < axes; ++c) columns[first + c].resize(numbers.size());
    const bool fits = code_group(reader, graph, numbers, axes, [&](const Numbers& coded) {
      Numbers plain = coded;
      if (green_based) plain = {coded[1] + coded[0], coded[0], coded[2] + coded[0]};
      return !reader.failed() &&
             std::all_of(plain.begin(), plain.begin() + axes, [&](auto x) { return x >= 0 && x < limit; });
    });
    if (!fits) {
      if (reader.failed()) DELTAMESH_CHECK(reader.finish(kTagAttribute));
      return invalid("a symbol beyond its width");
    }
    for (std::size_t v = 0; v < numbers.size(); ++v) {
      const auto [a, b, c] = numbers[v];
      const Numbers plain = green_based ? Numbers{b + a, a, c + a} : numbers[v];
      for (std::size_t k = 0; k < axes; ++k) columns[first + k][v] = static_cast<std::uint64_t>(plain[k]);
    }
  }
  DELTAMESH_CHECK(reader.finish(kTagAttribute));
  return columns;
}

}  // namespace deltamesh
