// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Shared by the reader and the writer of containers: the checksum and the least length of a stream.
#pragma once

#include <xxhash.h>

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/byte_reader.h"
#include "base/try.h"
#include "format/header.h"

namespace deltamesh {

inline constexpr std::uint64_t kElementsPerByte = 2048;               // [CNT-5]
inline constexpr std::size_t kChecksumBytes = sizeof(std::uint32_t);  // [CNT-2]

inline std::uint32_t checksum_of(std::span<const std::byte> bytes) noexcept {
  return static_cast<std::uint32_t>(XXH3_64bits(bytes.data(), bytes.size()));
}

/// Whether a stored checksum is the one that was computed. Its definition is weak: fuzz targets, which cannot
/// guess checksums, put one in its place that is always true, as what lies behind a checksum must be safe
/// without it.
bool checksum_holds(std::uint32_t stored, std::uint32_t computed) noexcept;

/// All of `bytes` but the checksum at their end, which must be the one that `compute` has for them. Errors:
/// kTruncated, kCorrupt (with the text `damaged`), both of `rule`.
template <class Compute>
Result<std::span<const std::byte>> check_whole(std::span<const std::byte> bytes, const char* damaged,
                                               const char* rule, Compute&& compute) {
  if (bytes.size() < kChecksumBytes)
    return Error{.code = ErrorCode::kTruncated, .message = "bytes end before the checksum", .rule = rule};
  const auto covered = bytes.first(bytes.size() - kChecksumBytes);
  ByteReader end(bytes.last(kChecksumBytes));
  DELTAMESH_TRY(const auto stored, end.read<std::uint32_t>());
  if (checksum_holds(stored, compute(covered))) return covered;
  return Error{.code = ErrorCode::kCorrupt,
               .message = damaged,
               .rule = rule,
               .where_kind = WhereKind::kByte,
               .where = covered.size()};
}

/// The stream length that [CNT-5] asks for.
inline std::uint64_t bytes_needed(const FileHeader& header) noexcept {
  const std::uint64_t elements = std::uint64_t{header.vertices} + header.triangles;
  return (elements + kElementsPerByte - 1) / kElementsPerByte;
}

}  // namespace deltamesh
