// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A quality request in model units.
#pragma once

#include <cstdint>
#include <optional>

#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"

namespace deltamesh {

/// Whether every figure is a finite float, as the header wants [HDR-9].
bool is_declarable(const Quality& quality) noexcept;

/// Upper bounds, model units.
struct Bounds {
  std::optional<double> vde = std::nullopt;
  std::optional<double> lfe = std::nullopt;
  std::optional<double> max_error = std::nullopt;

  bool positional() const noexcept { return lfe || max_error; }
  /// Achieved VDE over asked; 0 where none is asked. At most 1 where the bound is kept, also by the figure
  /// that the header declares, a float. So for the next two.
  double visual_load(const Quality& quality) const noexcept;
  double positional_load(const Quality& quality) const noexcept;  ///< the worse of LFE and max error
  double load(const Quality& quality) const noexcept;  ///< the worst of all; infinite if not declarable
};

/// `vertices`: position-welded vertices, what the paper's sums run over; `diagonal`: of the bounding box.
Bounds bounds_in_model_units(const QualityRequest& request, std::uint64_t vertices, double diagonal) noexcept;

/// Whether every number is finite and above 0. Errors: kInvalidArgument.
Result<void> validate(const QualityRequest& request) noexcept;

}  // namespace deltamesh
