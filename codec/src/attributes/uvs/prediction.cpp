// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/uvs/prediction.h"

#include <algorithm>
#include <cmath>

namespace deltamesh {
namespace {

constexpr std::size_t kMostKept = 8;       ///< predictions that the spread is taken of
constexpr double kSmallestTexel = 1e-150;  ///< so that no weight is infinite

double cross(TwoDoubles a, TwoDoubles b) noexcept { return a[0] * b[1] - a[1] * b[0]; }
TwoDoubles turned(TwoDoubles a) noexcept { return TwoDoubles{-a[1], a[0]}; }
double size_of(TwoDoubles a) noexcept { return std::sqrt(dot(a, a)); }

}  // namespace

struct UvPredictor::Sums {
  TwoDoubles first{};
  double first_weight = 0;
  TwoDoubles other{};
  double other_weight = 0;
  double size = 0;  ///< squared lengths of the edges to the first predictions
  unsigned count = 0;
  std::array<TwoDoubles, kMostKept> kept;

  void add(TwoDoubles prediction, double weight, TwoDoubles a, TwoDoubles b) noexcept {
    first += weight * prediction;
    first_weight += weight;
    size += dot(prediction - a, prediction - a) + dot(prediction - b, prediction - b);
    if (count < kMostKept) kept[count] = prediction;
    ++count;
  }
  void add_other(TwoDoubles prediction, double weight) noexcept {
    other += weight * prediction;
    other_weight += weight;
  }
};

UvPredictor::UvPredictor(const AttributeSurface& surface, const SurfaceOrder& order)
    : surface_(surface), order_(order), faces_(surface, order), values_(surface.vertex_count()) {
  if (!surface.has_positions()) return;
  Box box = Box::empty();
  for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) box.add(surface.position(v));
  center_ = 0.5 * (box.min + box.max);
  const double side = box.longest_side();
  scale_ = side > 0 ? 1 / side : 1;
}

Vec3 UvPredictor::place_of(std::uint32_t vertex) const noexcept {
  return scale_ * (surface_.position(vertex) - center_);
}

void UvPredictor::add_face(const UvFace& face, Sums& sums) const noexcept {
  if (!face.counts) return;
  const TwoDoubles origin = values_[face.a];
  const TwoDoubles edge = values_[face.b] - origin;
  double side = side_;
  if (face.goes_on) {
    const double area = cross(edge, values_[face.across] - origin);
    if (area != 0) side = area < 0 ? 1 : -1;
  }
  const TwoDoubles foot = origin + face.x * edge;
  sums.add(foot + (side * face.y) * turned(edge), face.weight, origin, values_[face.b]);
  if (!(face.across_weight > 0)) return;
  sums.add_other(foot + face.ratio * ((origin + face.across_x * edge) - values_[face.across]),
                 face.across_weight);
}

/// Without positions: parallelograms, and the middle of the edge.
void UvPredictor::add_flat_face(const UvFace& face, Sums& sums) const noexcept {
  const TwoDoubles a = values_[face.a];
  const TwoDoubles b = values_[face.b];
  const TwoDoubles sum = a + b;
  const bool is_open = face.across == kNoUvVertex;
  sums.add(is_open ? 0.5 * sum : sum - values_[face.across], is_open ? 0.25 : 1, a, b);
  sums.add_other(0.5 * sum, 1);
}

/// Without faces: a known neighbour, else the vertex before.
TwoDoubles UvPredictor::start(std::size_t i, bool& is_linked) const noexcept {
  for (const Corner& corner : surface_.corners().of(order_.vertices[i])) {
    for (const std::uint32_t other : {corner.next, corner.before}) {
      if (!faces_.is_before(other, i)) continue;
      is_linked = true;
      return values_[other];
    }
  }
  is_linked = false;
  return i == 0 ? TwoDoubles{} : values_[order_.vertices[i - 1]];
}

UvPrediction UvPredictor::prediction(std::size_t i) {
  Sums sums;
  for (const UvFace& face : faces_.completed_by(i)) {
    if (surface_.has_positions()) {
      add_face(face, sums);
    } else {
      add_flat_face(face, sums);
    }
  }
  UvPrediction result;
  sources_ = std::min(sums.count, 3U);
  if (sums.count == 0) {
    bool is_linked = false;
    result.place = start(i, is_linked);
    result.sources = is_linked ? 1 : 0;
    if (!is_linked) fit_.fade();
    return result;
  }
  first_ = sums.first / sums.first_weight;
  size_ = 0.5 * sums.size / sums.count + kSmallestTexel;
  differences_ = {};
  if (sums.other_weight > 0) differences_[0] = sums.other / sums.other_weight - first_;
  if (surface_.has_positions()) {
    const TwoDoubles off = fit_.at(place_of(order_.vertices[i])) - first_;
    if (dot(off, off) <= 64 * size_) differences_[1] = off;
  }
  result.place = first_ + blends_[sources_ - 1].correction(differences_);
  const unsigned kept = std::min<unsigned>(sums.count, kMostKept);
  for (unsigned k = 0; k < kept; ++k) result.spread += size_of(sums.kept[k] - first_);
  result.spread = std::max(result.spread / kept, 0.3 * size_of(differences_[0]));
  result.sources = sources_;
  result.is_start = false;
  return result;
}

void UvPredictor::settle(std::size_t i, TwoDoubles value) {
  const std::uint32_t vertex = order_.vertices[i];
  values_[vertex] = value;
  if (sources_ > 0) {
    const TwoDoubles error = value - first_;
    const double weight = 1 / ((0.02 * size_ + dot(error, error)) + dot(differences_[0], differences_[0]));
    blends_[sources_ - 1].learn(differences_, error, weight);
  }
  if (!surface_.has_positions()) return;
  fit_.learn(place_of(vertex), value);
  const auto faces = order_.completed_by(i);
  for (std::size_t k = faces.size(); k-- > 0;) {
    const TwoDoubles a = values_[faces[k].next];
    const double area = cross(values_[faces[k].before] - a, value - a);
    if (area == 0) continue;
    side_ = area > 0 ? 1 : -1;
    return;
  }
}

}  // namespace deltamesh
