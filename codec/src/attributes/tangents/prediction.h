// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Predictions of tangents: the rule's, and what it was off by at the vertices before, in the stereographic
// plane around it [ATTR-41]. The same bits on every machine; shared by writer and reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/normals/lattice.h"
#include "attributes/surface_order.h"
#include "attributes/tangents/rule.h"

namespace deltamesh {

/// The sources of a prediction; selects the blend and the context of a pair.
enum class TangentSource : std::uint8_t { kNothing = 0, kNeighbors, kRule, kRuleAndOne, kRuleAndMore };
inline constexpr std::size_t kTangentSources = 5;

struct TangentPrediction {
  NormalFrame frame{};  ///< the pole is the rule's tangent, the second axis near the normal
  PlanePoint center{};
  std::array<float, 2> spread{};  ///< how far apart the predictions are, in the plane
  TangentSource source = TangentSource::kNothing;
  bool is_mirrored = false;  ///< faces are so in the texture: the sign is likely 1
};

/// Predicts the vertices of a surface order, in order: prediction(i), settle(i, tangent), prediction(i + 1)
/// and so on.
class TangentPredictor {
 public:
  TangentPredictor(const AttributeSurface& surface, const SurfaceOrder& order, std::span<const float> normals,
                   std::span<const float> uvs);

  TangentPrediction prediction(std::size_t i);
  /// The decoded tangent of the vertex that was predicted last.
  void settle(std::size_t i, FourFloats tangent);

 private:
  struct Known {
    FourFloats tangent{};
    FourFloats off{};  ///< its place in the plane of its own prediction, then 1; 0 where that is no rule's
  };
  /// Learns the factor from the mean place of the neighbours to the place of a vertex.
  class Share {
   public:
    float value() const noexcept { return products_ / (squares_ + 0.02F); }
    void learn(PlanePoint mean, PlanePoint place, float weight) noexcept {
      squares_ = kMemory * squares_ + weight * (mean[0] * mean[0] + mean[1] * mean[1]);
      products_ = kMemory * products_ + weight * (mean[0] * place[0] + mean[1] * place[1]);
    }

   private:
    static constexpr float kMemory = 0.99F;
    float squares_ = 0;
    float products_ = 0;
  };

  const SurfaceOrder& order_;
  TangentRule rule_;
  std::vector<Known> known_;
  std::array<Share, kTangentSources> shares_;
  // From the last prediction:
  NormalFrame frame_{};
  PlanePoint mean_{};
  TangentSource source_ = TangentSource::kNothing;
};

}  // namespace deltamesh
