// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/coded_parts.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/try.h"
#include "deltamesh/attribute_quality.h"
#include "encoder/coded_attributes.h"
#include "search/bracket.h"
#include "search/geometry.h"
#include "search/request.h"

namespace deltamesh {
namespace {

constexpr double kLargestAngle = 45;     // degrees
constexpr double kLargestUv = 1.0 / 16;  // texture coordinate units
constexpr double kLargestColor = 64;     // 255ths
constexpr double kLargestColorRms = 32;  // 255ths
constexpr double kLargestWeight = 1.0 / 8;

/// At most `largest`, unless more was asked for.
double scaled_to(double bound, double scale, double largest) noexcept {
  return std::min(bound * scale, std::max(bound, largest));
}

/// `quality` with every bound `scale` times as large, at most to where an attribute would mean nothing any
/// more. What is exact stays so. `scale`: above 0.
AttributeQuality scaled(const AttributeQuality& quality, double scale) {
  AttributeQuality result = quality;
  result.normal_error = scaled_to(quality.normal_error, scale, kLargestAngle);
  if (quality.tangent_error) result.tangent_error = scaled_to(*quality.tangent_error, scale, kLargestAngle);
  result.uv_error = scaled_to(quality.uv_error, scale, kLargestUv);
  if (quality.color_rms) result.color_rms = scaled_to(*quality.color_rms, scale, kLargestColorRms);
  if (quality.color_error) result.color_error = scaled_to(*quality.color_error, scale, kLargestColor);
  result.weight_error = scaled_to(quality.weight_error, scale, kLargestWeight);
  for (NamedBound& bound : result.named) bound.error *= scale;
  return result;
}

/// No attribute loses a bit.
const AttributeQuality kExactly{
    .normal_error = 0, .tangent_error = 0, .uv_error = 0, .color_error = 0, .weight_error = 0};

struct Parts {
  CodedParts coded;
  std::uint64_t bytes = 0;  ///< of the whole stream
};

/// Attributes within their bounds, on the geometry that keeps `request`.
Result<Parts> code_both(const PartsTask& task, const Request& request, const AttributeQuality& bounds) {
  EncodeOptions options = task.options;
  options.attributes = bounds;
  options.effort = request.effort;
  const TopologyChunks* chunks = &task.topology_chunks;
  StreamRest rest{task.header, task.other_bytes + chunks->other_bytes(), chunks->faces.bytes()};
  DELTAMESH_TRY(Candidate geometry, code_geometry(request, task.source, rest));
  task.progress.tick();
  const CodedTopology* topology = &task.topology;
  std::optional<GridTopology> in_grid;
  if (geometry.grid) {
    CodedTopology ordered = in_grid_order(task.mesh, task.topology, *geometry.grid);
    TopologyChunks ordered_chunks = code_topology_chunks(task.mesh, task.options, ordered);
    in_grid = GridTopology{std::move(ordered), std::move(ordered_chunks)};
    topology = &in_grid->topology;
    chunks = &in_grid->chunks;
  }
  std::span<const KnownVertex> known;
  if (geometry.grid) known = geometry.grid->known;
  DELTAMESH_TRY(ChunkList attributes,
                code_attributes(task.mesh, *topology, options, geometry.positions, known));
  task.progress.tick();
  rest.chunk_bytes = task.other_bytes + chunks->other_bytes() + attributes.bytes();
  const std::uint64_t bytes = rest.bytes_with(geometry);
  return Parts{{std::move(geometry), std::move(attributes), std::move(in_grid)}, bytes};
}

/// All errors grow and shrink together until the stream has the bytes asked for.
class SharedBudget {
 public:
  SharedBudget(const PartsTask& task, const Request& request)
      : task_(task),
        request_(request),
        budget_(*request.target_bytes),
        unit_(default_error(task.source.triangles, task.source.positions, task.source.extent)) {
    request_.target_bytes.reset();
  }

