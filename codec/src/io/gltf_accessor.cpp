// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_accessor.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "base/checked.h"
#include "base/try.h"
#include "io/components.h"
#include "io/io_error.h"

namespace deltamesh {
namespace {

/// `count` elements of `size` bytes, `stride` apart.
struct Elements {
  std::span<const std::byte> bytes;
  std::size_t size = 0;
  std::size_t stride = 0;

  const std::byte* at(std::uint64_t i) const noexcept { return bytes.data() + i * stride; }
};

Result<Elements> find_elements(const GltfDocument& document, GltfBuffers buffers, int view_index,
                               std::uint64_t offset, std::uint64_t count, std::size_t size) {
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= document.views.size())
    return invalid_file("glTF: an accessor names a buffer view that does not exist");
  const GltfBufferView& view = document.views[static_cast<std::size_t>(view_index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= buffers.size())
    return invalid_file("glTF: a buffer view names a buffer that does not exist");
  const std::span<const std::byte> buffer = buffers[static_cast<std::size_t>(view.buffer)];
  if (saturating_add(view.offset, view.length) > buffer.size())
    return invalid_file("glTF: a buffer view reaches beyond its buffer");
  const std::uint64_t stride = view.stride == 0 ? size : view.stride;
  if (stride < size) return invalid_file("glTF: a byte stride smaller than the element");
  const std::uint64_t extent = count == 0 ? 0 : saturating_add(saturating_mul(stride, count - 1), size);
  if (saturating_add(offset, extent) > view.length)
    return invalid_file("glTF: an accessor reaches beyond its buffer view");
  return Elements{.bytes = buffer.subspan(view.offset + offset, extent), .size = size, .stride = stride};
}

/// Little-endian components to native ones.
void to_native(std::vector<std::byte>& values, std::size_t component) {
  if constexpr (std::endian::native == std::endian::little) return;
  for (auto at = values.begin(); at != values.end(); at += static_cast<std::ptrdiff_t>(component))
    std::reverse(at, at + static_cast<std::ptrdiff_t>(component));
}

std::uint32_t load_index(ComponentType type, const std::byte* from) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < component_size(type); ++i)
    value |= std::to_integer<std::uint32_t>(from[i]) << (8 * i);
  return value;
}

bool is_index_type(ComponentType type) noexcept {
  return type == ComponentType::kU8 || type == ComponentType::kU16 || type == ComponentType::kU32;
}

Result<void> apply_sparse(const GltfDocument& document, GltfBuffers buffers, const GltfAccessor& accessor,
                          std::size_t size, std::vector<std::byte>& values) {
  const GltfSparse& sparse = *accessor.sparse;
  if (sparse.count < 0 || sparse.index_offset < 0 || sparse.value_offset < 0 ||
      !is_index_type(sparse.index_type))
    return invalid_file("glTF: a sparse accessor with a negative number or indices that are not unsigned");
  const auto count = static_cast<std::uint64_t>(sparse.count);
  DELTAMESH_TRY(const Elements indices, find_elements(document, buffers, sparse.index_view,
                                                      static_cast<std::uint64_t>(sparse.index_offset), count,
                                                      component_size(sparse.index_type)));
  DELTAMESH_TRY(const Elements replacements,
                find_elements(document, buffers, sparse.value_view,
                              static_cast<std::uint64_t>(sparse.value_offset), count, size));
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint32_t index = load_index(sparse.index_type, indices.at(i));
    if (index >= accessor.count) return invalid_file("glTF: a sparse index beyond its accessor");
    std::memcpy(values.data() + index * size, replacements.at(i), size);
  }
  return {};
}

}  // namespace

Result<const GltfAccessor*> find_accessor(const GltfDocument& document, int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= document.accessors.size())
    return invalid_file("glTF: a primitive names an accessor that does not exist");
  return &document.accessors[static_cast<std::size_t>(index)];
}

Result<std::vector<std::byte>> read_accessor(const GltfDocument& document, GltfBuffers buffers,
                                             const GltfAccessor& accessor) {
  if (accessor.matrix && component_size(accessor.type) != 4)
    return invalid_file("glTF: matrices of small integers are not supported");
  const std::size_t size = accessor.components * component_size(accessor.type);
  std::vector<std::byte> values;
  if (accessor.view != GltfAccessor::kNone) {
    DELTAMESH_TRY(const Elements elements,
                  find_elements(document, buffers, accessor.view, accessor.offset, accessor.count, size));
    values.resize(accessor.count * size);
    for (std::uint64_t i = 0; i < accessor.count; ++i)
      std::memcpy(values.data() + i * size, elements.at(i), size);
  } else {
    values.resize(accessor.count * size);
  }
  if (accessor.sparse) DELTAMESH_CHECK(apply_sparse(document, buffers, accessor, size, values));
  to_native(values, component_size(accessor.type));
  return values;
}

Result<std::vector<std::uint32_t>> read_indices(const GltfDocument& document, GltfBuffers buffers,
                                                const GltfAccessor& accessor, std::uint64_t vertices) {
  if (!is_index_type(accessor.type) || accessor.components != 1)
    return invalid_file("glTF: indices that are not unsigned integers");
  DELTAMESH_TRY(const std::vector<std::byte> values, read_accessor(document, buffers, accessor));
  std::vector<std::uint32_t> indices(accessor.count);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = static_cast<std::uint32_t>(
        load_component(accessor.type, values.data() + i * component_size(accessor.type)));
    if (indices[i] >= vertices) return invalid_file("glTF: an index names a vertex that does not exist");
  }
  return indices;
}

}  // namespace deltamesh
