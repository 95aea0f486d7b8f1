// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A source attribute's values by coded vertex.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "attributes/values.h"
#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// Does not own the arrays.
class AttributeRows {
 public:
  /// `order`: the row of `attribute` for every coded vertex, each below its number of rows.
  AttributeRows(const AttributeView& attribute, std::span<const std::uint32_t> order)
      : values_(attribute.values),
        order_(order),
        size_(component_size(attribute.type)),
        components_(attribute.components) {}

  std::size_t count() const noexcept { return order_.size(); }
  std::size_t components() const noexcept { return components_; }
  std::uint64_t bits(std::size_t row, std::size_t component) const noexcept {
    return load_component(values_.data() + (order_[row] * components_ + component) * size_, size_);
  }
  /// Calls `visit(row, bits)` for one component of every row.
  template <class Visit>
  void for_each(std::size_t component, Visit visit) const {
    with_fixed_size(size_, [&](auto size) {
      for (std::size_t row = 0; row < order_.size(); ++row)
        visit(row, load_component(values_.data() + (order_[row] * components_ + component) * size, size));
    });
  }
  /// components() values.
  const std::byte* row(std::size_t row) const noexcept {
    return values_.data() + order_[row] * components_ * size_;
  }
  /// One component of an f32 attribute.
  float number(std::size_t row, std::size_t component) const noexcept {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits(row, component)));
  }
  /// The first three components of an f32 attribute.
  Vec3 vector(std::size_t row) const noexcept {
    return widen(std::array{number(row, 0), number(row, 1), number(row, 2)});
  }

  /// All values, n x components x size, in coded order.
  std::vector<std::byte> gather() const {
    const std::size_t row = components_ * size_;
    std::vector<std::byte> values(count() * row);
    for (std::size_t i = 0; i < count(); ++i)
      std::memcpy(values.data() + i * row, values_.data() + order_[i] * row, row);
    return values;
  }
  /// The same of an f32 attribute, n x components.
  std::vector<float> gather_floats() const {
    std::vector<float> values(count() * components_);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = number(i / components_, i % components_);
    return values;
  }

 private:
  std::span<const std::byte> values_;
  std::span<const std::uint32_t> order_;
  std::size_t size_;
  std::size_t components_;
};

}  // namespace deltamesh
