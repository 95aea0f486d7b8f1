// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is expected of the numbers of two vertices of a large field [FLD-11, FLD-12], and what will be
// remembered of them [FLD-10]. Integers only; shared by writer and reader. For both vertices at once, and
// without branches on the data.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/eight_shorts.h"
#include "base/pick_lanes.h"
#include "field/field_coder.h"
#include "field/large_field_walk.h"

namespace deltamesh {

inline constexpr std::size_t kLargeFieldModels = std::size_t{8} * 2 * 3 * 18 * 4 * 4;
inline constexpr std::size_t kLargeFieldTails = std::size_t{4} * 4;

/// By lane: 4 v + a is axis a of vertex v; every fourth one is not in use.
class LargeFieldForecasts {
 public:
  [[gnu::always_inline]] LargeFieldForecasts(const LargeFieldWalk& first_walk, const LargeFieldPeers& first,
                                             const LargeFieldWalk& second_walk,
                                             const LargeFieldPeers& second) noexcept {
    take_means(first_walk.sums(first), second_walk.sums(second));
    references_ = low_halves(first_walk.memory(first.last).numbers_and_sizes,
                             second_walk.memory(second.last).numbers_and_sizes);
    const auto if_close =
        reinterpret_cast<EightShorts>(sums_of_halves(mean_errors_, 8) < sums_of_halves(mean_sizes_, 5));
    const EightShorts size = choose_lanes(if_close, mean_errors_, mean_sizes_);
    const EightShorts tie = mean_ties_ & ~if_close;
    bases_ = references_ & if_close;
    ties_ = tie;
    const EightUnsigned scale = scales_of(reinterpret_cast<EightUnsigned>(size));
    const auto sixteenths = reinterpret_cast<EightShorts>(scale >> 4);
    const auto more_sixteenths = reinterpret_cast<EightShorts>((scale + (scale >> 2)) >> 3);
    sixteenths_ = sixteenths;
    more_sixteenths_ = more_sixteenths;
    const EightShorts shift =
        larger_lanes(quarter_octaves(reinterpret_cast<EightShorts>(scale)) >> 2, all_lanes(5)) - all_lanes(5);
    shifts_ = shift;
    const EightShorts size_class =
        larger_lanes(quarter_octaves(size + all_lanes(4)) - (shift << 2), all_lanes(8)) - all_lanes(8);
    const EightShorts tie_size = lane_sizes(tie);
    const EightShorts sure_of_y = ((tie_size > sixteenths) + (tie_size > more_sixteenths)) & kOnlyY;
    const EightShorts sure = (if_close & all_lanes(3)) - sure_of_y;
    models_ = of_vertices(first_model(first), first_model(second)) + kModelsOfAxes +
              (((size_class << 2) + sure) << 2);
  }

  unsigned shift(unsigned lane) const noexcept { return static_cast<std::uint16_t>(shifts_[lane]); }
  /// Less what the axes before will say: how large their numbers are, and for axis 2 how sure its sign is.
  std::size_t model(unsigned lane) const noexcept { return static_cast<std::uint16_t>(models_[lane]); }
  /// What is subtracted.
  std::int32_t base(unsigned lane) const noexcept { return bases_[lane]; }
  /// Between the axes 1 and 2, 0 and 1, 0 and 2.
  std::int32_t tie(unsigned lane) const noexcept { return ties_[lane]; }
  /// How sure one can be of a sign, 0 to 2.
  std::uint32_t sureness(unsigned lane, std::uint32_t tie_size) const noexcept {
    return (tie_size > static_cast<std::uint16_t>(sixteenths_[lane]) ? 1U : 0U) +
           (tie_size > static_cast<std::uint16_t>(more_sixteenths_[lane]) ? 1U : 0U);
  }

