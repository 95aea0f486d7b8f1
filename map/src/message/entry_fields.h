// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Keys, links and entries of parts as bytes [MAP-12, MAP-13].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "deltamesh/map/part_entry.h"
#include "deltamesh/result.h"

namespace deltamesh {

void write_key(ByteWriter& out, const PartKey& key);
/// Errors: kTruncated, kInvalidStream [MAP-12].
Result<PartKey> read_key(ByteReader& in);

/// A part, told by where it is from another one.
struct Neighbor {
  PartKey key{};
  std::uint8_t flags = 0;  ///< of a link: kTogetherFlag, kLeastFlag
};
inline constexpr std::uint8_t kTogetherFlag = 32;  // [MAP-12]
inline constexpr std::uint8_t kLeastFlag = 64;     // [MAP-12]

/// One byte where the cell is `key` or at most a cell of the same level away from it.
void write_neighbor(ByteWriter& out, const PartKey& key, const Neighbor& neighbor);
/// Errors: kTruncated, kInvalidStream [MAP-12].
Result<Neighbor> read_neighbor(ByteReader& in, const PartKey& key);

/// Errors: kInvalidArgument (a level above 24, links that do not ascend, to itself, or too many) [MAP-12].
Result<void> check_links(const PartKey& key, const std::vector<PartLink>& links) noexcept;

/// Hash of keys and octets' hashes of parts, ascending by key: of what a receiver shows.
std::uint64_t hash_of_shown(std::span<const std::pair<PartKey, std::uint64_t>> parts);

/// `links` of a version of the part with the key `key`, which check_links() has passed.
void write_links(ByteWriter& out, const PartKey& key, std::uint64_t revision,
                 const std::vector<PartLink>& links);
/// Errors: kTruncated, kInvalidStream [MAP-12].
Result<std::vector<PartLink>> read_links(ByteReader& in, const PartKey& key, std::uint64_t revision);

/// Errors: kInvalidArgument (out of range) [MAP-12, MAP-13].
Result<void> check_entry(const PartEntry& entry) noexcept;
/// Figures are rounded up to float32. Precondition: check_entry() has passed.
void write_entry_fields(ByteWriter& out, const PartEntry& entry);
/// An entry of a map with so many attributes. Errors: kTruncated, kInvalidStream [MAP-12, MAP-13].
Result<PartEntry> read_entry_fields(ByteReader& in, std::size_t attributes);

}  // namespace deltamesh
