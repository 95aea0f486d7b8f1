// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Sizes against errors: the curve that a peer's settings span, and where it meets a given error.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace deltamesh::bench {

struct CurvePoint {
  double error = 0;  ///< any unit, above 0
  double bytes = 0;  ///< or anything proportional, above 0
};

/// The lower convex hull of `points` over (log error, bytes), from the smallest error to the fewest bytes;
/// along it bytes fall strictly. Over these axes a quantiser's curve is straight at fine steps (a bit per
/// halving of the error and coefficient) and convex at coarse ones, so that the hull cuts no corners, as it
/// would over log bytes. Points that are not finite and above 0 are left out.
std::vector<CurvePoint> lower_hull(std::span<const CurvePoint> points);

/// Bytes needed for an error of at most `error`: interpolation along `hull` (from lower_hull()) over the same
/// axes; the fewest bytes where every point of the hull has a smaller error; nothing where none has.
std::optional<double> bytes_at(std::span<const CurvePoint> hull, double error);

}  // namespace deltamesh::bench
