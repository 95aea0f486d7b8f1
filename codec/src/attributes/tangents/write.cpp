// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <utility>

#include "attributes/error.h"
#include "attributes/prediction/pair_choice.h"
#include "attributes/tangents/coder.h"
#include "attributes/tangents/tangents.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

/// Of the bound: however an angle is computed, it is kept.
constexpr double kKeptAngle = 1 - 1e-6;
/// What arithmetic in f32 may add to a distance.
constexpr double kStepRounding = 1e-6;

bool are_tangents(std::span<const float> tangents) noexcept {
  for (std::size_t v = 0; 4 * v < tangents.size(); ++v) {
    if (!is_tangent(widen(tangents.subspan(4 * v)), tangents[4 * v + 3])) return false;
  }
  return true;
}

/// Chooses what to code so that no vector is farther from the source's than a chord of the unit sphere.
class TangentChoice {
 public:
  using Coder = TangentCoder<CompactWriter, TangentChoice>;

  TangentChoice(std::span<const float> tangents, double chord, float step)
      : tangents_(tangents), chord_(chord), step_(step) {}

  bool is_negative(std::uint32_t vertex) const noexcept { return tangents_[std::size_t{4} * vertex + 3] < 0; }

  bool will_do(std::uint32_t vertex, const Tangent& tangent) const noexcept {
    return (tangent[3] < 0) == is_negative(vertex) && is_near(vertex, tangent);
  }

  NumberPair nearest(std::uint32_t vertex, const NormalFrame& frame, PlanePoint center) const noexcept {
    const auto x = point_of(frame, source(vertex));
    const auto step = static_cast<double>(step_);
    const std::array<double, 2> steps = {(x[0] - static_cast<double>(center[0])) / step,
                                         (x[1] - static_cast<double>(center[1])) / step};
    return choose_pair(steps, [&](const NumberPair& pair) {
      Tangent tangent{};
      return Coder::tangent_at(frame, center, pair, step_, tangent) && is_near(vertex, tangent);
    });
  }

 private:
  Vec3 source(std::uint32_t vertex) const noexcept {
    Vec3 direction = widen(tangents_.subspan(std::size_t{4} * vertex));
    normalize(direction);
    return direction;
  }

  bool is_near(std::uint32_t vertex, const Tangent& tangent) const noexcept {
    Vec3 direction = widen(tangent);
    normalize(direction);
    const Vec3 off = direction - source(vertex);
    return dot(off, off) <= chord_ * chord_;
  }

  std::span<const float> tangents_;
  double chord_;
  float step_;
};

}  // namespace

std::optional<CodedValues<float>> write_surface_tangents(std::span<const float> tangents, double max_degrees,
                                                         const AttributeSurface& surface,
                                                         const TangentBasis& basis) {
  if (!(max_degrees >= kLeastAngle && max_degrees <= kMostAngle) || !are_tangents(tangents))
    return std::nullopt;
  const double chord = chord_of(max_degrees) * kKeptAngle;
  // In the plane distances are half of those on the sphere, or less. The cell's diagonal is below twice what
  // rounding leaves.
  const auto step = static_cast<float>(1.4142 * 0.5 * (chord - kStepRounding));
  CompactWriter writer;
  TangentCoder coder(writer, surface, basis.normals, basis.uvs, step, TangentChoice(tangents, chord, step));
  for (std::size_t i = 0; i < coder.count(); ++i)
    if (!coder.code(i)) return std::nullopt;
  return CodedValues<float>{.bytes = step_and_stream(step, writer.finish()),
                            .values = std::move(coder.values())};
}

}  // namespace deltamesh
