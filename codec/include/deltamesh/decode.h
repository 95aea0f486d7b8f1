// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Stream in, mesh out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Upper limits that the caller sets. A stream that exceeds one is refused before memory of its size is
/// allocated.
struct DecodeLimits {
  std::uint64_t vertices = std::uint64_t{1} << 26;
  std::uint64_t triangles = std::uint64_t{1} << 27;
  std::uint32_t attributes = 1024;                         ///< a face with 52 morph targets has more than 100
  std::uint64_t attribute_bytes = std::uint64_t{1} << 31;  ///< all attribute values together
};

struct KnownMesh;   ///< deltamesh/known_mesh.h
class ModelStates;  ///< deltamesh/model_states.h

struct DecodeOptions {
  DecodeLimits limits{};
  /// Threads to work on, the caller's included; 0: as many as the machine runs at once. No more than 16 are
  /// started, none for streams of a few kilobytes, and fewer where the system has no more. The mesh is the
  /// same for any number; each more than 1 may take 16 bytes of memory a vertex.
  unsigned threads = 1;
  /// The states that the stream was encoded with (EncodeOptions::starting_states); must outlive the call.
  const ModelStates* starting_states = nullptr;
  /// The mesh that the stream was encoded beside (EncodeOptions::known); must outlive the call.
  const KnownMesh* known = nullptr;
  /// Called now and then with the share of the work done, 0 to 1; may be empty. If it throws, decoding ends
  /// with kInvalidArgument.
  std::function<void(double)> progress{};
};

/// Decodes a whole stream. On success every index is in range, sizes agree and positions are finite. Bytes
/// are not trusted: memory is bounded by a constant times the stream's size plus the limits. Errors: 1xx
/// codes, kLimitExceeded, kInvalidArgument (a callback that throws), kOutOfMemory.
Result<Mesh> decode(std::span<const std::byte> stream, const DecodeOptions& options = {}) noexcept;

/// Checks all that can be checked without the original: checksums, structure, and that it decodes. Errors: as
/// decode().
Result<void> verify(std::span<const std::byte> stream, const DecodeOptions& options = {}) noexcept;

}  // namespace deltamesh
