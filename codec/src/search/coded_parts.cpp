// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/coded_parts.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/numbers/portable_math.h"
#include "base/try.h"
#include "deltamesh/attribute_quality.h"
#include "encoder/coded_attributes.h"
#include "search/default_quality.h"
#include "search/geometry_task.h"
#include "search/unmet.h"

namespace deltamesh {
namespace {

/// Looks for the scale of errors whose stream comes nearest to a number of bytes from below.
class ScaleSearch {
 public:
  explicit ScaleSearch(std::uint64_t most_bytes) : most_bytes_(static_cast<double>(most_bytes)) {}

  /// Of the next trial.
  double scale() const noexcept { return portable_exp2(exponent_); }
  /// How many bytes that took. Returns whether they fit.
  bool tell(std::uint64_t bytes);
  /// Whether another trial would gain next to nothing.
  bool is_done() const noexcept { return done_; }
  /// Whether even the finest scale fits.
  bool has_room() const noexcept { return fits_.bytes >= 0 && fits_.exponent <= kFinest; }

 private:
  /// A tried scale, as an exponent of 2, and what it took; bytes fall about as the exponent grows.
  struct Trial {
    double exponent = 0;
    double bytes = -1;  ///< none yet
  };
  static constexpr double kFinest = -12;
  static constexpr double kCoarsest = 12;

