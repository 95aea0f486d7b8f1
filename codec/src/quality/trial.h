// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What rate control turns, and what it sees: a geometry coder behind an interface without bytes, so that
// rate control can be tested on formulas.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"

namespace deltamesh {

/// Settings of the highpass coder, as rate control chooses them.
struct CoderSettings {
  double step = 1;                            ///< of delta coordinates, model units, above 0
  double rate_weight = 0;                     ///< 0 or more; more makes symbols cheaper and errors larger
  bool centroids = true;                      ///< reconstruct at the centroids of bins: a lower VDE
  double diffusion = 0;                       ///< strength of error diffusion, 0 to 1
  std::uint32_t anchors = 0;                  ///< the first so many of the anchor sequence
  std::vector<std::uint32_t> more_anchors{};  ///< vertices that are anchors besides
  int anchor_bits = 12;                       ///< 4 to 24
};

struct TrialFigures {
  Quality quality{};
  std::uint64_t bytes = 0;    ///< of the whole stream
  std::uint32_t density = 0;  ///< v: most edges from a vertex to its nearest anchor
};

/// A mesh that can be coded under any settings.
class TrialCoder {
 public:
  TrialCoder() = default;
  TrialCoder(const TrialCoder&) = delete;
  TrialCoder& operator=(const TrialCoder&) = delete;
  virtual ~TrialCoder() = default;

  /// Codes, decodes and measures. Dear: a solve.
  virtual Result<TrialFigures> run(const CoderSettings& settings) = 0;
  /// Codes only; TrialFigures::bytes.
  virtual Result<std::uint64_t> bytes(const CoderSettings& settings) = 0;
  /// Root mean square of the error of the quantised deltas; infinite where the step is too small to code.
  /// Cheap. VDE is proportional to it, whatever the step and the strength of diffusion.
  virtual double delta_error(const CoderSettings& settings) = 0;

  /// The result of the last run() is the one to write, unless a later one is kept instead.
  virtual void keep() = 0;
  /// At most `count` vertices of the last run() whose error is largest among the vertices around them and
  /// above `threshold`, largest first.
  virtual std::vector<std::uint32_t> worst_vertices(double threshold, std::size_t count) = 0;

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
