// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rate control's trials on a real mesh: coded, decoded, measured.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "encoder/source_geometry.h"
#include "highpass/highpass.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "search/bounds.h"
#include "search/coded_geometry.h"
#include "search/trial.h"

namespace deltamesh {

class HighpassTrials final : public TrialCoder {
 public:
  /// `anchors`: of the source's graph; `coder`: of the source and `anchors`; `positions`: those that run()
  /// measures. All references must outlive the trials.
  HighpassTrials(const EncodeOptions& options, const SourceGeometry& source, AnchorSequence& anchors,
                 HighpassCoder& coder, const StreamRest& rest, HighpassCoder::Positions positions);

  /// Codes without planned cycles. The quality in the figures leaves room for the errors that plan() may add.
  Result<TrialFigures> run(const HighpassSettings& settings) override;
  Result<std::uint64_t> bytes(const HighpassSettings& settings) override;
  double delta_error(const HighpassSettings& settings) override { return coder_.delta_error(settings); }
  std::vector<std::uint32_t> worst_vertices(const Attempt& attempt, double threshold,
                                            std::size_t count) override;
  std::uint32_t anchors_for_density(std::uint32_t density) override;
  std::uint32_t fewest_anchors() override { return anchors_.fewest(); }
  std::uint32_t most_anchors() override { return anchors_.most(); }
  double largest_delta() override { return coder_.largest_delta(); }
  double delta_range() override { return coder_.range(); }
  double longest_side() override { return source_.box.longest_side(); }
  bool has_small_components() override { return anchors_.most() < source_.positions.size(); }

  double step_for_bits(int bits) const noexcept { return coder_.step_for_bits(bits); }

  /// The geometry that run() coded for the attempt.
  static const CodedGeometry& geometry(const Attempt& attempt) noexcept;

  /// The same mesh with planned cycles that keep `bounds` in hardly more bytes than `attempt` takes, and at
  /// most `most_bytes`: the fewest, or 4, 6 or 8 where anchors keep a largest error. Where no number of
  /// cycles does, the attempt itself, whose quality as decoded may break `bounds`. Cost: some solves; with
  /// such anchors up to a few dozen short ones.
  Result<CodedGeometry> plan(const Attempt& attempt, const Bounds& bounds,
                             std::optional<std::uint64_t> most_bytes);

 private:
  Result<CodedGeometry> to_geometry(const CodedHighpass& coded) const;
  /// With its quality.
  Result<CodedGeometry> measured(const CodedHighpass& coded) const;
  /// With its quality as decoded; nothing where that breaks `bounds`, or where it takes more bytes.
  std::optional<CodedGeometry> fitting(const CodedHighpass& coded, const Bounds& bounds,
                                       std::uint64_t most_bytes) const;
  /// `settings`, of a stream of so many bytes, with planned cycles, and with anchors where errors are too
  /// large then; nothing where `bounds`, with a largest error, cannot be kept so.
  std::optional<CodedGeometry> plan_peaks(HighpassSettings settings, const Bounds& bounds,
                                          std::uint64_t bytes, std::uint64_t most_bytes);
  /// As worst_vertices(), for `positions`.
  std::vector<std::uint32_t> peaks(const HighpassSettings& settings, std::span<const Vec3> positions,
                                   double threshold, std::size_t count);

  const EncodeOptions& options_;
  const SourceGeometry& source_;
  AnchorSequence& anchors_;
  StreamRest rest_;
  HighpassCoder& coder_;
  HighpassCoder::Positions positions_;
};

}  // namespace deltamesh