  double most_bytes_;
  double exponent_ = 0;
  bool done_ = false;
  Trial too_large_;
  Trial fits_;
};

constexpr double kLargestAngle = 45;     // degrees
constexpr double kLargestUv = 1.0 / 16;  // texture coordinate units
constexpr double kLargestColor = 64;     // 255ths
constexpr double kLargestWeight = 1.0 / 8;

/// At most `largest`, unless more was asked for.
double scaled_to(double bound, double scale, double largest) noexcept {
  return std::min(bound * scale, std::max(bound, largest));
}

/// `quality` with every bound `scale` times as large, at most to where an attribute would mean nothing any
/// more. Exact colours stay exact up to a scale of 1; then they may be off by `scale` - 1 255ths. `scale`:
/// above 0.
AttributeQuality scaled(const AttributeQuality& quality, double scale) {
  AttributeQuality result = quality;
  result.normal_error = scaled_to(quality.normal_error, scale, kLargestAngle);
  if (quality.tangent_error) result.tangent_error = scaled_to(*quality.tangent_error, scale, kLargestAngle);
  result.uv_error = scaled_to(quality.uv_error, scale, kLargestUv);
  result.color_error = std::min(quality.color_error * scale + std::max(scale - 1, 0.0),
                                std::max(quality.color_error, kLargestColor));
  result.weight_error = scaled_to(quality.weight_error, scale, kLargestWeight);
  for (NamedBound& bound : result.named) bound.error *= scale;
  return result;
}

bool ScaleSearch::tell(std::uint64_t bytes) {
  constexpr double kCloseEnough = 0.99;  // of the bytes
  constexpr double kFirstStride = 3;
  const Trial now{exponent_, static_cast<double>(bytes)};
  const bool fits = now.bytes <= most_bytes_;
  (fits ? fits_ : too_large_) = now;
  done_ = (fits && (now.bytes > kCloseEnough * most_bytes_ || exponent_ <= kFinest)) ||
          (!fits && exponent_ >= kCoarsest);
  if (fits_.bytes < 0 || too_large_.bytes < 0) {
    exponent_ = std::clamp(exponent_ + (fits ? -kFirstStride : kFirstStride), kFinest, kCoarsest);
    return fits;
  }
  // On the line between both, but well inside, as bytes need not fall evenly.
  const double share = (too_large_.bytes - most_bytes_) / (too_large_.bytes - fits_.bytes);
  exponent_ =
      too_large_.exponent + std::clamp(share + 0.02, 0.1, 0.9) * (fits_.exponent - too_large_.exponent);
  return fits;
}

/// Stage ends as shares of the whole time, for the progress callback.
constexpr double kGeometryDone = 0.75;
constexpr double kAttributesDone = 0.95;

/// No attribute loses a bit.
const AttributeQuality kExactly{.normal_error = 0, .tangent_error = 0, .uv_error = 0, .weight_error = 0};

QualityRequest default_request(const PartsTask& task) {
  return default_quality(task.source.triangles, task.source.positions, task.source.box);
}

std::uint64_t bytes_of(const PartsTask& task, const CodedParts& parts) {
  return StreamRest{task.header, task.chunk_bytes + parts.attributes.bytes()}.bytes_with(parts.geometry);
}

/// Attributes within their own bounds, on the geometry that keeps its own.
Result<CodedParts> code_asked(const PartsTask& task, const EncodeOptions& options) {
  const auto code_on = [&](std::span<const float> positions) {
    return code_attributes(task.mesh, task.topology, options, positions);
  };
  AttributeBytes attribute_bytes;
  if (attributes_use_positions(task.mesh, options)) {
    attribute_bytes = [&](std::span<const float> positions) -> Result<std::uint64_t> {
      DELTAMESH_TRY(const auto coded, code_on(positions));
      return coded.bytes();
    };
  }
  const StreamRest rest{task.header, task.chunk_bytes};
  DELTAMESH_TRY(auto geometry, code_geometry({options, task.source, rest, attribute_bytes}));
  if (options.progress) options.progress(kGeometryDone);
  DELTAMESH_TRY(auto attributes, code_on(geometry.positions));
  if (options.progress) options.progress(kAttributesDone);
  return CodedParts{std::move(geometry), std::move(attributes)};
}

/// All errors grow and shrink together until the stream has the bytes asked for.
Result<CodedParts> share_bytes(const PartsTask& task, const EncodeOptions& asked) {
  const std::uint64_t target = *asked.quality.target_bytes;
  const double unit = default_request(task).max_error->value;
  std::optional<CodedParts> best;
  std::uint64_t fewest = ~std::uint64_t{0};
  ScaleSearch search(target);
  for (int i = 0; i < 6 + asked.effort && !search.is_done(); ++i) {
    EncodeOptions options = asked;
    options.quality = {.max_error = QualityBound{search.scale() * unit}};
    options.attributes = scaled(asked.attributes, search.scale());
    DELTAMESH_TRY(CodedParts parts, code_asked(task, options));
    const std::uint64_t bytes = bytes_of(task, parts);
    fewest = std::min(fewest, bytes);
    if (search.tell(bytes)) best = std::move(parts);
  }
  if (search.has_room() && asked.profile == Profile::kSmallest &&
      asked.geometry != GeometryCoder::kHighpass) {
    EncodeOptions options = asked;
    options.quality = {};
    options.lossless = true;
    options.attributes = kExactly;
    DELTAMESH_TRY(CodedParts parts, code_asked(task, options));
    if (bytes_of(task, parts) <= target) return parts;
  }
  if (best) return *std::move(best);
  return too_few_bytes(fewest);
}

/// The best geometry beside attributes within their bounds, in no more than the bytes asked for. What these
/// take depends on the positions, and what is left for positions on the attributes.
Result<CodedParts> fit_geometry(const PartsTask& task, const EncodeOptions& options) {
  constexpr int kMostFits = 3;
  std::optional<CodedParts> best;
  DELTAMESH_TRY(ChunkList attributes, code_attributes(task.mesh, task.topology, options, {}));
  std::uint64_t fewest = ~std::uint64_t{0};
  for (int i = 0; i < kMostFits; ++i) {
    const StreamRest rest{task.header, task.chunk_bytes + attributes.bytes()};
    auto geometry = code_geometry({options, task.source, rest});
    if (!geometry && !best) return geometry.error();
    if (!geometry) break;
    DELTAMESH_TRY(attributes, code_attributes(task.mesh, task.topology, options, geometry->positions));
    CodedParts parts{*std::move(geometry), attributes};
    const std::uint64_t bytes = bytes_of(task, parts);
    fewest = std::min(fewest, bytes);
    if (bytes <= *options.quality.target_bytes)
      best = std::move(parts);
    else if (best)
      break;
  }
  if (options.progress) options.progress(kAttributesDone);
  if (best) return *std::move(best);
  return too_few_bytes(fewest);
}

}  // namespace

Result<CodedParts> code_parts(const PartsTask& task) {
  EncodeOptions options = task.options;
  if (options.lossless) options.attributes = kExactly;
  const QualityRequest& quality = options.quality;
  if (quality.target_bytes && !task.mesh.attributes.empty()) {
    const bool bytes_alone = !quality.vde && !quality.lfe && !quality.max_error;
    return bytes_alone ? share_bytes(task, options) : fit_geometry(task, options);
  }
  if (!asks_for_nothing(options)) return code_asked(task, options);
  options.quality = default_request(task);
  auto parts = code_asked(task, options);
  if (parts || parts.error().code != ErrorCode::kUnmetRequest) return parts;
  // A highpass stream, where the profile asks for one, may not reach the default: the best that it can do.
  options.quality = {};
  options.bits = 16;
  return code_asked(task, options);
}

}  // namespace deltamesh
