// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Predictions of texture coordinates from the surface: faces keep their shapes in the texture, and the
// texture goes on as it did on the faces next to them [ATTR-32, ATTR-33]. The same bits on every machine:
// doubles, + - * / and square roots, in the order written; shared by writer and reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "attributes/prediction/blend.h"
#include "attributes/prediction/linear_fit.h"
#include "attributes/surface.h"
#include "attributes/surface_order.h"
#include "attributes/uvs/faces.h"
#include "base/numbers/vec3.h"

namespace deltamesh {

struct UvPrediction {
  TwoDoubles place{};
  double spread = 0;     ///< how far apart the predictions are, texture units
  unsigned sources = 0;  ///< faces, at most 3
  bool is_start = true;  ///< no face with two known corners
};

/// Predicts the vertices of a surface order, in order: prediction(i), settle(i, value), prediction(i + 1)
/// and so on.
class UvPredictor {
 public:
  UvPredictor(const AttributeSurface& surface, const SurfaceOrder& order);

  UvPrediction prediction(std::size_t i);
  /// The decoded value of the vertex that was predicted last.
  void settle(std::size_t i, TwoDoubles value);

  /// The decoded value of a vertex for which settle() was called.
  TwoDoubles value(std::uint32_t vertex) const noexcept { return values_[vertex]; }

 private:
  struct Sums;

  void add_face(const UvFace& face, Sums& sums) const noexcept;
  void add_flat_face(const UvFace& face, Sums& sums) const noexcept;
  TwoDoubles start(std::size_t i, bool& is_linked) const noexcept;
  Vec3 place_of(std::uint32_t vertex) const noexcept;

  const AttributeSurface& surface_;
  const SurfaceOrder& order_;
  UvFaces faces_;
  std::vector<TwoDoubles> values_;
  Vec3 center_{};
  double scale_ = 1;
  double side_ = 1;  ///< of the last face that has an area in the texture: 1 or -1
  LinearFit fit_;
  std::array<PredictionBlend, 3> blends_;
  // From the last prediction:
  TwoDoubles first_{};
  PredictionDifferences differences_{};
  double size_ = 0;
  unsigned sources_ = 0;
};

}  // namespace deltamesh
