// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sixteen 16-bit numbers handled at once: the inner loops of the compact coder, plain and for SSE2, with
// equal results.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace deltamesh {

inline constexpr unsigned kSymbols = 16;

using Lanes = std::array<std::int16_t, kSymbols>;

/// Where lanes are pulled to: those up to s to 0, the others to `goal`.
using Pulls = std::array<Lanes, kSymbols>;
constexpr Pulls make_pulls(std::int16_t goal) noexcept {
  Pulls pulls{};
  for (unsigned s = 0; s < kSymbols; ++s)
    for (unsigned i = s + 1; i < kSymbols; ++i) pulls[s][i] = goal;
  return pulls;
}

namespace plain {

/// lane += (pull - lane) >> rate
constexpr void pull_lanes(Lanes& lanes, const Lanes& pull, unsigned rate) noexcept {
  for (unsigned i = 0; i < kSymbols; ++i)
    lanes[i] = static_cast<std::int16_t>(lanes[i] + ((pull[i] - lanes[i]) >> rate));
}

/// Lanes that are summed up and searched.
class LaneSum {
 public:
  explicit constexpr LaneSum(const Lanes& lanes) noexcept : lanes_(lanes) {}

  /// Adds 2 * lanes * weights[k] / 2^16 for all k, rounded down each; lanes not negative.
  template <std::size_t K>
  constexpr void add_weighted(const std::array<const Lanes*, K>& lanes,
                              const std::array<std::uint16_t, K>& weights) noexcept {
    for (std::size_t k = 0; k < K; ++k) {
      for (unsigned i = 0; i < kSymbols; ++i) {
        const std::uint32_t twice = 2 * static_cast<std::uint32_t>((*lanes[k])[i]);
        lanes_[i] =
            static_cast<std::int16_t>(lanes_[i] + static_cast<std::int32_t>((twice * weights[k]) >> 16));
      }
    }
  }

  /// The last lane that is at most `value`; the lanes rise, the first is 0.
  constexpr unsigned find(std::int16_t value) const noexcept {
    unsigned found = 0;
    for (unsigned i = 1; i < kSymbols; ++i) found += lanes_[i] <= value ? 1 : 0;
    return found;
  }

  constexpr void store(Lanes& lanes) const noexcept { lanes = lanes_; }

 private:
  Lanes lanes_;
};

}  // namespace plain

#if defined(__SSE2__)

inline __m128i load_lanes(const Lanes& lanes, std::size_t half) noexcept {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(lanes.data() + 8 * half));
}
inline void store_lanes(Lanes& lanes, std::size_t half, __m128i value) noexcept {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(lanes.data() + 8 * half), value);
}

inline void pull_lanes(Lanes& lanes, const Lanes& pull, unsigned rate) noexcept {
  const __m128i shift = _mm_cvtsi32_si128(static_cast<int>(rate));
  for (std::size_t half = 0; half < 2; ++half) {
    const __m128i now = load_lanes(lanes, half);
    const __m128i way = _mm_sub_epi16(load_lanes(pull, half), now);
    store_lanes(lanes, half, _mm_add_epi16(now, _mm_sra_epi16(way, shift)));
  }
}

/// The same in registers.
class LaneSum {
 public:
  explicit LaneSum(const Lanes& lanes) noexcept : low_(load_lanes(lanes, 0)), high_(load_lanes(lanes, 1)) {}

  template <std::size_t K>
  void add_weighted(const std::array<const Lanes*, K>& lanes,
                    const std::array<std::uint16_t, K>& weights) noexcept {
    for (std::size_t k = 0; k < K; ++k) {
      const __m128i weight = _mm_set1_epi16(static_cast<std::int16_t>(weights[k]));
      low_ = _mm_add_epi16(low_, _mm_mulhi_epu16(_mm_slli_epi16(load_lanes(*lanes[k], 0), 1), weight));
      high_ = _mm_add_epi16(high_, _mm_mulhi_epu16(_mm_slli_epi16(load_lanes(*lanes[k], 1), 1), weight));
    }
  }

  unsigned find(std::int16_t value) const noexcept {
    const __m128i values = _mm_set1_epi16(value);
    const __m128i larger = _mm_packs_epi16(_mm_cmpgt_epi16(low_, values), _mm_cmpgt_epi16(high_, values));
    // One bit per lane that is larger; the one before the first of them is the last that is not.
    const auto bits = static_cast<unsigned>(_mm_movemask_epi8(larger)) | 1U << kSymbols;
    return static_cast<unsigned>(std::countr_zero(bits)) - 1;
  }

  void store(Lanes& lanes) const noexcept {
    store_lanes(lanes, 0, low_);
    store_lanes(lanes, 1, high_);
  }

 private:
  __m128i low_;
  __m128i high_;
};

#else

using plain::LaneSum;
using plain::pull_lanes;

#endif

}  // namespace deltamesh
