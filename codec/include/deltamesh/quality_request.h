// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The quality that the decoded mesh must have. The encoder finds settings that reach it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

namespace deltamesh {

/// The unit of a bound on positions.
enum class QualityUnit : std::uint8_t {
  kModel,     ///< model units; of VDE and LFE the root mean square
  kDiagonal,  ///< the same in percent of the bounding-box diagonal
  kPaper,     ///< the paper's sum (eqs. 1, 2), mesh scaled to a diagonal of 1
};

/// An upper bound, above 0; finite but for kNoBound.
struct QualityBound {
  double value = 0;
  QualityUnit unit = QualityUnit::kModel;
};

/// Of QualityRequest::max_error alone: none, not even the one that a VDE implies.
inline constexpr QualityBound kNoBound{std::numeric_limits<double>::infinity()};

/// Every member that is set must be kept; the encoder looks for the smallest stream that keeps them all. A
/// figure may come out better than asked where nothing is left to be saved: all deltas are coded as zero, or
/// one anchor per component is there already.
struct QualityRequest {
  /// Visual distortion error, eq. 2. It bounds local shape only: a mesh of many vertices may bend by more
  /// than its own size. So without `lfe` and `max_error` it implies a largest error of 1 % of the
  /// bounding-box diagonal.
  std::optional<QualityBound> vde = std::nullopt;
  std::optional<QualityBound> lfe = std::nullopt;  ///< low-frequency error, eq. 1
  /// No vertex is farther off; not in the paper's unit. Or kNoBound, where something else is asked for.
  std::optional<QualityBound> max_error = std::nullopt;
  /// The whole stream has no more bytes. Alone: the finest that fits, by the coder that leaves the lower
  /// VDE; where there are attributes, all errors grow together (AttributeQuality::is_asked).
  std::optional<std::uint64_t> target_bytes = std::nullopt;

  bool empty() const noexcept { return !vde && !lfe && !max_error && !target_bytes; }
};

}  // namespace deltamesh
