// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What encode() was asked for, in model units and without gaps: what the searches get.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "deltamesh/encode.h"
#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"
#include "deltamesh/voxel_grid.h"
#include "positions/positions.h"
#include "topology/extent.h"
#include "topology/source_geometry.h"

namespace deltamesh {

class Progress;
struct StreamModels;

/// Whether every figure is a finite float, as the header wants [HDR-9].
bool is_declarable(const Quality& quality) noexcept;

/// Figures against what positions stand for, where they are up to `error` from it. A vertex and its
/// neighbours may both be off: VDE counts twice.
Quality with_source_error(Quality quality, double error) noexcept;

/// Upper bounds, model units.
struct Bounds {
  std::optional<double> vde = std::nullopt;
  std::optional<double> lfe = std::nullopt;
  std::optional<double> max_error = std::nullopt;

  bool positional() const noexcept { return lfe || max_error; }
  /// Achieved VDE over asked; 0 where none is asked. At most 1 where the bound is kept, also by the figure
  /// that the header declares, a float. So for the next two.
  double visual_load(const Quality& quality) const noexcept;
  double positional_load(const Quality& quality) const noexcept;  ///< the worse of LFE and max error
  double load(const Quality& quality) const noexcept;  ///< the worst of all; infinite if not declarable
};

/// `vertices`: position-welded vertices, what the paper's sums run over; `box`: the diagonal of all vertices,
/// for the paper's unit; `extent`: that without stray ones, for percents.
Bounds bounds_in_model_units(const QualityRequest& request, std::uint64_t vertices, double box,
                             double extent) noexcept;

/// Whether every number is finite and above 0. Errors: kInvalidArgument.
Result<void> validate(const QualityRequest& request) noexcept;

/// From here on a search goes beyond what it needs to keep the request.
inline constexpr int kSearchEffort = 1;
/// From here on a search tries what seldom saves much.
inline constexpr int kThoroughEffort = 2;

/// At most one of `step`, `bits` and bounds on VDE or the largest error is set.
struct Request {
  Bounds bounds{};
  std::optional<std::uint64_t> target_bytes = std::nullopt;
  std::optional<double> step = std::nullopt;
  std::optional<int> bits = std::nullopt;  ///< in place of `step`
  std::optional<std::uint32_t> anchors = std::nullopt;
  std::optional<std::uint32_t> anchor_density = std::nullopt;  ///< in place of `anchors`
  int anchor_bits = 12;                                        ///< at least; a search may take more
  bool lossless = false;
  GeometryCoder coder = GeometryCoder::kAuto;
  Profile profile = Profile::kSmallest;
  int effort = 1;
  std::optional<PositionForm> form = std::nullopt;  ///< of lattices within bounds; empty: the smallest
  AnchorContainers* containers = nullptr;           ///< may be null
  const StreamModels* start = nullptr;              ///< null for fresh models
  std::optional<VoxelGrid> grid = std::nullopt;     ///< that the mesh was cut from, if known
  const KnownMesh* known = nullptr;                 ///< null: nothing is known
  Progress* progress = nullptr;                     ///< may be null
  /// Attributes cost less on positions that decoders know to the bit, those of the predictive coder.
  bool attributes_use_positions = false;

  bool has_bounds() const noexcept { return bounds.vde || bounds.positional(); }
};

/// `options`, checked, for `source`. Where they say nothing of positions, the default: a largest error of
/// 0.02 % of the extent's diagonal, and of 4 % of the mean edge, so that the surface's own normals stay
/// within about a degree on average, however fine the mesh is. A VDE without a positional bound implies a
/// largest error of kImpliedError of the diagonal, unless the caller wants none. `source_error` is taken off
/// all bounds. O(1): a sample of the faces tells of edges. Errors: kUnmetRequest where a bound is not above
/// `source_error`.
Result<Request> make_request(const EncodeOptions& options, const SourceGeometry& source);

/// Whether `options` say nothing of how positions are to be coded.
bool says_nothing_of_positions(const EncodeOptions& options) noexcept;

/// The default largest error, model units, above 0. `triangles`: m x 3 indices into `positions`, whose extent
/// `extent` is: faces at stray vertices do not count.
double default_error(std::span<const std::uint32_t> triangles, std::span<const Vec3> positions,
                     const Extent& extent) noexcept;

/// kUnmetRequest with the best figure and size that can be had. `quality`: of the stream that comes nearest
/// to `bounds`, which it breaks.
Error unmet_bounds(const Bounds& bounds, const Quality& quality, std::uint64_t bytes) noexcept;
/// `bytes`: of the smallest stream there can be; of the smallest found that keeps the bounds.
Error too_few_bytes(std::uint64_t bytes) noexcept;
Error too_few_bytes_for_bounds(std::uint64_t bytes) noexcept;

}  // namespace deltamesh
