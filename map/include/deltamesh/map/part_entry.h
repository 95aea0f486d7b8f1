// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Metadata of a version of a part, without its octets.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "deltamesh/map/part_key.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"

namespace deltamesh {

/// The border that a version of a part has in common with another part.
struct PartLink {
  PartKey key{};             ///< of the other part
  std::uint32_t border = 0;  ///< tells common borders apart [MAP-12]; 0: there is none
  /// The border changed with this version, which is shown only beside a version of the other part with the
  /// same border.
  bool together = false;
  /// Versions of the other part with lower revisions are not shown beside this one; 0: any may be.
  std::uint64_t least = 0;

  bool operator==(const PartLink&) const = default;
};

/// A version of a part, or the removal of one.
struct PartEntry {
  PartKey key{};
  std::uint64_t revision = 0;
  std::uint64_t group = 0;
  std::uint32_t bytes = 0;        ///< at most kMostPartBytes; 0: the part is gone, and only links follow
  std::vector<PartLink> links{};  ///< ascending by key
  std::uint64_t hash = 0;         ///< xxh3-64 of the octets
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::array<float, 3> box_min{};  ///< of the decoded positions, relative to the map's origin
  std::array<float, 3> box_max{};
  Quality quality{};                      ///< against the part's source
  std::vector<float> attribute_errors{};  ///< of every attribute of the map

  bool operator==(const PartEntry& other) const noexcept;
};

/// A part that a receiver does not get as it asked.
struct PartFault {
  PartKey key{};
  ErrorCode code =
      ErrorCode::kUnmetRequest;  ///< kUnmetRequest: it comes as well as can be; others: it does not
  const char* message = "";      ///< the sender's reason; empty at the receiver
  double best_value = 0;         ///< as Error::best_value; 0 at the receiver

  bool operator==(const PartFault&) const = default;
};

/// Tells versions of a part apart by what they show: of the octets' hash and of the borders, but not of
/// revision, group, `together` and `least`.
std::uint32_t version_hash(std::uint64_t octets_hash, const std::vector<PartLink>& links);

}  // namespace deltamesh
