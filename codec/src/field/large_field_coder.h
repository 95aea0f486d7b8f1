// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Three numbers at every vertex of a large graph: less is known of each than in a FieldCoder, in a third of
// the time [FLD-9 to FLD-12]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>

#include "entropy/quick_number.h"
#include "field/field_classes.h"
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
    const LargeFieldForecasts f(first_, first_.peers(first), second_, second_.peers(second));
    Held coder = coder_;
    Before a;
    Before b;
    const bool is_valid = code_axis<0, 0, 0>(coder, f, a, q) && code_axis<0, 1, 1>(coder, f, b, p) &&
                          code_axis<1, 0, 0>(coder, f, a, q) && code_axis<1, 1, 1>(coder, f, b, p) &&
                          code_axis<2, 0, 0>(coder, f, a, q) && code_axis<2, 1, 1>(coder, f, b, p);
    give_back(coder);
    const auto memories = f.memories(q, p);
    first_.remember(first, memories[0]);
    second_.remember(second, memories[1]);
    return is_valid;
  }

  /// The same for the last vertex of the first walk, where the second has none.
  bool code_last(std::uint32_t vertex, FieldNumbers& q) {
    const LargeFieldPeers peers = first_.peers(vertex);
    const LargeFieldForecasts f(first_, peers, first_, peers);
    Before a;
    return code_axis<0, 0, 0>(coder_, f, a, q) && code_axis<1, 0, 1>(coder_, f, a, q) &&
           code_axis<2, 0, 0>(coder_, f, a, q);
  }

 private:
  /// What a pair is coded with: a reader's copy, which a compiler can keep in registers, or a writer.
  using Held = std::conditional_t<Coder::kWrites, Coder&, Coder>;
  void give_back(const Coder& coder) noexcept {
    if constexpr (!Coder::kWrites) coder_ = coder;
  }

  /// Of a vertex' axes that are coded.
  struct Before {
    std::array<std::int32_t, 2> signs{};
    std::uint32_t sizes = 0;  ///< of the parts of numbers that symbols stand for
  };

  template <unsigned kAxis, unsigned kVertex, unsigned kState>
  [[gnu::always_inline]] bool code_axis(Coder& coder, const LargeFieldForecasts& f, Before& before,
                                        FieldNumbers& numbers) {
    constexpr unsigned kLane = 4 * kVertex + kAxis;
    const std::int32_t base = f.base(kLane);
    std::size_t model = f.model(kLane);
    std::int32_t expected = 0;
    if constexpr (kAxis == 1) {
      expected = before.signs[0] * f.tie(kLane);
      model += kSizeClass[2 * before.sizes];
    }
    if constexpr (kAxis == 2) {
      expected = before.signs[0] * f.tie(kLane) + before.signs[1] * f.tie(kLane - 2);
      model +=
          kSizeClass[before.sizes] + 4 * f.sureness(kLane, static_cast<std::uint32_t>(std::abs(expected)));
    }
    const std::int32_t sign = expected >> 31;
    const unsigned shift = f.shift(kLane);
    const std::size_t tail = std::min(shift, 3U) * 4 + ((model >> 2) & 3);
    std::int64_t coded = 0;
    if constexpr (Coder::kWrites) coded = ((std::int64_t{numbers[kAxis]} - base) ^ sign) - sign;
    unsigned symbol = 0;
    coded = numbers_.template code<kState>(coder, coded, shift, model, tail, symbol);
    const std::int64_t number = ((coded ^ sign) - sign) + base;
    if (symbol == QuickNumberCoder<Coder>::kEscape &&
        (number < -kLargestFieldValue || number > kLargestFieldValue))
      return false;
    numbers[kAxis] = static_cast<std::int32_t>(number);
    if constexpr (kAxis < 2) {
      before.signs[kAxis] = (numbers[kAxis] >> 31) | (numbers[kAxis] != 0 ? 1 : 0);
      before.sizes += kSymbolSize[symbol];
    }
    return true;
  }

  /// How far from 0 a symbol is, an escape 8.
  static constexpr auto kSymbolSize = tabulate<std::uint8_t, kSymbols>(
      [](std::uint32_t symbol) { return symbol < 8 ? symbol + 1 : 15 - symbol; });
  static constexpr auto kSizeClass = tabulate<std::uint8_t, 17>(
      [](std::uint32_t size) { return (size >= 1 ? 1 : 0) + (size >= 4 ? 1 : 0) + (size >= 12 ? 1 : 0); });

  Coder& coder_;
  LargeFieldWalk first_;
  LargeFieldWalk second_;
  QuickNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
