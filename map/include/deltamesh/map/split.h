// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Splits a mesh, or a mapper's blocks, into parts.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// A part is the largest cell of the octree with at most `most_triangles`, or a cell of level 0.
struct SplitOptions {
  std::uint32_t most_triangles = 16384;      ///< above 0; about a byte each with colours
  std::uint8_t most_level = kMostPartLevel;  ///< 0: all parts are cells of level 0
  /// Coarser copies of what is below can be had in the cells of levels 1 to this one, for views of those
  /// levels and as a first sight [MAP-19]; at most kMostPartLevel. Where a copy would have more than
  /// `most_triangles` there is none. They pay as a first sight where few border vertices are between the
  /// large cells: cells on both sides of 0 are in no common one, so that blocks are better counted from a
  /// corner below the map than from a floor in the middle of it.
  std::uint8_t copy_level = 0;
};

/// Every face of `mesh` in exactly one part, by the cell that its centroid is in [MAP-4], but for coarser
/// copies; parts ascending by key. Vertices that no face uses are dropped. The mesh's positions are taken
/// relative to the map's origin. Deterministic. O(n log n). Errors: kInvalidArgument, kInvalidMesh (also
/// without the map's attributes), kUnmetRequest (the lattice is too fine to reach a position [MAP-2]),
/// kNotFinite, kOutOfMemory.
Result<std::vector<MapPart>> split(const MeshView& mesh, const MapDescription& description,
                                   const SplitOptions& options = {}) noexcept;

/// A mapper's block: the whole content of a cell of level 0, which replaces the previous content. An empty
/// mesh removes the block. Faces belong to the block that they come with, wherever they lie.
struct MapBlock {
  std::array<std::int32_t, 3> cell{};
  MeshView mesh;
};

/// A part that is new or changed. Parts, also removed ones, with one group number have a common border that
/// changed: they are shown together or not at all [MAP-9]. Numbers are not used again.
struct ChangedPart {
  std::uint64_t revision = 0;  ///< of the map: how many updates there were, this one included
  std::uint64_t group = 0;
  MapPart part;
};
struct RemovedPart {
  PartKey key{};
  std::uint64_t revision = 0;
  std::uint64_t group = 0;
};
struct MapChange {
  std::vector<ChangedPart> changed;  ///< ascending by key
  std::vector<RemovedPart> removed;  ///< ascending by key; also copies with nothing below any more
  std::vector<PartKey> outdated{};   ///< copies, made before, of what has changed; ascending
};

struct MadeCopies {
  std::vector<ChangedPart> copies;  ///< with the map's revision when they became as they are
  std::size_t done = 0;             ///< of so many of the cells
};

/// The source of a map that changes: keeps the blocks and finds the parts that an update changes.
class Splitter {
 public:
  /// Errors: kInvalidArgument.
  static Result<Splitter> make(MapDescription description, const SplitOptions& options = {}) noexcept;
  /// Continues a map that had `revision` updates and used the group numbers below `group`.
  void resume(std::uint64_t revision, std::uint64_t group) noexcept;

  /// One update: all blocks at once, each cell at most once. The parts after it are those that a fresh
  /// splitter makes of all blocks; `changed` has only those whose mesh or border is not as before. Takes time
  /// in proportion to the blocks' parts and those with a changed border, not to the map. On an error nothing
  /// has changed, but after kOutOfMemory every further update fails with it. Errors: as split(); Error::found
  /// is the cell of the block at fault.
  Result<MapChange> update(std::span<const MapBlock> blocks) noexcept;

  /// Makes the coarser copies of these cells, and gives those that were not given since they became outdated.
  /// Cells above SplitOptions::copy_level and those that hold no parts of lower levels have none. Ends once
  /// it has simplified `most_triangles`, which takes about a microsecond each, or one cell if that has more.
  /// Errors: kOutOfMemory.
  Result<MadeCopies> make_copies(std::span<const PartKey> cells, std::uint64_t most_triangles) noexcept;

  std::uint64_t revision() const noexcept;

  Splitter(Splitter&&) noexcept;
  Splitter& operator=(Splitter&&) noexcept;
  ~Splitter();

 private:
  struct State;
  explicit Splitter(std::unique_ptr<State> state) noexcept;
  std::unique_ptr<State> state_;
};

}  // namespace deltamesh
