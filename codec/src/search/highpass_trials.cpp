// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "search/highpass_trials.h"

#include <limits>

#include "base/progress.h"
#include "base/try.h"
#include "format/vertex_positions.h"
#include "measure/error_peaks.h"
#include "measure/measure.h"

namespace deltamesh {
namespace {

/// Of a largest error that is asked for: what cycles may leave out for deltas and anchors to make up for.
constexpr double kMostLeftOut = 0.3;
/// The same where anchors mend the largest errors, which leave the deltas as they are.
constexpr double kMostLeftToMend = 0.01;

}  // namespace

Result<Loads> HighpassRecord::make(const HighpassSettings& settings) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (made_ && made_->first == settings) return made_->second;
  made_.emplace(settings, Loads{kInfinity, kInfinity});
  auto made = trials_.make(settings);
  if (!made) {
    const Error& error = made.error();
    if (error.code != ErrorCode::kInvalidStream && error.code != ErrorCode::kInvalidArgument) return error;
    failure_ = error;
    return made_->second;
  }
  last_ = std::make_shared<const Candidate>(*std::move(made));
  const Quality& quality = last_->quality;
  const double load = request_.bounds.load(quality);
  if (!nearest_ || load < nearest_load_) {
    nearest_ = {quality, last_->bytes};
    nearest_load_ = load;
  }
  if (load <= 1 && (!best_ || last_->bytes < best_->bytes)) best_ = last_;
  made_->second = {request_.bounds.visual_load(quality), request_.bounds.positional_load(quality)};
  return made_->second;
}

Result<Candidate> HighpassRecord::result() const {
  if (!best_ && !nearest_) return *failure_;
  if (!best_) return unmet_bounds(request_.bounds, nearest_->quality, nearest_->bytes);
  if (request_.target_bytes && best_->bytes > *request_.target_bytes)
    return too_few_bytes_for_bounds(best_->bytes);
  Candidate best = *best_;
  const bool is_default = !request_.step && !request_.has_bounds() && !request_.target_bytes;
  best.highpass.bits = static_cast<std::uint8_t>(request_.bits.value_or(is_default ? kDefaultDeltaBits : 0));
  return best;
}

MeshHighpassTrials::MeshHighpassTrials(const Request& request, const SourceGeometry& source,
                                       const StreamRest& rest)
    : request_(request),
      source_(source),
      rest_(rest),
      anchors_((request.containers != nullptr ? *request.containers : own_containers_)
                   .impl()
                   .sequence(source.graph.graph(), source.graph.components())),
      coder_(source.graph.graph(), source.graph.components(), anchors_, source.positions, source.box,
             request.profile == Profile::kZstd) {}

Candidate MeshHighpassTrials::without_quality(const CodedHighpass& coded,
                                              const HighpassSettings& settings) const {
  Candidate candidate{.settings = settings,
                      .highpass = coded.parameters,
                      .chunks = ChunkList(request_.profile, request_.effort)};
  candidate.chunks.add(kTagDeltas, coded.deltas);
  candidate.chunks.add(kTagAnchors, coded.anchors);
  candidate.bytes = rest_.bytes_with(candidate);
  if (request_.progress != nullptr) request_.progress->tick();
  return candidate;
}

Result<Candidate> MeshHighpassTrials::make(const HighpassSettings& settings) {
  // Cycles serve larger steps, hardly smaller ones, and up to twice as many anchors.
  const HighpassSettings& before = settings_of_cycles_;
  const bool serve = cycles_ > 0 && settings.mends == before.mends && settings.anchors >= before.anchors &&
                     settings.anchors <= 2 * before.anchors && settings.step >= 0.8 * before.step;
  if (!serve) {
    const double most_left_out = (settings.mends ? kMostLeftToMend : kMostLeftOut) *
                                 request_.bounds.max_error.value_or(std::numeric_limits<double>::infinity());
    DELTAMESH_TRY(cycles_, coder_.fewest_cycles(settings, most_left_out));
    settings_of_cycles_ = settings;
  }
  DELTAMESH_TRY(CodedHighpass coded, coder_.code(settings, cycles_));
  DELTAMESH_TRY(const auto decoded, to_float_positions(coded.positions));
  Candidate candidate = without_quality(coded, settings);
  candidate.quality = measure_quality(source_.graph.graph(), source_.positions, decoded);
  if (!is_declarable(candidate.quality))
    return Error{.code = ErrorCode::kInvalidStream,
                 .message = "an error of the decoded positions is not a finite float32",
                 .rule = "HDR-9"};
  candidate.solution = std::move(coded.positions);
  return candidate;
}

Result<std::uint64_t> MeshHighpassTrials::bytes(const HighpassSettings& settings) {
  DELTAMESH_TRY(const CodedHighpass coded, coder_.code_only(settings));
  return without_quality(coded, settings).bytes;
}

std::vector<std::uint32_t> MeshHighpassTrials::worst_vertices(const Candidate& candidate, double threshold,
                                                              std::size_t count) {
  // Around a further anchor the deltas no longer make up for what the cycles leave out.
  const auto left_out = coder_.left_out_by(candidate.settings, candidate.highpass.cycles);
  if (!left_out || *left_out > request_.bounds.max_error) return {};
  std::vector<double> errors(candidate.solution.size());
  for (std::size_t v = 0; v < errors.size(); ++v) {
    Vec3 decoded = candidate.solution[v];
    for (double& x : decoded) x = static_cast<float>(x);
    errors[v] = length(decoded - source_.positions[v]);
  }
  std::vector<std::uint8_t> excluded(errors.size(), 0);
  for (const std::uint32_t anchor : coder_.anchors_for(candidate.settings).vertices) excluded[anchor] = 1;
  return error_peaks(source_.graph.graph(), errors, excluded, threshold, count);
}

}  // namespace deltamesh
