// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Mesh in, stream out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "deltamesh/anchor_containers.h"
#include "deltamesh/attribute_quality.h"
#include "deltamesh/mesh.h"
#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"
#include "deltamesh/voxel_grid.h"

namespace deltamesh {

/// Which codings a chunk may use.
enum class Profile : std::uint8_t {
  kSmallest,  ///< the compact form: an entropy coder of its own
  kZstd,      ///< the plain form: arrays under zstd, which a page of any language reads (spec/plain.md)
};

/// How positions are coded.
enum class GeometryCoder : std::uint8_t {
  kAuto,        ///< what is forecast to give the smaller stream; highpass for `bits`, `step` and anchors
  kHighpass,    ///< delta coordinates and anchors: the least visual error
  kPredictive,  ///< a lattice of positions: every vertex within half a step per axis, decoded without a solve
};

struct KnownMesh;   ///< deltamesh/known_mesh.h
class ModelStates;  ///< deltamesh/model_states.h

/// How to encode. Plain values with defaults; validate() checks ranges and contradictions.
struct EncodeOptions {
  /// The quality to keep. Where nothing is said of positions, here or below, no vertex is off by more than
  /// 0.02 % of the bounding-box diagonal, nor by more than 4 % of the mean edge: every coder and profile
  /// keeps that, or the call fails. In place of bits and anchors: VDE, maximum error and bytes exclude `bits`
  /// and `step`, LFE and maximum error exclude `anchors` and `anchor_density`.
  QualityRequest quality{};
  GeometryCoder geometry = GeometryCoder::kAuto;
  /// Decoded positions and attributes have the input's bits. Excludes a quality, bits, step and anchors.
  bool lossless = false;
  /// How far positions may be from what they stand for, model units: coordinates in double that became
  /// float32 (ReadReport::position_error). Counts in all bounds and figures.
  double source_error = 0;
  /// How hard to look for a smaller stream: 0 takes as few passes as keep the request, 1 looks for what
  /// nearly always pays, 2 for what seldom does. docs/benchmarks.md has a table of times and sizes.
  int effort = 1;
  /// Anchors found by earlier calls for this mesh, and by this one; may be null.
  std::shared_ptr<AnchorContainers> anchor_containers{};
  /// Highpass: of delta coordinates, step = range / 2^bits; 3 to 16; 8 where only anchors are set.
  /// Predictive: of positions, step = longest side / (2^bits - 1); 1 to 28.
  std::optional<int> bits = std::nullopt;
  /// Or the quantisation step itself, model units, above 0.
  std::optional<double> step = std::nullopt;
  /// How many anchors over all components; each component gets at least one. 0.5 % of the vertices
  /// where only bits or a step are set.
  std::optional<std::uint32_t> anchors = std::nullopt;
  /// Or the largest hop distance of a vertex to its nearest anchor, 1 to 65535.
  std::optional<std::uint32_t> anchor_density = std::nullopt;
  /// Bits per axis of an anchor, over the longest side of the bounding box; 4 to 24. A quality request may
  /// change it.
  int anchor_bits = 12;
  AttributeQuality attributes{};  ///< bounds of attributes; `lossless` keeps their bits
  Profile profile = Profile::kSmallest;
  /// Models begin as here, not fresh; must outlive the call. Decoders need the same
  /// (deltamesh/model_states.h).
  const ModelStates* starting_states = nullptr;
  /// The grid that the mesh was cut from, is_valid(). Without one, encode() looks for it; a mesh that is not
  /// on the given one (is_on_grid()) is coded without a grid.
  std::optional<VoxelGrid> grid{};
  /// A mesh that decoders have too, such as an earlier version: streams of grids take fewer bytes beside it.
  /// Must outlive the call; decoders need the same.
  const KnownMesh* known = nullptr;
  bool keep_order = false;         ///< the decoded mesh has the input's order of vertices and faces
  bool keep_unreferenced = false;  ///< keep vertices that no face uses
  /// Called now and then with the share of the work done, 0 to 1, which never falls; may be empty. If it
  /// throws, the call ends with kInvalidArgument.
  std::function<void(double)> progress{};
};

/// The encoder's choices and measurements.
struct EncodeReport {
  std::uint64_t input_vertices = 0;
  std::uint64_t unreferenced_vertices = 0;  ///< dropped, or kept where asked
  std::uint64_t dropped_lengths = 0;        ///< normals and tangents that were not of length 1, but decode so
  /// Different colours that were taken for labels and so kept exactly, as nothing was said of them; else 0.
  std::uint64_t labels = 0;
  StreamInfo stream;  ///< as inspect() reads it back, but for the box, which is the source's
};

struct Encoded {
  std::vector<std::byte> bytes;      ///< the .dmsh stream
  std::vector<std::uint32_t> order;  ///< input vertex of every decoded vertex
  EncodeReport report;
};

/// Checks every member against its range. Errors: kInvalidArgument.
Result<void> validate(const EncodeOptions& options) noexcept;

/// Encodes `mesh`. The same mesh and options give the same bytes. Takes any triangle soup; cost is some
/// 1 to 3 us per vertex of a predictive stream, ten times that of a highpass stream. Errors: kInvalidArgument
/// (options, a callback that throws), kInvalidMesh (index out of range, sizes that disagree), kNotFinite,
/// kLimitExceeded (more than 2^31 - 1 vertices or 2^29 triangles, or beyond what a stream can hold),
/// kUnmetRequest (with the best that can be had), kOutOfMemory.
Result<Encoded> encode(const MeshView& mesh, const EncodeOptions& options = {}) noexcept;

}  // namespace deltamesh
