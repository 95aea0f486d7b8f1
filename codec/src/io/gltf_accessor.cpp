// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_accessor.h"

#include <cstring>

#include "base/checked.h"
#include "base/try.h"
#include "io/components.h"
#include "io/io_error.h"

namespace deltamesh {
namespace {

/// Elements that are `stride` bytes apart.
struct Elements {
  std::span<const std::byte> bytes;
  std::size_t stride = 0;

  const std::byte* at(std::uint64_t i) const noexcept { return bytes.data() + i * stride; }
};

Result<Elements> find_elements(const GltfDocument& document, GltfBuffers buffers, int view_index,
                               std::uint64_t offset, std::uint64_t count, std::size_t size) {
  if (view_index < 0 || static_cast<std::size_t>(view_index) >= document.model.bufferViews.size())
    return invalid_file("glTF: an accessor names a buffer view that does not exist");
  const tinygltf::BufferView& view = document.model.bufferViews[static_cast<std::size_t>(view_index)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= buffers.size())
    return invalid_file("glTF: a buffer view names a buffer that does not exist");
  const std::span<const std::byte> buffer = buffers[static_cast<std::size_t>(view.buffer)];
  if (saturating_add(view.byteOffset, view.byteLength) > buffer.size())
    return invalid_file("glTF: a buffer view reaches beyond its buffer");
  const std::uint64_t stride = view.byteStride == 0 ? size : view.byteStride;
  if (stride < size) return invalid_file("glTF: a byte stride smaller than the element");
  const std::uint64_t extent = count == 0 ? 0 : saturating_add(saturating_mul(stride, count - 1), size);
  if (saturating_add(offset, extent) > view.byteLength)
    return invalid_file("glTF: an accessor reaches beyond its buffer view");
  return Elements{.bytes = buffer.subspan(view.byteOffset + offset, extent), .stride = stride};
}

std::uint32_t load_index(ComponentType type, const std::byte* from) noexcept {
  return static_cast<std::uint32_t>(load_component(type, from));
}

bool is_index_type(ComponentType type) noexcept {
  return type == ComponentType::kU8 || type == ComponentType::kU16 || type == ComponentType::kU32;
}

Result<void> apply_sparse(const GltfDocument& document, GltfBuffers buffers, const GltfAccessor& accessor,
                          std::size_t size, std::vector<std::byte>& values) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
      !is_index_type(accessor.index_type))
    return invalid_file("glTF: a sparse accessor with a negative number or indices that are not unsigned");
  const auto count = static_cast<std::uint64_t>(sparse.count);
  const auto find = [&](const auto& part, std::size_t part_size) {
    const auto offset = static_cast<std::uint64_t>(part.byteOffset);
    return find_elements(document, buffers, part.bufferView, offset, count, part_size);
  };
  DELTAMESH_TRY(const Elements indices, find(sparse.indices, component_size(accessor.index_type)));
  DELTAMESH_TRY(const Elements replacements, find(sparse.values, size));
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint32_t index = load_index(accessor.index_type, indices.at(i));
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
  std::vector<std::byte> values(accessor.count * size);
  if (accessor.view != kGltfNone) {
    DELTAMESH_TRY(const Elements elements,
                  find_elements(document, buffers, accessor.view, accessor.offset, accessor.count, size));
    for (std::uint64_t i = 0; i < accessor.count; ++i)
      std::memcpy(values.data() + i * size, elements.at(i), size);
  }
  if (accessor.sparse.isSparse) DELTAMESH_CHECK(apply_sparse(document, buffers, accessor, size, values));
  return values;
}

Result<std::vector<std::uint32_t>> read_indices(const GltfDocument& document, GltfBuffers buffers,
                                                const GltfAccessor& accessor, std::uint64_t vertices) {
  if (!is_index_type(accessor.type) || accessor.components != 1)
    return invalid_file("glTF: indices that are not unsigned integers");
  DELTAMESH_TRY(const std::vector<std::byte> values, read_accessor(document, buffers, accessor));
  std::vector<std::uint32_t> indices(accessor.count);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = load_index(accessor.type, values.data() + i * component_size(accessor.type));
    if (indices[i] >= vertices) return invalid_file("glTF: an index names a vertex that does not exist");
  }
  return indices;
}

}  // namespace deltamesh
