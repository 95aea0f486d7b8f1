// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "convert/budget.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/try.h"

namespace deltamesh::gltf {
namespace {

/// The stream's share of the whole asset's progress.
std::function<void(double)> partial_progress(const std::function<void(double)>& progress, std::size_t done,
                                             std::size_t total) {
  if (!progress) return {};
  return [&progress, done, total](double share) {
    progress((static_cast<double>(done) + share) / static_cast<double>(total));
  };
}

/// What each stream takes without a limit on bytes.
Result<std::vector<double>> natural_bytes(const StreamPacker& packer, const std::vector<StreamPlan>& plans,
                                          const EncodeOptions& asked) {
  EncodeOptions options = asked;
  options.quality.target_bytes.reset();
  options.effort = 0;
  options.progress = {};
  std::vector<double> bytes;
  for (const StreamPlan& plan : plans) {
    DELTAMESH_TRY(const std::uint64_t size, packer.measure(plan, options));
    bytes.push_back(static_cast<double>(size));
  }
  return bytes;
}

}  // namespace

Result<std::vector<PackedPrimitive>> pack_streams(StreamPacker& packer, const std::vector<StreamPlan>& plans,
                                                  const EncodeOptions& asked, GltfReport& report) {
  const auto most_bytes = asked.quality.target_bytes;
  std::vector<double> weights;
  if (most_bytes && plans.size() > 1) {
    DELTAMESH_TRY(weights, natural_bytes(packer, plans, asked));
  }
  if (!most_bytes) DELTAMESH_CHECK(packer.choose_lattices(plans, asked));
  double weight = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<PackedPrimitive> packed;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    EncodeOptions options = asked;
    options.progress = partial_progress(asked.progress, i, plans.size());
    if (!weights.empty()) {
      // What earlier streams left of their shares is for the later ones.
      const auto left = static_cast<double>(*most_bytes - report.stream_bytes);
      options.quality.target_bytes =
          std::max<std::uint64_t>(1, static_cast<std::uint64_t>(left * (weights[i] / weight)));
      weight -= weights[i];
    }
    auto primitives = packer.pack(plans[i], options, report);
    const bool is_too_large = !primitives && primitives.error().code == ErrorCode::kUnmetRequest;
    if (most_bytes && ((is_too_large && plans.size() > 1) || report.stream_bytes > *most_bytes))
      return Error{
          .code = ErrorCode::kUnmetRequest,
          .message = "one of the asset's streams does not get as small as its share of the bytes asked for"};
    if (!primitives) return primitives.error();
    packed.insert(packed.end(), std::make_move_iterator(primitives->begin()),
                  std::make_move_iterator(primitives->end()));
  }
  return packed;
}

}  // namespace deltamesh::gltf
