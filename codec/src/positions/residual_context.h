// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Estimates the error of a prediction from the residuals of coded neighbours and the spread of its sources
// [POSN-5, POSN-6]. Integers only; shared by writer and reader.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/memory/large_vector.h"
#include "base/simd/eight_shorts.h"
#include "base/simd/four_floats.h"
#include "base/simd/four_ints.h"
#include "positions/blend/blend.h"

namespace deltamesh {

inline constexpr std::size_t kResidualModels = 2;
inline constexpr std::array<std::uint32_t, kResidualModels> kResidualContexts = {24 * 5 * 5, 24 * 5 * 3};
inline constexpr std::uint32_t kResidualWeightSets = 15;

/// Prediction of one axis.
struct ResidualPrediction {
  std::int64_t whole = 0;  ///< the expected coordinate
  unsigned shift = 0;      ///< low bits outside the symbol
  int scale_bits = 0;      ///< of the expected distance, 1/16 steps
  std::int64_t sign = 0;   ///< -1 where signs are swapped, else 0
  std::array<std::uint32_t, kResidualModels> contexts{};
  std::uint32_t weight_set = 0;
};

inline constexpr std::int32_t kLargestScale = (1 << 24) - 1;  ///< 1/16 steps

/// 4 floor(log2 x) and the two bits of x below its leading one, of every lane x to kLargestScale; no less for
/// larger ones, far below 0 for 0.
inline FourInts quarter_octaves(FourInts lanes) noexcept {
  // Such numbers are floats exactly, and these have it all in place.
  const auto floats = __builtin_convertvector(lanes, FourFloats);
  return (std::bit_cast<FourInts>(floats) >> 21) - 4 * 127;
}

/// The record kept of a coded vertex [POSN-5].
struct ResidualRecord {
  FourInts residual;   ///< x, y, z in 1/16 steps, clamped; 0
  FourInts magnitude;  ///< smoothed
};

inline constexpr std::int32_t kLargestResidual = 1 << 26;  ///< 1/16 steps

/// The prediction of a vertex and its context.
struct Outlook {
  Expectation expected;
  ResidualRecord means;   ///< of corners of known faces
  std::uint32_t sources;  ///< 0 none, 1 neighbours, 2 .. 4 one to three parallelograms
};

/// A vertex while it is coded: prediction() and learn() of the axes in order, where these are of use,
/// record().
class ResidualTurn {
 public:
  /// `least` and `most`: what coordinates may be.
  [[gnu::always_inline]] ResidualTurn(const Outlook& outlook, FourInts least, FourInts most) noexcept
      : whole_(outlook.expected.whole),
        offset_(outlook.expected.offset),
        magnitude_(outlook.means.magnitude),
        sources_(outlook.sources) {
    const FourInts rounded = (offset_ + 8) >> 4;
    nearest_ = smaller_lanes(larger_lanes(whole_ + rounded, least), most);
    const FourInts mean = offset_ - (rounded << 4) - (outlook.means.residual >> 2);
    sign_ = mean >> 31;

    const Terms& terms = kTerms[sources_];
    const FourInts& spread = outlook.expected.spread;
    FourInts scale = smooth_lanes(magnitude_, third_of_sum(magnitude_));  // below 2^28
    scale += (((scale + spread) >> 1) - scale) & terms.between;
    if (sources_ < 2) [[unlikely]]
      scale += (spread - scale) & (spread > scale);
    scale_ = scale + 1;

    // From here on four lanes for the one table's contexts, then four for the other's.
    constexpr EightShorts kNone{};
    const EightShorts octaves =
        smaller_lanes(pack_lanes(quarter_octaves(scale_), quarter_octaves(spread)), kNone + kLargestOctaves);
    scale_octaves_ = twice_low(octaves);
    shift_ = larger_lanes((scale_octaves_ >> 2) - (kSymbolBits - 1), kNone);
    const EightShorts within = octaves - (shift_ << 2);
    const EightShorts coarse = (within + EightShorts{0, 0, 0, 0, 2, 2, 2, 2}) >> 1;
    const EightShorts fine = within - EightShorts{4, 4, 4, 4, 3, 3, 3, 3};
    const EightShorts is_shifted = shift_ > 0;
    const EightShorts classes =
        smaller_lanes(larger_lanes(larger_lanes(coarse, fine), kNone), kNone + (kClasses - 1)) +
        (is_shifted & EightShorts{4, 4, 4, 4, 0, 0, 0, 0});
    const EightShorts near = pack_lanes((mean ^ sign_) - sign_, FourInts{});
    const EightShorts sure = (smaller_lanes(near, kNone + 8) >> 1) & ~is_shifted;
    contexts_ = classes * EightShorts{25, 25, 25, 25, 15, 15, 15, 15} + terms.contexts + sure;
  }

  /// The expected lattice point, as coordinates may be.
  FourInts nearest() const noexcept { return nearest_; }