  /// A quick search first: the stream of a whole one is smaller, but not by much.
  Result<CodedParts> run() {
    double scale = 1;
    if (request_.effort >= kSearchEffort) {
      const int effort = std::exchange(request_.effort, 0);
      DELTAMESH_TRY(scale, search({.first = scale, .trials = kQuickTrials}));
      request_.effort = effort;
      best_.reset();
    }
    DELTAMESH_TRY(scale, search({.first = scale, .trials = kTrials}));
    // Colours within a bound of 0 take far more than within 1: what lies between is for places.
    if (best_ && static_cast<double>(best_->bytes) < kWellUsed * static_cast<double>(budget_))
      DELTAMESH_CHECK(search({.first = scale / 2, .most = scale, .trials = kTrials, .of_attributes = scale}));
    if (best_ && scale <= kFinest) DELTAMESH_CHECK(try_exactly());
    if (!best_) return too_few_bytes(fewest_);
    return std::move(best_->coded);
  }

 private:
  static constexpr double kFinest = 1.0 / 4096;
  static constexpr double kCoarsest = 4096;
  static constexpr int kQuickTrials = 6;
  static constexpr int kTrials = 5;
  static constexpr double kWellUsed = 0.97;  ///< of the bytes

  struct Range {
    double first = 1;
    double most = kCoarsest;
    int trials = kTrials;
    std::optional<double> of_attributes = std::nullopt;  ///< a scale that attributes keep
  };

  /// Returns the best scale.
  Result<double> search(const Range& range) {
    const std::uint64_t vertices = task_.source.positions.size();
    Bracket bracket({.first = range.first,
                     .least = kFinest,
                     .most = range.most,
                     .slope = -1,
                     .aim = excess_of_bytes(budget_, budget_ + budget_ / 300, vertices),
                     .tolerance = excess_of_bytes(budget_, budget_ + budget_ / 100, vertices),
                     .trials = range.trials});
    while (!bracket.is_done()) {
      const double scale = bracket.setting();
      DELTAMESH_TRY(Parts parts, code(scale, range.of_attributes.value_or(scale)));
      fewest_ = std::min(fewest_, parts.bytes);
      if (bracket.tell(excess_of_bytes(parts.bytes, budget_, vertices))) best_ = std::move(parts);
    }
    return bracket.best();
  }

  Result<Parts> code(double scale, double of_attributes) const {
    Request request = request_;
    // A step needs no search of its own, and leaves about such an error.
    constexpr double kStepOfError = 0.22;
    if (request.coder == GeometryCoder::kHighpass)
      request.step = kStepOfError * scale * unit_;
    else
      request.bounds.max_error = scale * unit_;
    return code_both(task_, request, scaled(task_.options.attributes, of_attributes));
  }

  Result<void> try_exactly() {
    if (request_.coder == GeometryCoder::kHighpass) return {};
    Request request = request_;
    request.lossless = true;
    DELTAMESH_TRY(Parts exact, code_both(task_, request, kExactly));
    if (exact.bytes <= budget_) best_ = std::move(exact);
    return {};
  }

  const PartsTask& task_;
  Request request_;
  std::uint64_t budget_;
  double unit_;  ///< the largest error at a scale of 1
  std::optional<Parts> best_;
  std::uint64_t fewest_ = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace

Result<CodedParts> code_parts(const PartsTask& task) {
  DELTAMESH_TRY(Request request, make_request(task.options, task.source));
  request.progress = &task.progress;
  request.attributes_use_positions = attributes_use_positions(task.mesh, task.options);
  if (request.target_bytes && !request.has_bounds() && !task.mesh.attributes.empty())
    return SharedBudget(task, request).run();
  const auto budget =
      std::exchange(request.target_bytes, request.has_bounds() ? std::nullopt : request.target_bytes);
  DELTAMESH_TRY(Parts parts, code_both(task, request, request.lossless ? kExactly : task.options.attributes));
  if (budget && parts.bytes > *budget) return too_few_bytes_for_bounds(parts.bytes);
  return std::move(parts.coded);
}

}  // namespace deltamesh
