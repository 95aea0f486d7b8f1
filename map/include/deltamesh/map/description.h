// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The properties that all parts of a map share, sent once [MAP-1, MAP-2].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "deltamesh/voxel_grid.h"

namespace deltamesh {

/// A point of a map's lattice, in steps from the map's origin; each number below 2^24 in size, so that the
/// point is exact in float32.
using LatticePoint = std::array<std::int32_t, 3>;
inline constexpr std::int32_t kMostLatticeSteps = (1 << 24) - 1;  // [MAP-2]

/// The same for all parts, qualities and times of a map.
struct MapLattice {
  std::array<double, 3> origin{};  ///< of the map, in its frame; model units (metres), finite
  int step_exponent = -10;         ///< k: the step is 2^k model units; -40 to 20

  double step() const noexcept;
  /// The nearest point to a position relative to the origin, ties upwards. The caller has checked
  /// is_within().
  LatticePoint nearest(const std::array<float, 3>& position) const noexcept;
  /// Whether the nearest point has numbers below 2^24.
  bool is_within(const std::array<float, 3>& position) const noexcept;
  /// Relative to the origin; exact.
  std::array<float, 3> position_of(const LatticePoint& point) const noexcept;

  bool operator==(const MapLattice&) const = default;
};

/// The k of the coarsest lattice whose points are nowhere farther than `max_error` from any place: of 2^k
/// with 3 * 4^k <= 4 * max_error^2, within what a lattice may have.
int step_exponent_for(double max_error) noexcept;

/// An attribute that every vertex of the map has.
struct MapAttribute {
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;  ///< 1 to 16
  bool normalized = false;
  std::string name{};   ///< UTF-8, at most 255 bytes
  bool linear = false;  ///< see Attribute

  bool operator==(const MapAttribute&) const = default;
};

/// A part that coders learn from: models of all other parts begin as they are after it. Several follow each
/// other, each beginning where the one before ends.
struct MapPrimer {
  std::vector<std::byte> stream{};  ///< as encode() makes it
  std::vector<std::byte> border{};  ///< coded [MAP-11]

  bool operator==(const MapPrimer&) const = default;
};

struct MapDescription {
  std::uint64_t id = 0;     ///< which map
  std::uint32_t epoch = 0;  ///< parts are decoded with the description of their epoch
  std::string frame{};      ///< coordinate frame; UTF-8, at most 255 bytes
  MapLattice lattice{};
  /// Edge of a cell of level 0, lattice steps; 1 to 2^24. For blocks of a mapper: their edge over step(),
  /// rounded. Where that is no whole number, block x is up to x / 2 steps beside its cell: boxes of views
  /// meet it so much too early or too late. What is shown fits together all the same.
  std::uint32_t cell_steps = 1024;
  /// Low corner of the cell 0, 0, 0: that of a mapper's block, or where borders of cells meet no walls and
  /// floors.
  LatticePoint cell_origin{};
  /// The grid that meshes were cut from, relative to the map's origin. Parts need not repeat it, and split()
  /// keeps the faces of a cube together.
  std::optional<VoxelGrid> grid{};
  std::vector<MapAttribute> attributes{};  ///< at most 255
  /// At most 255, in all of at most kMostPrimerBytes. Empty: parts begin with fresh models.
  std::vector<MapPrimer> primers{};

  bool operator==(const MapDescription&) const = default;
};
inline constexpr std::size_t kMostPrimerBytes = std::size_t{1} << 16;  // [MAP-6]

/// Checks every member against its range; a primer's content is checked when it is decoded. Errors:
/// kInvalidArgument.
Result<void> validate(const MapDescription& description) noexcept;

/// The map's message [MAP-5], which is valid. Errors: as validate(); kOutOfMemory.
Result<std::vector<std::byte>> write_description(const MapDescription& description) noexcept;

/// Errors: kTruncated, kBadMagic, kUnsupportedVersion, kCorrupt, kInvalidStream [MAP-*], kOutOfMemory. Takes
/// memory in proportion to the bytes.
Result<MapDescription> read_description(std::span<const std::byte> message) noexcept;

/// Tells descriptions apart: xxh3-64 of the message [MAP-5]. Precondition: valid.
std::uint64_t hash_of(const MapDescription& description);

}  // namespace deltamesh
