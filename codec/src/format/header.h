// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The file header [HDR-*]: what a reader may know of a stream before it pays for decoding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/byte_reader.h"
#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "deltamesh/version.h"
#include "format/chunk/attribute_descriptor.h"
#include "format/chunk/tags.h"
#include "format/highpass_parameters.h"
#include "format/predictive_parameters.h"

namespace deltamesh {

/// Three letters; the version makes it four bytes [HDR-1].
inline constexpr std::array<char, 3> kMagic{'D', 'M', 'S'};
/// Versions from here on are drafts of the unreleased format: this plus the draft's number [HDR-3].
inline constexpr std::uint8_t kFirstDraft = 128;
inline constexpr std::uint8_t kFormatVersion =
    kFormatDraft == 0 ? kFormatMajor : static_cast<std::uint8_t>(kFirstDraft + kFormatDraft);
inline constexpr std::uint64_t kMaxVertices = 0x7fffffff;  // [HDR-6]
inline constexpr std::uint64_t kMaxTriangles = 1U << 29;   // [HDR-6]

/// The geometry coders.
inline constexpr std::uint8_t kGeometryHighpass = 1;
inline constexpr std::uint8_t kGeometryPredictive = 2;

struct FileHeader {
  bool keeps_order = false;
  std::uint32_t vertices = 0;
  std::uint32_t geometric_vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t components = 0;
  std::vector<AttributeDescriptor> attributes;  ///< stored with the ATTR chunks, in their order
  std::array<double, 3> origin{};
  std::array<float, 3> box_min{};  ///< of the source; of a lattice that was read, its own
  std::array<float, 3> box_max{};
  float vde_rms = 0;  ///< achieved figures, short floats, rounded up
  float lfe_rms = 0;
  float max_error = 0;
  std::uint8_t geometry = kGeometryHighpass;
  HighpassParameters highpass;      ///< where `geometry` says so
  PredictiveParameters predictive;  ///< likewise

  Box box() const noexcept;
};

/// Whether faces and positions are in one chunk [GRD-12].
inline bool is_of_grid(const FileHeader& header) noexcept {
  return header.geometry == kGeometryPredictive && header.predictive.kind == PositionKind::kVoxel;
}

/// The header's bytes, of the current format version. Attributes are not among them.
std::vector<std::byte> write_header(const FileHeader& header);

/// Reads what tells a stream that this library reads. Errors: kBadMagic, kUnsupportedVersion, kTruncated.
Result<void> read_signature(ByteReader& in);

/// Reads the signature and all fields, and checks their ranges; attributes come with their chunks. Errors:
/// kBadMagic, kUnsupportedVersion, kTruncated, kInvalidStream [HDR-*].
Result<FileHeader> read_header(ByteReader& in);

/// Checks every field against its range. `in`: where an error is. Errors: kInvalidStream [HDR-6 .. HDR-14].
Result<void> check_header(const FileHeader& header, const ByteReader& in);

}  // namespace deltamesh
