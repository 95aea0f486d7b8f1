// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "convert/budget.h"

#include <algorithm>
#include <iterator>
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

/// Streams that have a number of bytes together. Each gets its share by what it takes without such a limit;
/// one that does not get so small takes what it needs from the others.
class SharedBytes {
 public:
  SharedBytes(const StreamPacker& packer, const std::vector<StreamPlan>& plans, const EncodeOptions& asked)
      : packer_(packer),
        plans_(plans),
        asked_(asked),
        most_(static_cast<double>(*asked.quality.target_bytes)),
        weights_(plans.size()),
        least_(plans.size()) {}

  Result<std::vector<StreamPacker::Coded>> run() {
    if (plans_.size() > 1) DELTAMESH_CHECK(weigh());
    for (;;) {
      std::vector<StreamPacker::Coded> coded;
      double left = most_;
      while (coded.size() < plans_.size()) {
        auto stream = code(coded.size(), left);
        if (!stream && !demand(coded.size(), stream.error())) return stream.error();
        if (!stream) break;
        left -= static_cast<double>(stream->encoded.bytes.size());
        coded.push_back(*std::move(stream));
      }
      if (coded.size() == plans_.size()) return coded;
    }
  }

 private:
  Result<void> weigh() {
    EncodeOptions options = asked_;
    options.quality.target_bytes.reset();
    options.effort = 0;
    options.progress = {};
    for (std::size_t i = 0; i < plans_.size(); ++i) {
      DELTAMESH_TRY(const auto coded, packer_.code(plans_[i], options));
      weights_[i] = static_cast<double>(coded.encoded.bytes.size());
    }
    return {};
  }

  /// Stream `i` with its share of what is left for it and those behind it: what earlier ones left of their
  /// shares is theirs.
  Result<StreamPacker::Coded> code(std::size_t i, double left) const {
    EncodeOptions options = asked_;
    options.progress = partial_progress(asked_.progress, i, plans_.size());
    if (plans_.size() > 1)
      options.quality.target_bytes = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(share(i, left)));
    return packer_.code(plans_[i], options);
  }

  /// Streams whose shares would be less than they need get that, the others share the rest.
  double share(std::size_t i, double left) const {
    std::vector<bool> is_needy(plans_.size());
    for (bool is_done = false; !is_done;) {
      double rest = left;
      double weight = 0;
      for (std::size_t k = i; k < plans_.size(); ++k)
        if (is_needy[k])
          rest -= least_[k];
        else
          weight += weights_[k];
      is_done = true;
      for (std::size_t k = i; k < plans_.size(); ++k)
        if (!is_needy[k] && least_[k] > rest * weights_[k] / weight) {
          is_needy[k] = true;
          is_done = false;
        }
      if (is_done) return is_needy[i] ? least_[i] : rest * weights_[i] / weight;
    }
    return 0;
  }

  /// Notes what stream `i` needs, which its share was less than. False: there is no way to give it that.
  bool demand(std::size_t i, const Error& error) {
    constexpr double kMore = 1.02;  // the search may not find again what it found on its way
    if (error.code != ErrorCode::kUnmetRequest || error.best_bytes == 0 || plans_.size() == 1) return false;
    least_[i] = std::max(static_cast<double>(error.best_bytes), kMore * least_[i]);
    return std::accumulate(least_.begin(), least_.end(), 0.0) <= most_;
  }

  const StreamPacker& packer_;
  const std::vector<StreamPlan>& plans_;
  const EncodeOptions& asked_;
  double most_;
  std::vector<double> weights_;
  std::vector<double> least_;  ///< bytes that a stream is known to need; 0: not known
};

/// Errors of one stream among several say nothing of all.
Error shared_error(const Error& error, std::size_t streams) noexcept {
  if (error.code != ErrorCode::kUnmetRequest || streams == 1) return error;
  return {.code = ErrorCode::kUnmetRequest,
          .message = "the asset's streams do not get so small together as the bytes asked for"};
}

}  // namespace

Result<std::vector<PackedPrimitive>> pack_streams(StreamPacker& packer, const std::vector<StreamPlan>& plans,
                                                  const EncodeOptions& asked, GltfReport& report) {
  std::vector<StreamPacker::Coded> shared;
  if (asked.quality.target_bytes && !plans.empty()) {
    auto coded = SharedBytes(packer, plans, asked).run();
    if (!coded) return shared_error(coded.error(), plans.size());
    shared = *std::move(coded);
  } else {
    DELTAMESH_CHECK(packer.choose_lattices(plans, asked));
  }
  std::vector<PackedPrimitive> packed;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    EncodeOptions options = asked;
    options.progress = partial_progress(asked.progress, i, plans.size());
    auto coded = shared.empty() ? packer.code(plans[i], options) : std::move(shared[i]);
    if (!coded) return coded.error();
    DELTAMESH_TRY(auto primitives, packer.pack(plans[i], *std::move(coded), report));
    packed.insert(packed.end(), std::make_move_iterator(primitives.begin()),
                  std::make_move_iterator(primitives.end()));
  }
  return packed;
}

}  // namespace deltamesh::gltf