  [[gnu::always_inline]] ResidualPrediction prediction(std::size_t axis) const noexcept {
    ResidualPrediction f;
    f.whole = nearest_[axis];
    f.sign = sign_[axis];
    f.scale_bits = (scale_octaves_[axis] >> 2) + 1;
    f.shift = static_cast<unsigned>(shift_[axis]);
    f.contexts = {static_cast<std::uint32_t>(contexts_[axis]),
                  static_cast<std::uint32_t>(contexts_[axis + 4])};
    // If the place between two coordinates says nothing, use the residuals of the axes before.
    if (f.shift > 0 && axis > 0) {
      const std::int64_t scale = std::min(scale_[axis], kLargestScale);
      const std::int64_t coded = axis == 1 ? off_[0] : (off_[0] + off_[1]) >> 1;
      f.contexts[0] += (4 * coded < scale ? 1U : 0U) + (coded >= 2 * scale ? 2U : 0U);
    }
    f.weight_set = static_cast<std::uint32_t>(axis) * 5 + sources_;
    return f;
  }

  [[gnu::always_inline]] void learn(std::size_t axis, std::int32_t coordinate,
                                    const ResidualPrediction& prediction) noexcept {
    if (axis < off_.size())
      off_[axis] = std::min(16 * std::abs(coordinate - prediction.whole), std::int64_t{kLargestResidual});
  }

  /// After learn() of all axes, or where the vertex was coded otherwise.
  [[gnu::always_inline]] ResidualRecord record(FourInts cell) const noexcept {
    const FourInts steps = cell - whole_;
    FourInts residual = (steps << 4) - offset_;
    // With few steps nothing is out of range, as offsets are below 2^26; many are clamped.
    constexpr std::int32_t kFew = 1 << 18;
    if (set_lanes(((steps + kFew) & ~(2 * kFew - 1)) != 0) != 0) [[unlikely]]
      residual = clamp_lanes((clamp_lanes(steps, 1 << 23) << 4) - offset_, kLargestResidual);
    const FourInts size = lane_sizes(residual);
    return {residual, sources_ == 0 ? size : smooth_lanes(size, magnitude_)};
  }

 private:
  static constexpr std::int16_t kSymbolBits = 6;  ///< of a distance in 1/16 steps that a symbol tells
  static constexpr std::int16_t kClasses = 24;
  static constexpr std::int16_t kLargestOctaves = 4 * 23 + 3;  ///< of kLargestScale

  /// Constants by Outlook::sources, 0 to 4.
  struct Terms {
    FourInts between;      ///< -1 where the spread's part is a half, else 0
    EightShorts contexts;  ///< and the axis
  };
  static constexpr std::array<Terms, 5> kTerms = [] {
    std::array<Terms, 5> terms{};
    for (std::int16_t sources = 0; sources < 5; ++sources) {
      const std::int32_t between = sources > 2 ? -1 : 0;
      const std::int16_t a = static_cast<std::int16_t>(5 * sources);
      const std::int16_t x = static_cast<std::int16_t>(3 * sources);
      const std::int16_t y = static_cast<std::int16_t>(x + 1);
      const std::int16_t z = static_cast<std::int16_t>(x + 2);
      terms[static_cast<std::size_t>(sources)] =
          Terms{.between = FourInts{between, between, between, between},
                .contexts = EightShorts{a, a, a, a, x, y, z, x}};
    }
    return terms;
  }();

  FourInts whole_;                   ///< as in Expectation
  FourInts offset_;                  ///< likewise
  FourInts magnitude_;               ///< mean of corners of known faces
  FourInts nearest_;                 ///< the expected lattice point, as coordinates may be
  FourInts sign_;                    ///< -1 where the vertex is likely below, else 0
  FourInts scale_;                   ///< what distance may be expected, 1/16 steps
  EightShorts scale_octaves_;        ///< its quarter_octaves(), twice
  EightShorts shift_;                ///< twice
  EightShorts contexts_;             ///< without how axes before turned out
  std::uint32_t sources_;            ///< as in Outlook
  std::array<std::int64_t, 2> off_;  ///< how far from there x and y turned out, 1/16 steps
};

/// Distances between vertices and what was expected of them.
class ResidualHistory {
 public:
  explicit ResidualHistory(std::uint32_t vertex_count) : records_(vertex_count) {}

  Outlook outlook(const Surroundings& around, const Expectation& expected) const noexcept {
    Outlook result{.expected = expected,
                   .means = {},
                   .sources = around.parallelogram_count > 0 ? std::min(around.parallelogram_count, 3U) + 1
                                                             : std::min(around.known_count, 1U)};
    if (around.known_count > 0)
      result.means = mean(around.known[0], around.known[around.known_count > 1 ? 1 : 0]);
    return result;
  }

  /// Mean record of the corners of a vertex' first two known faces, or of its only one, passed twice.
  [[gnu::always_inline]] ResidualRecord mean(const KnownFace& first, const KnownFace& second) const noexcept {
    const ResidualRecord a = sum(first);
    const ResidualRecord b = sum(second);
    return {(a.residual + b.residual) >> 2, (a.magnitude + b.magnitude) >> 2};
  }

  [[gnu::always_inline]] void end(std::uint32_t vertex, const ResidualTurn& turn, FourInts cell) noexcept {
    records_[vertex] = turn.record(cell);
  }
  /// Before the first vertex, where some will not be coded, as what they are is known.
  void clear() noexcept {
    std::fill(records_.begin(), records_.end(), ResidualRecord{FourInts{}, FourInts{}});
  }

 private:
  ResidualRecord sum(const KnownFace& face) const noexcept {
    const ResidualRecord& a = records_[face.a];
    const ResidualRecord& b = records_[face.b];
    return {a.residual + b.residual, a.magnitude + b.magnitude};
  }

  LargeVector<ResidualRecord> records_;
};

}  // namespace deltamesh
