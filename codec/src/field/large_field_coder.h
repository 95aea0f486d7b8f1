// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Three numbers at every vertex of a large graph: less is known of each than in a FieldCoder, in a third of
// the time [FLD-9 to FLD-12]. One template for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "entropy/quick_number.h"
#include "field/field_coder.h"
#include "field/large_field_forecast.h"
#include "field/large_field_walk.h"

namespace deltamesh {

/// Fields of so many vertices are large where their rule says so [FLD-9].
inline constexpr std::uint32_t kFewestOfLargeField = 1U << 17;

/// Codes the vertices from `begin` to `end` in two walks that take turns. `Coder` is PairReader or
/// PairWriter. `graph` must outlive the coder.
template <class Coder>
class LargeFieldCoder {
 public:
  LargeFieldCoder(Coder& coder, const Adjacency& graph, std::uint32_t begin, std::uint32_t end)
      : coder_(coder),
        first_(graph, begin, middle_of(end - begin)),
        second_(graph, begin + middle_of(end - begin), (end - begin) / 2),
        numbers_(coder, kLargeFieldModels, kLargeFieldTails) {}

  /// Codes the numbers `q` of the next vertex of the first walk and `p` of the second; a reader fills them
  /// in. False where one is beyond kLargestFieldValue [FLD-1].
  bool code_pair(std::uint32_t first, std::uint32_t second, FieldNumbers& q, FieldNumbers& p) {
    LargeFieldVertex a(first_, first);
    LargeFieldVertex b(second_, second);
    Held coder = coder_;
    const bool is_valid = code_axis<0, 0>(coder, a, q) && code_axis<0, 1>(coder, b, p) &&
                          code_axis<1, 0>(coder, a, q) && code_axis<1, 1>(coder, b, p) &&
                          code_axis<2, 0>(coder, a, q) && code_axis<2, 1>(coder, b, p);
    give_back(coder);
    first_.remember(first, a.numbers(), a.around());
    second_.remember(second, b.numbers(), b.around());
    return is_valid;
  }

  /// The same for the last vertex of the first walk, where the second has none.
  bool code_last(std::uint32_t vertex, FieldNumbers& q) {
    LargeFieldVertex a(first_, vertex);
    return code_axis<0, 0>(coder_, a, q) && code_axis<1, 1>(coder_, a, q) && code_axis<2, 0>(coder_, a, q);
  }

 private:
  /// What a pair is coded with: a reader's copy, which a compiler can keep in registers, or a writer.
  using Held = std::conditional_t<Coder::kWrites, Coder&, Coder>;
  void give_back(const Coder& coder) noexcept {
    if constexpr (!Coder::kWrites) coder_ = coder;
  }

  template <unsigned kAxis, unsigned kState>
  [[gnu::always_inline]] bool code_axis(Coder& coder, LargeFieldVertex& vertex, FieldNumbers& numbers) {
    const LargeFieldForecast f = vertex.template forecast<kAxis>();
    std::int64_t coded = 0;
    if constexpr (Coder::kWrites) coded = ((std::int64_t{numbers[kAxis]} - f.base) ^ f.sign) - f.sign;
    bool is_far = false;
    coded = numbers_.template code<kState>(coder, coded, f.shift, f.model, f.tail, is_far);
    const std::int64_t number = ((coded ^ f.sign) - f.sign) + f.base;
    if (is_far && (number < -kLargestFieldValue || number > kLargestFieldValue)) return false;
    numbers[kAxis] = static_cast<std::int32_t>(number);
    vertex.template settle<kAxis>(numbers[kAxis]);
    return true;
  }

  Coder& coder_;
  LargeFieldWalk first_;
  LargeFieldWalk second_;
  QuickNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
