// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which blocks have vertices at a position.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

#include "deltamesh/map/part_key.h"
#include "lattice/positions.h"
#include "split/stored_block.h"

namespace deltamesh {

/// A block in its part.
struct PlacedBlock {
  StoredBlock block{};
  PartKey part{};
};

/// A hash table with open addresses: of 1 million positions it takes 50 MB, just above a power of two twice
/// as much.
class PositionTable {
 public:
  /// Calls `visit` with every block that has the position.
  template <class Visit>
  void for_each_at(const PositionBits& position, Visit visit) const {
    if (slots_.empty()) return;
    for (std::size_t i = home_of(position); slots_[i].block != nullptr; i = next(i))
      if (slots_[i].position == position) visit(*slots_[i].block);
  }
  /// Makes room for so many more at once, in place of step by step.
  void reserve(std::size_t more) {
    if (2 * (count_ + more) > slots_.size()) grow_to(std::bit_ceil(2 * (count_ + more)));
  }
  /// O(1) expected, as removal; a block has a position once.
  void add(const PositionBits& position, const PlacedBlock& block) {
    if (2 * (count_ + 1) > slots_.size()) grow_to(std::max(kFewest, 2 * slots_.size()));
    put({position, &block});
    ++count_;
  }
  void remove(const PositionBits& position, const PlacedBlock& block) {
    std::size_t hole = home_of(position);
    while (slots_[hole].position != position || slots_[hole].block != &block) hole = next(hole);
    // What follows moves up, unless it would come before its home.
    for (std::size_t i = next(hole); slots_[i].block != nullptr; i = next(i)) {
      const std::size_t home = home_of(slots_[i].position);
      if (((i - home) & mask()) < ((i - hole) & mask())) continue;
      slots_[hole] = slots_[i];
      hole = i;
    }
    slots_[hole] = {};
    --count_;
  }

 private:
  static constexpr std::size_t kFewest = 64;

  struct Slot {
    PositionBits position{};
    const PlacedBlock* block = nullptr;
  };

  std::size_t mask() const noexcept { return slots_.size() - 1; }
  std::size_t next(std::size_t i) const noexcept { return (i + 1) & mask(); }
  std::size_t home_of(const PositionBits& position) const noexcept { return PositionHash{}(position)&mask(); }
  void put(const Slot& slot) {
    std::size_t i = home_of(slot.position);
    while (slots_[i].block != nullptr) i = next(i);
    slots_[i] = slot;
  }
  void grow_to(std::size_t size) {
    std::vector<Slot> before(size);
    before.swap(slots_);
    for (const Slot& slot : before)
      if (slot.block != nullptr) put(slot);
  }

  std::vector<Slot> slots_;  ///< a power of two of them
  std::size_t count_ = 0;
};

}  // namespace deltamesh
