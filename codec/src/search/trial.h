// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The interface of geometry coders to rate control. It has no bytes, so that rate control can be tested with
// formulas.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"
#include "highpass/settings.h"

namespace deltamesh {

/// A coder's own record of a run.
struct CodedTrial {
  virtual ~CodedTrial() = default;
};

struct TrialFigures {
  Quality quality{};
  std::uint64_t bytes = 0;    ///< of the whole stream
  std::uint32_t density = 0;  ///< v: most edges from a vertex to its nearest anchor
  std::shared_ptr<const CodedTrial> coded{};
};

/// One run of the coder.
struct Attempt {
  HighpassSettings settings{};
  TrialFigures figures{};

  /// Otherwise the stream of these settings breaks a rule of the format [DELT-3, DELT-4, GEO-1, HDR-9], and
  /// the figures are infinite.
  bool decodes() const noexcept { return std::isfinite(figures.quality.max_error); }
};

/// A mesh that can be coded under any settings.
class TrialCoder {
 public:
  TrialCoder() = default;
  TrialCoder(const TrialCoder&) = delete;
  TrialCoder& operator=(const TrialCoder&) = delete;
  virtual ~TrialCoder() = default;

  /// Codes, decodes and measures. Dear: a solve.
  virtual Result<TrialFigures> run(const HighpassSettings& settings) = 0;
  /// Codes only; TrialFigures::bytes.
  virtual Result<std::uint64_t> bytes(const HighpassSettings& settings) = 0;
  /// Root mean square of the error of the quantised deltas; infinite where the step is too small to code.
  /// Cheap. VDE is proportional to it, whatever the step and the strength of diffusion.
  virtual double delta_error(const HighpassSettings& settings) = 0;

  /// At most `count` vertices of a run that decodes whose error is largest among the vertices around them and
  /// above `threshold`, largest first.
  virtual std::vector<std::uint32_t> worst_vertices(const Attempt& attempt, double threshold,
                                                    std::size_t count) = 0;

  /// Anchors of container `density`, at least fewest_anchors().
  virtual std::uint32_t anchors_for_density(std::uint32_t density) = 0;
  virtual std::uint32_t fewest_anchors() = 0;  ///< one for every solved component
  virtual std::uint32_t most_anchors() = 0;    ///< all solved vertices
  virtual double largest_delta() = 0;          ///< 0 where all deltas are 0
  virtual double delta_range() = 0;            ///< largest minus smallest delta
  virtual double longest_side() = 0;           ///< of the bounding box
  virtual bool has_small_components() = 0;     ///< coded by anchors alone
};

}  // namespace deltamesh
