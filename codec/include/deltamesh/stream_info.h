// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Information about a stream that is available without decoding it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Errors of the decoded mesh against the encoder's input, measured by the encoder on its own decoded stream.
/// See spec/quality.md for the definitions.
struct Quality {
  double vde_rms = 0;    ///< visual distortion error S_q (eq. 2) over sqrt(m) [QUAL-1]; model units
  double lfe_rms = 0;    ///< low-frequency error M_q (eq. 1) over sqrt(m) [QUAL-2]; model units
  double max_error = 0;  ///< largest distance of a vertex from its original; model units
};

/// An attribute as the header tells of it.
struct AttributeInfo {
  std::string name;
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;
  std::uint64_t coded_bytes = 0;
  /// Largest error that the encoder measured: normals and tangents: degrees; texture coordinates: distance;
  /// colours: difference of a component in 255ths of its range; all others: difference of a component.
  double error = 0;
  /// At a mean error, else 0: of colours over all values of red, green and blue, 255ths; of others in their
  /// unit.
  double rms = 0;
  bool linear = false;  ///< colours: linear light; else what a screen shows
};

struct ChunkInfo {
  std::array<char, 5> tag{};  ///< zero-terminated
  const char* codec = "";     ///< "raw", "zstd" or "compact"
  std::uint64_t offset = 0;   ///< first byte in the file
  std::uint64_t coded_bytes = 0;
  std::uint64_t decoded_bytes = 0;
};

struct StreamInfo {
  std::uint8_t format_major = 0;
  std::uint8_t format_minor = 0;
  std::uint16_t format_draft = 0;
  std::uint64_t vertices = 0;            ///< vertices of the decoded mesh
  std::uint64_t geometric_vertices = 0;  ///< distinct positions (position-welded)
  std::uint64_t triangles = 0;
  std::uint64_t components = 0;  ///< connected components of the welded mesh, isolated vertices included
  std::array<double, 3> origin{};
  /// Bounding box relative to `origin`: that of the source in what encode() reports, else that of the
  /// lattice, where there is one.
  std::array<float, 3> box_min{};
  std::array<float, 3> box_max{};
  /// Of that box; 0 where it is that of whole cubes of a grid, which may be much larger.
  double diagonal = 0;
  /// Vertices far from all others, as of a sensor's failed reading, and the diagonal of the rest, which
  /// percents were of; the same as `diagonal` without strays.
  std::uint64_t stray_vertices = 0;
  double extent = 0;
  bool keeps_order = false;  ///< the decoded mesh is in the input's vertex and face order
  std::string geometry;      ///< geometry coder: "highpass", "predictive" or "grid"
  int bits = 0;              ///< asked bits of deltas or positions; 0 when something else was asked
  double step = 0;           ///< quantisation step of delta coordinates, or of positions, model units
  std::uint64_t anchors = 0;
  std::uint32_t anchor_density = 0;  ///< largest hop distance of a vertex to its nearest anchor
  int cycles = 0;                    ///< of the solver, for highpass streams
  Quality quality;
  std::vector<AttributeInfo> attributes;
  std::vector<ChunkInfo> chunks;
  std::uint64_t bytes = 0;
  std::uint64_t connectivity_bytes = 0;  ///< coded CONN, SEAM, FGRP and ORDR
  std::uint64_t geometry_bytes = 0;      ///< coded DELT or POSN, or GRID, which has faces as well
  std::uint64_t anchor_bytes = 0;        ///< coded ANCH
  std::uint64_t attribute_bytes = 0;     ///< coded ATTR
  std::uint64_t container_bytes = 0;     ///< everything else: headers, descriptors, checksum
};

/// Reads the headers of the stream and of its chunks, and checks them and the checksum, but decodes nothing.
/// No allocation but the result's; one pass over the bytes. Errors: 1xx codes.
Result<StreamInfo> inspect(std::span<const std::byte> stream) noexcept;

/// The plain sums of the paper's equations 1 and 2, mesh scaled to unit bounding-box diagonal.
struct PaperQuality {
  double vde = 0;  ///< S_q
  double lfe = 0;  ///< M_q
};
PaperQuality paper_form(const Quality& quality, std::uint64_t geometric_vertices, double diagonal) noexcept;

}  // namespace deltamesh
