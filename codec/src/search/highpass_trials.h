// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rate control's trials on a real mesh: coded, decoded, measured.
#pragma once

#include <cstdint>
#include <vector>

#include "encoder/source_geometry.h"
#include "highpass/highpass.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "search/coded_geometry.h"
#include "search/trial.h"

namespace deltamesh {

class HighpassTrials final : public TrialCoder {
 public:
  /// `anchors`: of the source's graph; `coder`: of the source and `anchors`; `most_left_out`: as of
  /// HighpassCoder::fewest_cycles(). All references must outlive the trials.
  HighpassTrials(const EncodeOptions& options, const SourceGeometry& source, AnchorSequence& anchors,
                 HighpassCoder& coder, const StreamRest& rest, double most_left_out);

  /// The first run with another number of anchors chooses the number of planned cycles.
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

 private:
  Result<CodedGeometry> to_geometry(const CodedHighpass& coded) const;

  const EncodeOptions& options_;
  const SourceGeometry& source_;
  AnchorSequence& anchors_;
  StreamRest rest_;
  HighpassCoder& coder_;
  double most_left_out_;
  int cycles_ = 0;  ///< 0: not known yet
  std::uint32_t anchors_of_cycles_ = 0;
};

}  // namespace deltamesh
