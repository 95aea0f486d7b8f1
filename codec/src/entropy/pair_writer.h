// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Writes what PairReader reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/compact_writer.h"
#include "entropy/quick_models.h"

namespace deltamesh {

/// The functions have the names and the results of PairReader's; each returns its first argument. States take
/// turns: who calls must name the one that is at turn.
class PairWriter {
 public:
  static constexpr bool kWrites = true;

  /// `value` below 16.
  template <unsigned kState>
  unsigned symbol(unsigned value, const LowBits& low, const QuickModel& model) {
    writer_.decide(model.interval(value), low);
    return value;
  }

  /// At most kMostBitsAtOnce bits.
  template <unsigned kState>
  std::uint32_t bits(std::uint32_t value, unsigned count) {
    return writer_.bits(value, count);
  }

  std::vector<std::byte> finish() { return writer_.finish_long(); }
  void reserve(std::size_t decisions) { writer_.reserve(decisions); }

 private:
  CompactWriter writer_;
};

}  // namespace deltamesh
