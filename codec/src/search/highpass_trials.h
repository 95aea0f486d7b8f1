// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The highpass coder as a search sees it: candidates from settings.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "highpass/highpass.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "search/candidate.h"
#include "search/request.h"

namespace deltamesh {

/// A mesh that can be coded under any settings. An interface, so that the search can be tested with formulas.
class HighpassTrials {
 public:
  HighpassTrials() = default;
  HighpassTrials(const HighpassTrials&) = delete;
  HighpassTrials& operator=(const HighpassTrials&) = delete;
  virtual ~HighpassTrials() = default;

  /// Codes, decodes and measures. Dear: a solve. Errors: kInvalidStream, kInvalidArgument where the settings
  /// make no stream that decodes [DELT-3, DELT-4, GEO-1, HDR-9].
  virtual Result<Candidate> make(const HighpassSettings& settings) = 0;
  /// Candidate::bytes, without a solve.
  virtual Result<std::uint64_t> bytes(const HighpassSettings& settings) = 0;
  /// Root mean square of the error of the quantised deltas; infinite where the step is too small to code.
  /// Cheap. VDE is proportional to it, whatever the step and the strength of diffusion.
  virtual double delta_error(const HighpassSettings& settings) = 0;
  /// At most `count` vertices whose error is largest among the vertices around them and above `threshold`,
  /// largest first. None where anchors there would do more harm.
  virtual std::vector<std::uint32_t> worst_vertices(const Candidate& candidate, double threshold,
                                                    std::size_t count) = 0;

  /// Anchors of container `density`, at least fewest_anchors().
  virtual std::uint32_t anchors_for_density(std::uint32_t density) = 0;
  virtual std::uint32_t fewest_anchors() = 0;  ///< one for every solved component
  virtual std::uint32_t most_anchors() = 0;    ///< all solved vertices
  virtual double step_for_bits(int bits) = 0;  ///< range / 2^bits
  virtual double largest_delta() = 0;          ///< 0 where all deltas are 0
  virtual double delta_range() = 0;            ///< largest minus smallest delta
  virtual double longest_side() = 0;           ///< of the bounding box
  virtual bool has_small_components() = 0;     ///< coded by anchors alone
};

inline constexpr int kDefaultDeltaBits = 8;  ///< where neither a quality nor a step is asked for

/// Achieved errors over the bounds; infinite where a candidate does not decode.
struct Loads {
  double visual = 0;
  double positional = 0;
  double all() const noexcept { return std::max(visual, positional); }
};

/// Makes candidates and remembers what a search ends with.
class HighpassRecord {
 public:
  /// The arguments must outlive the record.
  HighpassRecord(const Request& request, HighpassTrials& trials) : request_(request), trials_(trials) {}

  /// Made once where the settings are those of the call before. Errors: those of HighpassTrials::make() but
  /// for settings that make no stream that decodes.
  Result<Loads> make(const HighpassSettings& settings);
  /// The last one that decodes; null before.
  const std::shared_ptr<const Candidate>& last() const noexcept { return last_; }
  /// The smallest that keeps all bounds; null before.
  const std::shared_ptr<const Candidate>& best() const noexcept { return best_; }
  /// A copy of best(), or why there is none. Precondition: something has been made.
  Result<Candidate> result() const;

 private:
  struct Figures {
    Quality quality{};
    std::uint64_t bytes = 0;
  };

  const Request& request_;
  HighpassTrials& trials_;
  std::optional<std::pair<HighpassSettings, Loads>> made_;  ///< by the last call
  std::shared_ptr<const Candidate> last_;
  std::shared_ptr<const Candidate> best_;
  std::optional<Figures> nearest_;  ///< of the smallest load
  double nearest_load_ = 0;
  std::optional<Error> failure_;  ///< the last one
};

/// Those of a real mesh.
class MeshHighpassTrials final : public HighpassTrials {
 public:
  /// The arguments must outlive the trials.
  MeshHighpassTrials(const Request& request, const SourceGeometry& source, const StreamRest& rest);

  Result<Candidate> make(const HighpassSettings& settings) override;
  Result<std::uint64_t> bytes(const HighpassSettings& settings) override;
  double delta_error(const HighpassSettings& settings) override { return coder_.delta_error(settings); }
  std::vector<std::uint32_t> worst_vertices(const Candidate& candidate, double threshold,
                                            std::size_t count) override;
  std::uint32_t anchors_for_density(std::uint32_t density) override {
    return anchors_.count_for_density(source_.graph.graph(), density);
  }
  std::uint32_t fewest_anchors() override { return anchors_.fewest(); }
  std::uint32_t most_anchors() override { return anchors_.most(); }
  double step_for_bits(int bits) override { return coder_.step_for_bits(bits); }
  double largest_delta() override { return coder_.largest_delta(); }
  double delta_range() override { return coder_.range(); }
  double longest_side() override { return source_.box.longest_side(); }
  bool has_small_components() override { return anchors_.most() < source_.positions.size(); }

 private:
  Candidate without_quality(const CodedHighpass& coded, const HighpassSettings& settings) const;

  const Request& request_;
  const SourceGeometry& source_;
  StreamRest rest_;
  AnchorContainers own_containers_;
  AnchorSequence& anchors_;
  HighpassCoder coder_;
  int cycles_ = 0;                       ///< of the last candidate
  HighpassSettings settings_of_cycles_;  ///< that they were chosen for
};

}  // namespace deltamesh
