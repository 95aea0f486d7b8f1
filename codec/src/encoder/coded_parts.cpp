// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/coded_parts.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/numbers/portable_math.h"
#include "base/try.h"
#include "deltamesh/attribute_quality.h"
#include "encoder/coded_attributes.h"
#include "search/bracket.h"
#include "search/geometry.h"
#include "search/request.h"

namespace deltamesh {
namespace {

/// No attribute loses a bit.
const AttributeQuality kExactly{
    .normal_error = 0, .tangent_error = 0, .uv_error = 0, .color_error = 0, .weight_error = 0};

struct Parts {
  CodedParts coded;
  std::uint64_t bytes = 0;  ///< of the whole stream
};

const CodedTopology& order_of(const PartsTask& task, const CodedParts& parts) noexcept {
  return parts.in_grid ? parts.in_grid->topology : task.topology;
}

std::uint64_t bytes_of(const PartsTask& task, const CodedParts& parts) {
  const TopologyChunks& chunks = parts.in_grid ? parts.in_grid->chunks : task.topology_chunks;
  const std::uint64_t others = task.other_bytes + chunks.other_bytes() + parts.attributes.bytes();
  return StreamRest{task.header, others, task.topology_chunks.faces.bytes()}.bytes_with(parts.geometry);
}

EncodeOptions with_bounds(const EncodeOptions& options, const AttributeQuality& bounds) {
  EncodeOptions result = options;
  result.attributes = bounds;
  return result;
}

/// Attributes within their bounds, on the geometry that keeps `request`. `about`: see code_attributes().
Result<Parts> code_both(const PartsTask& task, const Request& request, const AttributeQuality& bounds,
                        bool about = false) {
  const TopologyChunks& chunks = task.topology_chunks;
  const StreamRest rest{task.header, task.other_bytes + chunks.other_bytes(), chunks.faces.bytes()};
  DELTAMESH_TRY(Candidate geometry, code_geometry(request, task.source, rest));
  task.progress.tick();
  CodedParts parts{std::move(geometry), {}, {}};
  if (parts.geometry.grid) {
    CodedTopology ordered = in_grid_order(task.mesh, task.topology, *parts.geometry.grid);
    TopologyChunks ordered_chunks = code_topology_chunks(task.mesh, task.options, ordered);
    parts.in_grid = GridTopology{std::move(ordered), std::move(ordered_chunks)};
  }
  DELTAMESH_TRY(parts.attributes, code_attributes(task.mesh, order_of(task, parts),
                                                  with_bounds(task.options, bounds), parts.geometry, about));
  task.progress.tick();
  const std::uint64_t bytes = bytes_of(task, parts);
  return Parts{std::move(parts), bytes};
}

/// All errors grow and shrink together until the stream nearly has the bytes asked for. What is left, as
/// places come in levels, is for attributes; and what these leave, as some are exact, for places.
class SharedBudget {
 public:
  SharedBudget(const PartsTask& task, const Request& request)
      : task_(task),
        request_(request),
        budget_(static_cast<double>(*request.target_bytes)),
        unit_(default_error(task.source.triangles, task.source.positions, task.source.extent)) {
    request_.target_bytes.reset();
  }

  Result<CodedParts> run() {
    DELTAMESH_CHECK(scale_all());
    if (!best_ && task_.options.attributes.is_asked) return too_few_bytes_for_bounds(fewest_);
    if (!best_) return too_few_bytes(fewest_);
    if (is_exact_) return std::move(best_->coded);
    if (excess(*best_) < kFull) DELTAMESH_CHECK(refine_attributes());
    if (excess(*best_) < kWell) DELTAMESH_CHECK(refine_places());
    return std::move(best_->coded);
  }

 private:
  static constexpr double kFinest = 1.0 / 4096;
  static constexpr double kCoarsest = 4096;
  static constexpr double kAim = -0.005;   ///< an excess: 0.997 of the bytes
  static constexpr double kFull = -0.015;  ///< 0.99
  static constexpr double kWell = -0.045;  ///< 0.97
  static constexpr double kAmple = -0.6;   ///< 0.66: what is exact may fit
  static constexpr double kJump = 0.15;    ///< octaves: places come in levels
  static constexpr double kSlope = -0.5;   ///< of all bytes over all errors, mostly; of attributes alone -1

  /// Whether mean errors of attributes may be off: where none is asked for, none is promised.
  bool about() const noexcept { return !task_.options.attributes.is_asked; }

