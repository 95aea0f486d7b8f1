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
#include "base/vec3.h"
#include "deltamesh/result.h"
#include "format/highpass_parameters.h"
#include "format/predictive_parameters.h"
#include "format/tags.h"

namespace deltamesh {

inline constexpr std::uint32_t kMagic = chunk_tag("DMSH");  // [HDR-1]
inline constexpr std::uint16_t kFlagKeepsOrder = 1U << 0;   // [HDR-5]
inline constexpr std::uint16_t kFlagHasOrigin = 1U << 1;    // [HDR-5]
inline constexpr std::uint16_t kKnownFlags = kFlagKeepsOrder | kFlagHasOrigin;
inline constexpr std::uint64_t kMaxVertices = 0x7fffffff;  // [HDR-6]
inline constexpr std::uint64_t kMaxTriangles = 1U << 29;   // [HDR-6]
inline constexpr std::uint8_t kGeometryHighpass = 1;       // [HDR-10]
inline constexpr std::uint8_t kGeometryPredictive = 2;     // [HDR-10]

struct FileHeader {
  std::uint8_t format_major = 0;
  std::uint8_t format_minor = 0;
  std::uint16_t format_draft = 0;
  bool keeps_order = false;
  std::uint32_t vertices = 0;
  std::uint32_t geometric_vertices = 0;
  std::uint32_t triangles = 0;
  std::uint32_t components = 0;
  std::uint32_t attributes = 0;
  std::array<double, 3> origin{};
  std::array<float, 3> box_min{};
  std::array<float, 3> box_max{};
  float vde_rms = 0;  ///< achieved figures, rounded up
  float lfe_rms = 0;
  float max_error = 0;
  std::uint8_t geometry = kGeometryHighpass;
  HighpassParameters highpass;      ///< where `geometry` says so
  PredictiveParameters predictive;  ///< likewise

  Box box() const noexcept;
};

/// The header's bytes, of the current format version.
std::vector<std::byte> write_header(const FileHeader& header);

/// Reads and checks every field's range. Fields that a later minor version appends are skipped [HDR-4].
/// Errors: kBadMagic, kUnsupportedVersion, kUnsupportedFeature, kTruncated, kInvalidStream.
Result<FileHeader> read_header(ByteReader& in);

}  // namespace deltamesh
