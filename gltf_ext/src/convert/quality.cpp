// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "convert/quality.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/numbers/vec3.h"
#include "base/try.h"
#include "search/request.h"

namespace deltamesh::gltf {
namespace {

/// A displacement is within a distance where each of its three components is within this part of it.
constexpr double kComponentShare = 0.57735026918962576;
constexpr double kDefaultPercent = 0.02;  // of the diagonal, as the encoder's own
constexpr double kRadiansPerDegree = 0.017453292519943296;

std::optional<double> named_bound(const AttributeQuality& quality, const std::string& name) {
  const auto found =
      std::ranges::find_if(quality.named, [&](const NamedBound& bound) { return bound.name == name; });
  return found == quality.named.end() ? std::nullopt : std::optional(found->error);
}

/// What the encoder keeps of positions that nothing is asked of.
double default_error(const Mesh& mesh) {
  const std::vector<Vec3> points = widen_rows(mesh.positions);
  return deltamesh::default_error(mesh.triangles, points, extent_of(points, Box::around(points)));
}

/// About the largest distance of a decoded position from its source, without coding where a rule tells it.
Result<double> position_error(const EncodeOptions& options, const Mesh& mesh) {
  if (options.lossless) return 0.0;
  const auto in_model = [&](const QualityBound& bound) {
    if (bound.unit != QualityUnit::kDiagonal) return bound.value;
    const std::vector<Vec3> points = widen_rows(mesh.positions);
    return bound.value / 100 * extent_of(points, Box::around(points)).diagonal;
  };
  const auto& most = options.quality.max_error;
  if (most && std::isfinite(most->value) && most->unit != QualityUnit::kPaper) return in_model(*most);
  // Of places anywhere in the cells of a lattice, the farthest are as many times as far off as their rms.
  const auto& mean = options.quality.lfe;
  if (mean && mean->unit != QualityUnit::kPaper) return in_model(*mean) / kComponentShare;
  EncodeOptions trial = options;
  trial.quality.target_bytes.reset();  // shared by scaling all bounds
  if (says_nothing_of_positions(trial)) return default_error(mesh);
  trial.progress = {};
  MeshView positions(mesh);
  positions.attributes.clear();
  DELTAMESH_TRY(const Encoded encoded, encode(positions, trial));
  return encoded.report.stream.quality.max_error;
}

void scale(std::optional<QualityBound>& bound, double factor) noexcept {
  if (bound && bound->unit == QualityUnit::kDiagonal) bound->value *= factor;
}

bool is_displacement(const StreamAttribute& attribute, const std::string& name) {
  return attribute.semantic.target != kBase && attribute.semantic.name == name &&
         attribute.shape.type == ComponentType::kF32;
}

}  // namespace

MergeOptions merge_options(const EncodeOptions& asked, const StreamPlan& plan) noexcept {
  const bool keep_all = asked.keep_unreferenced || plan.exact_order;
  const bool free_order = !keep_all && !asked.keep_order;
  return {.keep_all = keep_all,
          .weld = free_order,
          .drop_degenerate = free_order && !asked.lossless,
          .one_zero = !asked.lossless};
}

Result<EncodeOptions> stream_options(const EncodeOptions& asked, const StreamMesh& stream) {
  EncodeOptions options = asked;
  for (auto* bound : {&options.quality.vde, &options.quality.lfe, &options.quality.max_error})
    scale(*bound, stream.smallest_diagonal);
  const bool asks_nothing = asked.quality.empty() && !asked.bits && !asked.step && !asked.lossless;
  if (asks_nothing && stream.smallest_diagonal < 1)
    options.quality.max_error =
        QualityBound{.value = kDefaultPercent * stream.smallest_diagonal, .unit = QualityUnit::kDiagonal};

  std::vector<NamedBound>& named = options.attributes.named;
  const AttributeQuality& quality = asked.attributes;
  const auto has = [&](const std::string& name) {
    return std::ranges::any_of(stream.attributes,
                               [&](const StreamAttribute& a) { return is_displacement(a, name); });
  };
  // Displacements have the name "d" and their semantic in the stream, see stream_name().
  const auto bound_displacement = [&](const std::string& name, double otherwise) {
    named.push_back({"d" + name, named_bound(quality, name).value_or(otherwise)});
  };
  if (options.lossless) return options;
  options.attributes.uv_error /= stream.uv_scale;
  if (has("POSITION")) {
    double error = 0;
    if (!named_bound(quality, "POSITION")) {
      DELTAMESH_TRY(error, position_error(options, stream.mesh));
    }
    bound_displacement("POSITION", error * kComponentShare);
  }
  const double normal_share = kRadiansPerDegree * kComponentShare;
  if (has("NORMAL")) bound_displacement("NORMAL", quality.normal_error * normal_share);
  if (has("TANGENT"))
    bound_displacement("TANGENT", quality.tangent_error.value_or(quality.normal_error) * normal_share);
  for (const StreamAttribute& attribute : stream.attributes)  // any other displacement that the caller names
    if (const auto bound = named_bound(quality, attribute.semantic.name);
        bound && is_displacement(attribute, attribute.semantic.name))
      bound_displacement(attribute.semantic.name, *bound);
  return options;
}

Result<double> lattice_step(const EncodeOptions& options, const Mesh& mesh) {
  constexpr double kMostSteps = 1U << 27;  // along a side, well within what a lattice can have
  EncodeOptions trial = options;
  trial.geometry = GeometryCoder::kPredictive;
  trial.anchors.reset();
  trial.anchor_density.reset();
  // A bound on distances says nothing of what is seen: the lattice that keeps it has to be found.
  if (trial.quality.vde) trial.quality.max_error.reset();
  if (trial.quality.vde) trial.quality.lfe.reset();
  DELTAMESH_TRY(double error, position_error(trial, mesh));
  if (options.quality.vde && (options.quality.max_error || options.quality.lfe)) {
    trial.quality = options.quality;
    trial.quality.vde.reset();
    DELTAMESH_TRY(const double other, position_error(trial, mesh));
    error = std::min(error, other);
  }
  const double step = 2 * kComponentShare * error;
  return step * kMostSteps < Box::around(widen_rows(mesh.positions)).longest_side() ? 0 : step;
}

EncodeOptions lattice_options(const EncodeOptions& options, double step) {
  EncodeOptions on_lattice = lossless_options(options);
  on_lattice.lossless = false;
  on_lattice.geometry = GeometryCoder::kPredictive;
  on_lattice.step = step;
  return on_lattice;
}

EncodeOptions lossless_options(const EncodeOptions& asked) {
  EncodeOptions options = asked;
  options.lossless = true;
  options.quality = {};
  options.bits.reset();
  options.step.reset();
  options.anchors.reset();
  options.anchor_density.reset();
  return options;
}

}  // namespace deltamesh::gltf