  /// Binary logarithm of the bytes over those asked for.
  double excess(const Parts& parts) const noexcept {
    return portable_log2(static_cast<double>(parts.bytes) / budget_);
  }

  Result<void> scale_all() {
    Bracket bracket({.first = 1,
                     .least = kFinest,
                     .most = kCoarsest,
                     .slope = kSlope,
                     .aim = kAim,
                     .tolerance = kWell,
                     .narrowest = kJump,
                     .trials = 6});
    bool may_be_exact = request_.coder != GeometryCoder::kHighpass;
    while (!bracket.is_done()) {
      const double scale = bracket.setting();
      auto parts = code(scale, scale);
      if (!parts && !best_) return parts.error();
      if (!parts) {  // finer than the coder can
        bracket.tell(std::numeric_limits<double>::infinity());
        continue;
      }
      fewest_ = std::min(fewest_, parts->bytes);
      const bool is_ample = excess(*parts) < kAmple || (excess(*parts) <= 0 && scale <= kFinest);
      if (bracket.tell(excess(*parts))) best_ = *std::move(parts);
      if (is_ample && std::exchange(may_be_exact, false)) {
        DELTAMESH_CHECK(try_exactly());
        if (is_exact_) return {};
      }
    }
    scale_ = scale_of_attributes_ = bracket.best();
    return {};
  }

  /// Of the errors of attributes or of places alone, from the best on, where they have this share of the
  /// bytes.
  Bracket refinement(double share) const {
    Bracket bracket({.first = scale_,
                     .least = scale_ / 8,
                     .most = scale_,
                     .slope = -std::max(share, 0.3),
                     .aim = kAim,
                     .tolerance = kFull,
                     .trials = 4});
    bracket.tell(excess(*best_));
    return bracket;
  }

  Result<void> refine_attributes() {
    CodedParts& coded = best_->coded;
    Bracket bracket =
        refinement(static_cast<double>(coded.attributes.bytes()) / static_cast<double>(best_->bytes));
    while (!bracket.is_done()) {
      DELTAMESH_TRY(
          ChunkList attributes,
          code_attributes(task_.mesh, order_of(task_, coded),
                          with_bounds(task_.options, scaled(task_.options.attributes, bracket.setting())),
                          coded.geometry, about()));
      task_.progress.tick();
      if (attributes.bytes() == coded.attributes.bytes()) break;  // exact, or an exact coder is smaller
      std::swap(coded.attributes, attributes);
      best_->bytes = bytes_of(task_, coded);
      if (bracket.tell(excess(*best_))) continue;
      std::swap(coded.attributes, attributes);
      best_->bytes = bytes_of(task_, coded);
    }
    scale_of_attributes_ = bracket.best();
    return {};
  }

  Result<void> refine_places() {
    Bracket bracket = refinement(1);
    while (!bracket.is_done()) {
      auto parts = code(bracket.setting(), scale_of_attributes_);
      if (bracket.tell(parts ? excess(*parts) : std::numeric_limits<double>::infinity()))
        best_ = *std::move(parts);
    }
    return {};
  }

  Result<Parts> code(double scale, double of_attributes) {
    Request request = request_;
    if (best_) request.form = form_.at(scale);  // while nothing fits, every form counts
    // A step needs no search of its own, and leaves about such an error.
    constexpr double kStepOfError = 0.22;
    if (request.coder == GeometryCoder::kHighpass)
      request.step = kStepOfError * scale * unit_;
    else
      request.bounds.max_error = scale * unit_;
    DELTAMESH_TRY(Parts parts,
                  code_both(task_, request, scaled(task_.options.attributes, of_attributes), about()));
    const Candidate& geometry = parts.coded.geometry;
    const bool is_on_lattice = geometry.coder == kGeometryPredictive && !geometry.grid &&
                               geometry.predictive.kind == PositionKind::kLattice;
    if (is_on_lattice && !request.form) form_.chosen(geometry.form, scale);
    return parts;
  }

  Result<void> try_exactly() {
    Request request = request_;
    request.lossless = true;
    DELTAMESH_TRY(Parts exact, code_both(task_, request, kExactly));
    is_exact_ = excess(exact) <= 0;
    if (is_exact_) best_ = std::move(exact);
    return {};
  }

  const PartsTask& task_;
  Request request_;
  double budget_;     ///< bytes
  double unit_;       ///< the largest error at a scale of 1
  double scale_ = 1;  ///< of the errors of places
  double scale_of_attributes_ = 1;
  ChosenForm form_;  ///< of a lattice, by the scale
  std::optional<Parts> best_;
  bool is_exact_ = false;  ///< best_
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
