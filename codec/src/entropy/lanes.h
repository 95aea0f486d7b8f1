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

struct alignas(16) Lanes : std::array<std::int16_t, kSymbols> {};

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
constexpr void pull_lanes(std::int16_t* lanes, const Lanes& pull, unsigned rate) noexcept {
  for (unsigned i = 0; i < kSymbols; ++i)
    lanes[i] = static_cast<std::int16_t>(lanes[i] + ((pull[i] - lanes[i]) >> rate));
}

/// Lanes that are summed up and searched.
class LaneSum {
 public:
  explicit constexpr LaneSum(const Lanes& lanes) noexcept : lanes_(lanes) {}
  /// `lanes`: as many as there are symbols.
  explicit constexpr LaneSum(const std::int16_t* lanes) noexcept : lanes_() {
    for (unsigned i = 0; i < kSymbols; ++i) lanes_[i] = lanes[i];
  }

  /// Adds 2 * lanes * weights[k] / 2^16 for all k, rounded down each; lanes not negative, 16 each, the
  /// weights below 2^15, but for that of one alone.
  template <std::size_t K>
  constexpr void add_weighted(const std::array<const std::int16_t*, K>& lanes,
                              const std::array<std::uint16_t, 4>& weights) noexcept {
    for (std::size_t k = 0; k < K; ++k) {
      for (unsigned i = 0; i < kSymbols; ++i) {
        const std::uint32_t twice = 2 * static_cast<std::uint32_t>(lanes[k][i]);
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

  /// Into 16 numbers, aligned to 16 bytes.
  constexpr void store(std::uint16_t* lanes) const noexcept {
    for (unsigned i = 0; i < kSymbols; ++i) lanes[i] = static_cast<std::uint16_t>(lanes_[i]);
  }

 private:
  Lanes lanes_;
};

}  // namespace plain

#if defined(__SSE2__)

/// Lanes are aligned to 16 bytes.
inline __m128i load_lanes(const std::int16_t* lanes, std::size_t half) noexcept {
  return _mm_load_si128(reinterpret_cast<const __m128i*>(lanes + 8 * half));
}
inline void store_lanes(std::int16_t* lanes, std::size_t half, __m128i value) noexcept {
  _mm_store_si128(reinterpret_cast<__m128i*>(lanes + 8 * half), value);
}

inline void pull_lanes(std::int16_t* lanes, const Lanes& pull, unsigned rate) noexcept {
  const __m128i shift = _mm_cvtsi32_si128(static_cast<int>(rate));
  for (std::size_t half = 0; half < 2; ++half) {
    const __m128i now = load_lanes(lanes, half);
    const __m128i way = _mm_sub_epi16(load_lanes(pull.data(), half), now);
    store_lanes(lanes, half, _mm_add_epi16(now, _mm_sra_epi16(way, shift)));
  }
}

/// The same in registers.
class LaneSum {
 public:
  explicit LaneSum(const Lanes& lanes) noexcept : LaneSum(lanes.data()) {}
  /// `lanes`: as many as there are symbols.
  explicit LaneSum(const std::int16_t* lanes) noexcept
      : low_(load_lanes(lanes, 0)), high_(load_lanes(lanes, 1)) {}

  template <std::size_t K>
  [[gnu::always_inline]] void add_weighted(const std::array<const std::int16_t*, K>& lanes,
                                           const std::array<std::uint16_t, 4>& weights) noexcept {
    // Twice the weights, as a lane's double may be too large; twice that of one alone is too, by 2^16.
    __m128i twice = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(weights.data()));
    twice = _mm_unpacklo_epi16(twice, twice);
    twice = _mm_add_epi16(twice, twice);
    if constexpr (K == 1) {
      low_ = _mm_add_epi16(low_, load_lanes(lanes[0], 0));
      high_ = _mm_add_epi16(high_, load_lanes(lanes[0], 1));
    }
    add_one<0>(lanes[0], twice);
    if constexpr (K > 1) add_one<1>(lanes[1], twice);
    if constexpr (K > 2) add_one<2>(lanes[2], twice);
    if constexpr (K > 3) add_one<3>(lanes[3], twice);
  }

  [[gnu::always_inline]] unsigned find(std::int16_t value) const noexcept {
    const __m128i values = _mm_set1_epi16(value);
    const __m128i larger = _mm_packs_epi16(_mm_cmpgt_epi16(low_, values), _mm_cmpgt_epi16(high_, values));
    // One bit per lane that is larger; the one before the first of them is the last that is not.
    const auto bits = static_cast<unsigned>(_mm_movemask_epi8(larger)) | 1U << kSymbols;
    return static_cast<unsigned>(std::countr_zero(bits)) - 1;
  }

  [[gnu::always_inline]] void store(std::uint16_t* lanes) const noexcept {
    _mm_store_si128(reinterpret_cast<__m128i*>(lanes), low_);
    _mm_store_si128(reinterpret_cast<__m128i*>(lanes + 8), high_);
  }

 private:
  template <int kPlace>
  [[gnu::always_inline]] void add_one(const std::int16_t* lanes, __m128i twice) noexcept {
    const __m128i weight = _mm_shuffle_epi32(twice, 0x55 * kPlace);
    low_ = _mm_add_epi16(low_, _mm_mulhi_epu16(load_lanes(lanes, 0), weight));
    high_ = _mm_add_epi16(high_, _mm_mulhi_epu16(load_lanes(lanes, 1), weight));
  }

  __m128i low_;
  __m128i high_;
};

#else

using plain::LaneSum;
using plain::pull_lanes;

#endif

}  // namespace deltamesh
