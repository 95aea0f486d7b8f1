// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which geometry coder is likely to make the smaller stream for a bound on VDE, from a sample of the
// vertices.
#pragma once

#include <span>

#include "base/numbers/vec3.h"
#include "positions/surroundings.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// Sizes of what each coder would have to code, at the step that `vde` suggests: mean over vertices of the
/// sum over axes of log2(1 + 2 size / step).
struct CoderForecast {
  double highpass = 0;    ///< of delta coordinates
  double predictive = 0;  ///< of distances from where parallelograms and neighbours point

  /// True if distances are hardly larger than deltas, as on flat and swept surfaces. The threshold was fitted
  /// to the sizes of both coders' streams at effort 0 on the corpus.
  bool predictive_wins() const noexcept;
};

/// `vde`: rms, model units, above 0. At most some 16000 vertices are looked at.
CoderForecast forecast_coders(const Adjacency& graph, const FaceList& list, std::span<const Vec3> positions,
                              double vde);

}  // namespace deltamesh
