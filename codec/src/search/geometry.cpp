// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/geometry.h"

#include <utility>

#include "base/try.h"
#include "search/highpass_search.h"
#include "search/predictive_search.h"

namespace deltamesh {
namespace {

/// How far a highpass stream is forecast below a predictive one before it is taken: it decodes more slowly.
constexpr double kWorthIt = 0.99;
/// How far above it a forecast may be for the search still to be tried, at kThoroughEffort.
constexpr double kHopeless = 1.15;

/// Whether the request leaves the coder open.
bool may_choose(const Request& request) noexcept {
  return request.coder == GeometryCoder::kAuto && !request.bits && !request.step && !request.anchors &&
         !request.anchor_density && !request.lossless;
}

/// Where the highpass coder's strength is not asked for, or what it would lose elsewhere is more.
bool suits_predictive(const PredictiveTrials& trials) {
  const Request& request = trials.request();
  const Bounds& bounds = request.bounds;
  const SourceGeometry& source = trials.source();
  if (request.attributes_use_positions || (!bounds.vde && request.has_bounds())) return true;
  if (!bounds.vde) return false;
  if (lattice_step_for(bounds, source.box) < lattice_step_for({.vde = bounds.vde}, source.box)) return true;
  return are_voxels_enough(trials);
}

/// Of the errors of two coders, the one to tell: that which comes nearer to the request, in fewer bytes.
const Error& nearer(const Error& a, const Error& b) noexcept {
  if (a.code != ErrorCode::kUnmetRequest) return b;
  if (b.code != ErrorCode::kUnmetRequest) return a;
  if (a.best_bytes == 0 || b.best_bytes == 0) return a.best_bytes > 0 ? a : b;
  return a.best_bytes <= b.best_bytes ? a : b;
}

/// Predictive coding is quick; so it comes first. Highpass coding at the same VDE is forecast without a
/// solve.
Result<Candidate> code_smaller(const Request& request, const SourceGeometry& source, const StreamRest& rest) {
  const PredictiveTrials trials(request, source, rest);
  auto predictive = search_predictive(trials);
  const bool is_grid = predictive && predictive->grid && !request.has_bounds();
  if (predictive && (is_grid || suits_predictive(trials))) return predictive;
  MeshHighpassTrials highpass_trials(request, source, rest);
  if (predictive) {
    const double vde = request.bounds.vde.value_or(predictive->quality.vde_rms);
    const auto forecast = forecast_highpass_bytes(request, vde, highpass_trials);
    const double share = request.effort < kThoroughEffort ? kWorthIt : kHopeless;
    if (!forecast || static_cast<double>(*forecast) > share * static_cast<double>(predictive->bytes))
      return predictive;
  }
  auto highpass = predictive ? search_highpass(request, highpass_trials, predictive->bytes)
                             : search_highpass(request, highpass_trials);
  if (!highpass) return predictive ? std::move(predictive) : nearer(predictive.error(), highpass.error());
  if (!predictive) return highpass;
  const bool better = request.has_bounds() ? highpass->bytes < predictive->bytes
                                           : highpass->quality.vde_rms < predictive->quality.vde_rms;
  return better ? std::move(highpass) : std::move(predictive);
}

}  // namespace

Result<Candidate> code_geometry(const Request& request, const SourceGeometry& source,
                                const StreamRest& rest) {
  const auto code = [&]() -> Result<Candidate> {
    // In the plain form places take about as much as deltas, without a search for their settings.
    const bool is_plain = request.profile == Profile::kZstd;
    if (may_choose(request) && !is_plain) return code_smaller(request, source, rest);
    if (request.coder == GeometryCoder::kPredictive || request.lossless || may_choose(request))
      return search_predictive(PredictiveTrials(request, source, rest));
    MeshHighpassTrials trials(request, source, rest);
    return search_highpass(request, trials);
  };
  auto coded = code();
  // The stream of a finite mesh breaks a rule only where numbers leave the range of floats, or where cycles
  // do not converge.
  const bool leaves_range =
      coded ? !is_declarable(coded->quality) : coded.error().code == ErrorCode::kInvalidStream;
  if (leaves_range)
    return Error{.code = ErrorCode::kInvalidMesh,
                 .message =
                     "the coordinates are too large, or differ too much in size, for float32; or the "
                     "highpass coder's cycles do not converge, as around vertices of very many neighbours"};
  return coded;
}

}  // namespace deltamesh
