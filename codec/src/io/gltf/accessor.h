// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Reads accessors: shape, and one row at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "io/gltf/document.h"

namespace deltamesh::gltf {

/// What both an accessor and a stream's attribute can be: scalars, vectors, and matrices without padding.
struct AccessorShape {
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;
  bool normalized = false;
  bool is_matrix = false;
  std::uint64_t count = 0;

  std::size_t row_size() const noexcept { return components * component_size(type); }
  /// The same but for the count.
  bool same_rows(const AccessorShape& other) const noexcept {
    return type == other.type && components == other.components && normalized == other.normalized &&
           is_matrix == other.is_matrix;
  }
};

/// glTF's number for a component type; 0 where it has none.
int gltf_component_type(ComponentType type) noexcept;

/// Nothing for matrices whose columns are padded, and for types that core glTF does not know. Errors:
/// kInvalidFile.
Result<std::optional<AccessorShape>> accessor_shape(const Document& document, std::size_t accessor);

/// Bytes that the accessor has in buffers. Errors: kInvalidFile.
Result<std::uint64_t> stored_bytes(const Document& document, std::size_t accessor);

/// Bytes of a buffer view; `stride` 0: rows are packed.
struct ViewBytes {
  std::span<const std::byte> bytes;
  std::size_t stride = 0;
};

/// Nothing where the buffer is opaque. Errors: kInvalidFile (no such view or buffer, beyond the buffer's
/// end).
Result<std::optional<ViewBytes>> view_bytes(const Document& document, std::uint64_t view);

/// The rows of an accessor, checked to lie in the buffer.
class AccessorRows {
 public:
  AccessorRows(const AccessorShape& shape, std::span<const std::byte> bytes, std::size_t stride) noexcept
      : shape_(shape), bytes_(bytes), stride_(stride) {}
  /// Rows that the object owns, packed; or one row, where `stride` is 0, that stands for all.
  AccessorRows(const AccessorShape& shape, std::vector<std::byte> dense, std::size_t stride) noexcept
      : shape_(shape), dense_(std::move(dense)), bytes_(dense_), stride_(stride) {}
  AccessorRows(AccessorRows&&) noexcept = default;
  AccessorRows& operator=(AccessorRows&&) noexcept = default;

  const AccessorShape& shape() const noexcept { return shape_; }
  /// Precondition: `i` below shape().count.
  std::span<const std::byte> row(std::uint64_t i) const noexcept {
    return bytes_.subspan(static_cast<std::size_t>(i) * stride_, shape_.row_size());
  }

 private:
  AccessorShape shape_;
  std::vector<std::byte> dense_;
  std::span<const std::byte> bytes_;
  std::size_t stride_ = 0;
};

/// Sparse accessors are resolved; without a view, all rows are zero. Nothing where the shape is none of ours,
/// where the data is in an opaque buffer, or where there is no view and the count is above `zero_rows`: so
/// the caller bounds what a few bytes of JSON may stand for. Errors: kInvalidFile.
Result<std::optional<AccessorRows>> read_accessor(const Document& document, std::size_t accessor,
                                                  std::uint64_t zero_rows);

/// The first three components of row `i`: integers of a normalized accessor as the fractions that they stand
/// for. Precondition: there are as many.
Vec3 vector_at(const AccessorRows& rows, std::uint64_t i) noexcept;

/// Whether the shape is that of vertex indices.
bool is_index_shape(const AccessorShape& shape) noexcept;

/// An unsigned integer of 1, 2 or 4 bytes, little-endian.
std::uint32_t read_index(std::span<const std::byte> row) noexcept;

}  // namespace deltamesh::gltf
