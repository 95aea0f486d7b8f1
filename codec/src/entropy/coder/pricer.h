// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Computes what the compact coder would spend, in bits, for encoders that trade bytes for quality.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/numbers/portable_math.h"
#include "entropy/coder/model.h"

namespace deltamesh {

/// Learns like CompactWriter and keeps nothing; while a trial lasts, prices symbols and learns nothing.
class CompactPricer {
 public:
  static constexpr bool kWrites = true;

  /// From its making to its end all that is coded is only priced.
  class Trial {
   public:
    explicit Trial(CompactPricer& pricer) noexcept : pricer_(pricer) {
      pricer_.in_trial_ = true;
      pricer_.bits_ = 0;
    }
    ~Trial() { pricer_.in_trial_ = false; }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;
    float bits() const noexcept { return pricer_.bits_; }

   private:
    CompactPricer& pricer_;
  };
  Trial trial() noexcept { return Trial(*this); }

  template <std::size_t K>
  unsigned symbol(unsigned value, const Mixture<K>& mixture) noexcept {
    const Interval interval = interval_of(mixture.starts(), value);
    if (!spend(interval)) mixture.learn(value, interval.size);
    return value;
  }
  template <std::size_t K>
  unsigned symbol_and_bits(unsigned value, const LowBits& low, const Mixture<K>& mixture,
                           SymbolBits& bit_models) noexcept {
    if (low.count == 0) return symbol(value, mixture);
    const Interval interval = interval_of(mixture.starts(), value);
    InnerBit& model = bit_models[value];
    const std::uint32_t if_set = 0 - (low.value >> (low.count - 1));
    bits_ += static_cast<float>(low.count - 1);
    if (!spend(part_for_bit(interval, model.size_of_set(interval.size), if_set))) {
      model.learn(if_set);
      mixture.learn(value, interval.size);
    }
    return value;
  }
  template <class Model>
  bool bit(bool value, Model& model) noexcept {
    if (!spend(model.interval(value))) model.learn(value);
    return value;
  }
  std::uint32_t bits(std::uint32_t value, unsigned count) noexcept {
    bits_ += static_cast<float>(count);
    return value;
  }

 private:
  /// Whether this is a trial.
  bool spend(Interval interval) noexcept {
    if (in_trial_) bits_ += static_cast<float>(kProbabilityBits - portable_log2(interval.size));
    return in_trial_;
  }

  float bits_ = 0;
  bool in_trial_ = false;
};

}  // namespace deltamesh
