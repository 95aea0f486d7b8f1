// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Differences of a colour to what is expected, axis by axis, in steps of twice the bound and one [ATTR-50 ..
// ATTR-52].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "attributes/colors/memory.h"
#include "entropy/coder/split_number.h"
#include "entropy/coder/symbol_models.h"
#include "field/octave_class.h"

namespace deltamesh {

/// By scale, 64 more where it was shifted.
inline constexpr auto kScaleClass =
    tabulate<std::uint8_t, 128>([](std::uint32_t i) { return octave_class(i % 64) + (i >= 64 ? 4 : 0); });

/// By scale: floor(2^20 / (scale + 2)).
inline constexpr auto kSixteenthsOf =
    tabulate<std::uint32_t, 64>([](std::uint32_t scale) { return (1U << 20) / (scale + 2); });

inline constexpr std::uint32_t kLargestNear = 255;

/// By sixteenths of the scale: how far a mean is from 0, 0 to 5.
inline constexpr auto kSureness =
    tabulate<std::uint8_t, ((kLargestNear * kSixteenthsOf[0]) >> 16) + 1>([](std::uint32_t i) {
      return (i >= 2 ? 1 : 0) + (i >= 5 ? 1 : 0) + (i >= 10 ? 1 : 0) + (i >= 16 ? 1 : 0) + (i >= 27 ? 1 : 0);
    });

struct ColorNumberModels {
  static constexpr std::array<std::size_t, 2> kContexts = {28 * 6 * 4, 12 * 12 * 4};

  std::array<SymbolModels, 2> symbols{SymbolModels(kContexts[0], kFreshSplit),
                                      SymbolModels(kContexts[1], kFreshSplit)};
  std::array<MixWeights, 28> weights;
  SplitNumberModels numbers;
};

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class ColorNumbers {
 public:
  ColorNumbers(Coder& coder, const ColorShape& shape, ColorNumberModels start = {})
      : shape_(shape),
        units_(16 / static_cast<float>(shape.step())),
        numbers_(coder, start.numbers),
        models_(std::move(start)) {}

  ColorNumberModels models() const {
    ColorNumberModels learnt = models_;
    learnt.numbers = numbers_.models();
    return learnt;
  }

  /// Codes the levels of what was not copied, which `memory` tells, and remembers of all how they differ from
  /// what was expected.
  [[gnu::always_inline]] void code(Coder& coder, const ColorAround& around, ColorMemory& memory,
                                   ColorLevels& levels) {
    const bool is_coded = !was_copied(memory.outcome);
    const FourFloats size = around.sizes * 0.5F + around.spread * 0.625F;
    const float all = (size[0] + size[1]) + (size[2] + size[3]);
    FourFloats rests{};
    float tie = 0;  // what the axes before add to what is expected
    float coded = 0;
    for (unsigned a = 0; a < shape_.axes; ++a) {
      const int lane = static_cast<int>(a);
      float expected = around.expected[lane];
      expected += tie;
      expected = std::min(std::max(expected, 0.0F), static_cast<float>(shape_.top));
      if (is_coded) {
        const float scale = a == 0 ? 0.609375F * size[lane] + 0.1171875F * all
                                   : (0.5F * size[lane] + 0.1015625F * all) + 0.09375F * coded;
        levels[a] = code_level(coder, a, levels[a], expected, scale, coded, around.spread[lane]);
      }
      const auto level = static_cast<float>(levels[a]);
      const float error = level - around.expected[lane];
      rests[lane] = level - expected;
      tie = a == 0 ? error : (a == 1 ? (tie + error) * 0.5F : 0);
      const float rest = std::abs(rests[lane]);
      coded = a == 0 ? rest : (coded + rest) * 0.5F;
    }
    const FourFloats sizes = sizes_of(rests);
    memory.sizes = around.is_first ? sizes : sizes * 0.625F + around.sizes * 0.375F;
  }

 private:
  /// Four classes per octave of sixteenths of a step and 4, less 4 for each bit of `shift`, 0 to 23.
  std::size_t class_of(float levels, unsigned shift) const noexcept {
    constexpr std::uint32_t kMantissaBits = 23;
    constexpr std::int32_t kClassOf4 = 4 * (127 + 2);
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(levels * units_ + 4);
    const auto octaves = static_cast<std::int32_t>(bits >> (kMantissaBits - 2)) - kClassOf4;
    return static_cast<std::size_t>(std::clamp(octaves - 4 * static_cast<std::int32_t>(shift), 0, 23));
  }

  std::uint32_t steps(float levels) const noexcept { return static_cast<std::uint32_t>(levels * units_); }

  /// Returns the level as readers have it.
  [[gnu::always_inline]] std::int32_t code_level(Coder& coder, unsigned axis, std::int32_t level,
                                                 float expected, float scale, float coded, float spread) {
    const auto base = static_cast<std::int32_t>(expected + 0.5F);
    const float beyond = expected - static_cast<float>(base);
    const std::int32_t sign = beyond < 0 ? -1 : 0;
    const std::uint32_t whole = std::min(steps(scale), kMostScale) + 1;
    const unsigned shift = static_cast<unsigned>(std::bit_width(whole | 63)) - 6;
    const std::uint32_t short_scale = whole >> shift;
    const std::uint32_t near = steps(std::abs(beyond)) >> shift;
    const std::uint32_t sure = kSureness[(near * kSixteenthsOf[short_scale]) >> 16];
    const std::uint32_t scale_class = kScaleClass[short_scale + (shift > 0 ? 64 : 0)];
    const std::array<std::size_t, 2> contexts = {
        (scale_class * 6 + sure) * 4 + axis,
        (class_of(spread, shift) / 2 * 12 + class_of(coded, shift) / 2) * 4 + axis};
    const Mixture<2> mixture{{&models_.symbols[0][contexts[0]], &models_.symbols[1][contexts[1]]},
                             &models_.weights[scale_class / 4 * 4 + axis]};
    std::int64_t number = 0;
    if constexpr (Coder::kWrites) {
      const std::int32_t way = level - base;
      const std::int32_t size_of = (std::abs(way) + shape_.bound) / shape_.step();
      number = ((way < 0 ? -size_of : size_of) ^ sign) - sign;
    }
    number = numbers_.code(coder, number, shift, mixture);
    number = std::clamp<std::int64_t>((number ^ sign) - sign, -kMostSteps, kMostSteps);
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(base + number * shape_.step(), 0, shape_.top));
  }

  static constexpr std::uint32_t kMostScale = (1U << 21) - 1;
  static constexpr std::int64_t kMostSteps = 1 << 17;

  ColorShape shape_;
  float units_;
  SplitNumberCoder<Coder> numbers_;
  ColorNumberModels models_;  ///< but for those of numbers_
};

}  // namespace deltamesh
