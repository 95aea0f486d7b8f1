// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A part's octets: a stream without what the map's message says [MAP-7].
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part_key.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// The map and the cell of a part.
struct PartPlace {
  const MapDescription& description;
  std::uint64_t description_hash;  ///< hash_of(description)
  PartKey key;
  /// Vertices and triangles of the base that the part is coded beside, if any.
  std::uint64_t known_elements = 0;
};

/// Octets of a part that is the description's primer number `primer`.
std::vector<std::byte> write_primer_part(const PartPlace& place, std::size_t primer);

/// The number of the primer that a part's octets are; none if they are no primer's.
std::optional<std::size_t> primer_of(std::span<const std::byte> octets) noexcept;

/// Octets of a part from a stream and the coded border. The stream has no origin and no original order, and
/// its attributes are the map's. Errors: those of Container::open().
Result<std::vector<std::byte>> write_part(const PartPlace& place, std::span<const std::byte> stream,
                                          std::span<const std::byte> border);

/// Checksum of `bytes`, all octets before it, and of the map and the key, which the octets do not contain
/// [MAP-7].
std::uint32_t part_checksum(const PartPlace& place, std::span<const std::byte> bytes);

/// Octets of a part, or of none, but for their checksum.
inline std::span<const std::byte> without_checksum(std::span<const std::byte> octets) noexcept {
  return octets.first(octets.size() - std::min(octets.size(), sizeof(std::uint32_t)));
}

struct OpenedPart {
  std::vector<std::byte> stream;      ///< with figures of 0
  std::optional<std::size_t> primer;  ///< which of the description's the part is
  std::vector<std::byte> border;
};

/// Takes memory in proportion to the bytes. Errors: kTruncated, kCorrupt, kInvalidStream [MAP-7],
/// kUnsupportedFeature.
Result<OpenedPart> open_part(const PartPlace& place, std::span<const std::byte> bytes);
/// The same of octets without their checksum, which another one covers.
Result<OpenedPart> open_covered_part(const PartPlace& place, std::span<const std::byte> covered);

}  // namespace deltamesh