  /// What is to be remembered of both vertices, whose numbers are `q` and `p`.
  [[gnu::always_inline]] std::array<LargeFieldMemory, 2> memories(const FieldNumbers& q,
                                                                  const FieldNumbers& p) const noexcept {
    const EightShorts most = all_lanes(kLargeFieldCut);
    const EightShorts numbers = smaller_lanes(
        larger_lanes(pack_lanes(FourInts{q[0], q[1], q[2], 0}, FourInts{p[0], p[1], p[2], 0}), -most), most);
    const EightShorts errors = smaller_lanes(lane_sizes(numbers - references_), most);
    const EightShorts first = pick_lanes<1, 0, 0, 3, 5, 4, 4, 7>(numbers);
    const EightShorts second = pick_lanes<2, 1, 2, 3, 6, 5, 6, 7>(numbers);
    const EightShorts ties = ((lane_sizes(first + second) - lane_sizes(first - second)) << 1) + mean_ties_;
    const EightShorts sizes = rounded_means(lane_sizes(numbers) << 4, mean_sizes_) | kOneBehind;
    const EightShorts smooth_errors = rounded_means(errors << 4, mean_errors_);
    return {{{.numbers_and_sizes = low_halves(numbers, sizes),
              .ties_and_errors = low_halves(ties, smooth_errors)},
             {.numbers_and_sizes = high_halves(numbers, sizes),
              .ties_and_errors = high_halves(ties, smooth_errors)}}};
  }

 private:
  static constexpr EightShorts kOnlyY = {0, -1, 0, 0, 0, -1, 0, 0};
  static constexpr EightShorts kOneBehind = {0, 0, 0, 1, 0, 0, 0, 1};
  static constexpr EightShorts kModelsOfAxes = {0, 288, 576, 0, 0, 288, 576, 0};
  /// By how many are summed up: four times what makes means of sums.
  static constexpr std::array<std::uint64_t, 5> kFactors = [] {
    std::array<std::uint64_t, 5> factors{};
    for (std::uint64_t count = 1; count < factors.size(); ++count)
      factors[count] = 65535 / count * 0x0001'0001'0001'0001;
    return factors;
  }();

  static std::uint32_t first_model(const LargeFieldPeers& peers) noexcept {
    return ((std::clamp<std::uint32_t>(peers.degree, 3, 10) - 3) * 2 + (peers.last != 0 ? 1 : 0)) * 864;
  }

  static EightShorts of_vertices(std::uint32_t first, std::uint32_t second) noexcept {
    return low_halves(all_lanes(static_cast<std::int32_t>(first)),
                      all_lanes(static_cast<std::int32_t>(second)));
  }

  [[gnu::always_inline]] void take_means(const LargeFieldMemory& first,
                                         const LargeFieldMemory& second) noexcept {
    const EightShorts sizes = high_halves(first.numbers_and_sizes, second.numbers_and_sizes);
    const auto factors = std::bit_cast<EightUnsigned>(std::array<std::uint64_t, 2>{
        kFactors[static_cast<std::uint16_t>(sizes[3])], kFactors[static_cast<std::uint16_t>(sizes[7])]});
    const auto signed_factors = reinterpret_cast<EightShorts>(factors);
    mean_sizes_ = multiply_high_unsigned(sizes, signed_factors);
    mean_errors_ =
        multiply_high_unsigned(high_halves(first.ties_and_errors, second.ties_and_errors), signed_factors);
    mean_ties_ = multiply_high(low_halves(first.ties_and_errors, second.ties_and_errors),
                               reinterpret_cast<EightShorts>(factors >> 1));
  }

  /// (5 size + sum of all three sizes) >> 3.
  static EightUnsigned scales_of(EightUnsigned sizes) noexcept {
    const EightUnsigned pairs = sizes + pick_lanes<1, 0, 3, 2, 5, 4, 7, 6>(sizes);
    const EightUnsigned all = pairs + pick_lanes<2, 3, 0, 1, 6, 7, 4, 5>(pairs);
    return (sizes + ((sizes + all) >> 2)) >> 1;
  }

  EightShorts mean_sizes_;
  EightShorts mean_errors_;
  EightShorts mean_ties_;
  EightShorts references_;
  EightShorts models_;
  EightShorts shifts_;
  EightShorts bases_;
  EightShorts ties_;
  EightShorts sixteenths_;
  EightShorts more_sixteenths_;
};

}  // namespace deltamesh
