// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/assemble.h"

#include <xxhash.h>

#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

namespace deltamesh {
namespace {

constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

/// Makes one mesh of several. Positions and attributes of a vertex are its row; a hash table with open
/// addresses finds equal ones.
class Assembly {
 public:
  explicit Assembly(std::span<const StoredBlock* const> blocks) {
    std::size_t vertices = 0;
    for (const StoredBlock* block : blocks) {
      vertices += block->mesh.vertex_count();
      has_groups_ = has_groups_ || !block->mesh.face_groups.empty();
    }
    places_.assign(std::bit_ceil(2 * vertices + 1), kNoNumber);
    mesh_.origin = blocks.front()->mesh.origin;
    for (const Attribute& from : blocks.front()->mesh.attributes) {
      Attribute& attribute = mesh_.attributes.emplace_back(from);
      attribute.values.clear();
      sizes_.push_back(from.components * component_size(from.type));
      row_size_ += sizes_.back();
    }
    for (const StoredBlock* block : blocks) add(block->mesh);
    mesh_.positions.resize(3 * count_);
    for (std::size_t i = 0; i < sizes_.size(); ++i) mesh_.attributes[i].values.resize(sizes_[i] * count_);
    take_rows();
  }
  Mesh take() { return std::move(mesh_); }

 private:
  void add(const Mesh& block) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(block.vertex_count());
    for (std::size_t v = 0; v < block.vertex_count(); ++v) numbers.push_back(number_of(block, v));
    for (const std::uint32_t v : block.triangles) mesh_.triangles.push_back(numbers[v]);
    if (!has_groups_) return;
    mesh_.face_groups.insert(mesh_.face_groups.end(), block.face_groups.begin(), block.face_groups.end());
    mesh_.face_groups.resize(mesh_.triangle_count(), 0);
  }

  std::uint32_t number_of(const Mesh& block, std::size_t vertex) {
    rows_.resize((count_ + 1) * row_size_);
    std::byte* const row = rows_.data() + count_ * row_size_;
    std::byte* to = row;
    std::memcpy(to, block.positions.data() + 3 * vertex, kPositionSize);
    to += kPositionSize;
    for (std::size_t i = 0; i < sizes_.size(); to += sizes_[i++])
      std::memcpy(to, block.attributes[i].values.data() + sizes_[i] * vertex, sizes_[i]);
    const std::size_t mask = places_.size() - 1;
    for (std::size_t place = XXH3_64bits(row, row_size_) & mask;; place = (place + 1) & mask) {
      std::uint32_t& number = places_[place];
      if (number == kNoNumber) return number = count_++;
      if (std::memcmp(rows_.data() + number * row_size_, row, row_size_) == 0) return number;
    }
  }

  void take_rows() {
    for (std::size_t v = 0; v < count_; ++v) {
      const std::byte* row = rows_.data() + v * row_size_;
      std::memcpy(mesh_.positions.data() + 3 * v, row, kPositionSize);
      row += kPositionSize;
      for (std::size_t i = 0; i < sizes_.size(); row += sizes_[i++])
        std::memcpy(mesh_.attributes[i].values.data() + sizes_[i] * v, row, sizes_[i]);
    }
  }

  static constexpr std::size_t kPositionSize = 3 * sizeof(float);

  bool has_groups_ = false;
  Mesh mesh_;
  std::vector<std::size_t> sizes_;  ///< of every attribute, octets a vertex
  std::size_t row_size_ = kPositionSize;
  std::vector<std::byte> rows_;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> places_;  ///< numbers of rows by hash
};

/// The vertices that have a position of the border.
std::vector<BorderVertex> border_vertices(const Mesh& mesh, std::span<const BorderPosition> border) {
  std::vector<BorderVertex> vertices;
  if (border.empty()) return vertices;
  std::vector<std::uint32_t> first(std::bit_ceil(2 * border.size()), kNoNumber);  // places of border by hash
  const std::size_t mask = first.size() - 1;
  for (std::uint32_t i = 0; i < border.size(); ++i) {
    std::size_t place = PositionHash{}(border[i].position) & mask;
    while (first[place] != kNoNumber) place = (place + 1) & mask;
    first[place] = i;
  }
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const PositionBits position = bits_of(mesh, v);
    for (std::size_t place = PositionHash{}(position)&mask; first[place] != kNoNumber;
         place = (place + 1) & mask) {
      const BorderPosition& found = border[first[place]];
      if (found.position != position) continue;
      vertices.push_back({v, found.point, found.twin});
      break;
    }
  }
  return vertices;
}

}  // namespace

MapPart assemble(const PartKey& key, std::span<const StoredBlock* const> blocks,
                 std::span<const BorderPosition> border) {
  MapPart part{key, Assembly(blocks).take(), {}};
  part.border = border_vertices(part.mesh, border);
  return part;
}

}  // namespace deltamesh
