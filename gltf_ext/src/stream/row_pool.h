// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rows of equal length; equal ones can be found.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "stream/row_hash.h"

namespace deltamesh::gltf {

class RowPool {
 public:
  explicit RowPool(std::size_t row_size) : row_size_(row_size) {}

  std::uint32_t size() const noexcept { return size_; }
  std::span<const std::byte> row(std::uint32_t i) const noexcept {
    return std::span(bytes_).subspan(i * row_size_, row_size_);
  }

  /// The number of the new row. Precondition: fewer than 2^32 - 1 rows.
  std::uint32_t append(std::span<const std::byte> row) {
    bytes_.insert(bytes_.end(), row.begin(), row.end());
    return size_++;
  }

  /// The number of the first row that find_or_append() took with these bytes; new where there is none.
  std::uint32_t find_or_append(std::span<const std::byte> row) {
    if (2 * (size_ + std::size_t{1}) > slots_.size()) grow();
    std::uint32_t& slot = slots_[slot_of(row)];
    if (slot == kFree) slot = append(row);
    return slot;
  }

 private:
  static constexpr std::uint32_t kFree = ~std::uint32_t{0};

  /// The slot that has the row, or the free one where it belongs.
  std::size_t slot_of(std::span<const std::byte> row) const noexcept {
    std::size_t slot = static_cast<std::size_t>(hash_bytes(row)) & (slots_.size() - 1);
    while (slots_[slot] != kFree && !std::ranges::equal(this->row(slots_[slot]), row))
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow() {
    slots_.assign(std::max<std::size_t>(2 * slots_.size(), 16), kFree);
    for (std::uint32_t i = 0; i < size_; ++i) slots_[slot_of(row(i))] = i;
  }

  std::size_t row_size_;
  std::vector<std::byte> bytes_;
  std::uint32_t size_ = 0;
  std::vector<std::uint32_t> slots_;  ///< a power of two; more than half are free
};

}  // namespace deltamesh::gltf
