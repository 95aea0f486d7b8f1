// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The octets of a part that is a patch of an earlier version [MAP-17].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "part/container.h"

namespace deltamesh {

inline constexpr std::size_t kMostPatches = 16;  // [MAP-17]: one on the other

/// Whether a part's octets are a base and a patch.
bool is_patched(std::span<const std::byte> octets) noexcept;

/// How many patches are on each other; stops counting above kMostPatches.
std::size_t count_patches(std::span<const std::byte> octets) noexcept;

struct PatchedOctets {
  PartKey base_key;  ///< of the part that the base is a version of
  std::span<const std::byte> base;
  std::span<const std::byte> body;
};
/// Precondition: is_patched(). Errors: kTruncated, kInvalidStream [MAP-17].
Result<PatchedOctets> divide_patched(std::span<const std::byte> octets);
std::vector<std::byte> join_patched(const PatchedOctets& parts);

struct PatchBody {
  std::span<const std::byte> plan;  ///< empty: `inserted` is the whole part, beside the base
  /// Octets of a part without patches, but for their checksum; empty: nothing is inserted.
  std::span<const std::byte> inserted;
};
/// With a checksum, also of the base and the place.
std::vector<std::byte> write_body(const PartPlace& place, std::uint64_t base_hash, const PatchBody& body);
/// Errors: kTruncated, kCorrupt (also a patch of another base), kInvalidStream [MAP-17].
Result<PatchBody> open_body(const PartPlace& place, std::uint64_t base_hash,
                            std::span<const std::byte> bytes);

}  // namespace deltamesh
