// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From blocks as mappers (nvblox, voxblox, Open3D) give them to blocks as a map takes them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "deltamesh/map/description.h"
#include "deltamesh/map/split.h"
#include "deltamesh/result.h"

namespace deltamesh {

struct AdapterOptions {
  /// Vertices that are at most so far apart, of one block or of several, get one position; model units, 0 to
  /// half the edge of a cell. Without a value: a sixteenth of the map's lattice step.
  std::optional<double> tolerance{};
};

/// What an adapter did to all blocks until now.
struct AdapterCounts {
  std::uint64_t vertices_moved = 0;   ///< to a position within the tolerance
  std::uint64_t vertices_merged = 0;  ///< with one that has the same position and values
  std::uint64_t faces_dropped = 0;    ///< two of their corners have one position
};

/// Comes before MapSender::update() or Splitter::update(). Blocks of a mapper may
/// - be triangle soup: without triangles, vertices 3i, 3i + 1 and 3i + 2 are one;
/// - have duplicated vertices, also with float noise, within a block and where blocks meet. As parts are
/// linked
///   where positions are equal to the bit [MAP-8], a vertex takes the position of the nearest known vertex
///   within the tolerance. What it is near to may be of a block that came earlier; no vertex is ever moved
///   farther than the tolerance from where its block has it;
/// - have other attributes than the map. Colours may be u8, u16, f32 or f64, of 3 or 4 components, and become
///   the map's; alpha is opaque where they have none and dropped where the map has none. Labels,
///   intensities and all else are found by kind and name, and their numbers must fit the map's type; f64 is
///   rounded to f32. Normals and tangents are found by kind, and dropped if the map has none.
/// Not thread-safe.
class BlockAdapter {
 public:
  /// Errors: kInvalidArgument.
  static Result<BlockAdapter> make(MapDescription description, const AdapterOptions& options = {}) noexcept;

  /// The same blocks for the map, ascending by cell; they live until the next call. A block without vertices
  /// or whose faces are all dropped removes its cell. The result depends on the calls until now, not on the
  /// order of `blocks`. Takes time in proportion to `blocks`, memory to the positions of all blocks. On an
  /// error nothing has changed, but after kOutOfMemory the adapter is undefined. Errors: kInvalidArgument
  /// (a cell twice), kInvalidMesh, kUnmetRequest (as split()), kNotFinite, kLimitExceeded; Error::found is
  /// the cell of the block at fault.
  Result<std::span<const MapBlock>> update(std::span<const MapBlock> blocks) noexcept;

  /// Removals of all blocks, as update() gives them. Errors: kOutOfMemory.
  Result<std::span<const MapBlock>> clear() noexcept;

  AdapterCounts counts() const noexcept;

  BlockAdapter(BlockAdapter&&) noexcept;
  BlockAdapter& operator=(BlockAdapter&&) noexcept;
  ~BlockAdapter();

 private:
  struct State;
  explicit BlockAdapter(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace deltamesh
