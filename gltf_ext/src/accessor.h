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

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "document.h"

namespace deltamesh::gltf {

/// Scalar, vectors and component types that both an accessor and a stream's attribute can have.
struct AccessorShape {
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;
  bool normalized = false;
  std::uint64_t count = 0;

  std::size_t row_size() const noexcept { return components * component_size(type); }
};

/// glTF's number for a component type; 0 where it has none.
int gltf_component_type(ComponentType type) noexcept;

/// Nothing for matrices and component types that core glTF does not know. Errors: kInvalidFile.
Result<std::optional<AccessorShape>> accessor_shape(const Document& document, std::size_t accessor);

/// Bytes of a buffer view; `stride` 0: rows are packed.
struct ViewBytes {
  std::span<const std::byte> bytes;
  std::size_t stride = 0;
};

/// Nothing where the bytes are not plain: an opaque buffer, or a view with an extension. Errors: kInvalidFile
/// (no such view or buffer, beyond the buffer's end).
Result<std::optional<ViewBytes>> view_bytes(const Document& document, std::uint64_t view);

/// The rows of an accessor, checked to lie in the buffer.
class AccessorRows {
 public:
  AccessorRows(const AccessorShape& shape, std::span<const std::byte> bytes, std::size_t stride) noexcept
      : shape_(shape), bytes_(bytes), stride_(stride) {}
  /// Packed rows that the object owns.
  AccessorRows(const AccessorShape& shape, std::vector<std::byte> dense) noexcept
      : shape_(shape), dense_(std::move(dense)), bytes_(dense_), stride_(shape.row_size()) {}
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

/// Sparse accessors over a view are resolved. Nothing where the shape is none of ours, where the data is not
/// plain, or where there is no view at all: what is returned is never larger than the file. Errors:
/// kInvalidFile.
Result<std::optional<AccessorRows>> read_accessor(const Document& document, std::size_t accessor);

/// An unsigned integer of 1, 2 or 4 bytes, little-endian.
std::uint32_t read_index(std::span<const std::byte> row) noexcept;

}  // namespace deltamesh::gltf
