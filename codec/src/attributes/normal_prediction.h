// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From what is known around a vertex to the normal that is expected there [ATTR-23]. Doubles, + - * / sqrt
// only, in the order written.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "attributes/normal_lattice.h"
#include "attributes/normal_rule.h"
#include "base/rounded.h"
#include "base/vec3.h"

namespace deltamesh {

inline Vec3 widen(const std::array<float, 3>& v) noexcept { return {v[0], v[1], v[2]}; }
inline std::array<float, 3> narrow(const Vec3& v) noexcept {
  return {rounded(v[0]), rounded(v[1]), rounded(v[2])};
}

/// What is remembered of a coded vertex: the normal as decoded, unit length or 0; what the rule gave, unit
/// length or 0; the smoothed distance from the prediction, lattice radii; 1. All 0 where the normal is.
using CodedNormal = EightFloats;

/// What is known before a normal is coded.
struct NormalEvidence {
  RuleSum rule{};
  CodedNormal known{};  ///< sum over the coded vertices at the next corners of the faces

  Vec3 rule_normal() const noexcept { return {rule[0], rule[1], rule[2]}; }
  Vec3 normals() const noexcept { return {known[0], known[1], known[2]}; }
  Vec3 rules() const noexcept { return {known[3], known[4], known[5]}; }
  double sizes() const noexcept { return known[6]; }
  double count() const noexcept { return known[7]; }

  void add(const NormalEvidence& other) noexcept {
    rule += other.rule;
    known += other.known;
  }
};

/// What is kept of earlier vertices' part in a sum when one more adds to it.
inline constexpr double kKeep = 1 - 1.0 / 256;

/// Least squares for two factors: t = x f + y g, with a part of what was learnt forgotten each time.
class TwoFactors {
 public:
  /// x and y; 1 and 0 before anything was learnt.
  std::array<double, 2> solve() const noexcept {
    const double ff = ff_ + kRidge;
    const double gg = gg_ + kRidge;
    const double ft = ft_ + kRidge;
    const double det = ff * gg - fg_ * fg_;
    if (!(det > 1e-12 * ff * gg)) return {1, 0};
    return {(ft * gg - gt_ * fg_) / det, (gt_ * ff - ft * fg_) / det};
  }

  void learn(const Vec3& f, const Vec3& g, const Vec3& t, double weight) noexcept {
    ff_ = kKeep * ff_ + weight * dot(f, f);
    fg_ = kKeep * fg_ + weight * dot(f, g);
    gg_ = kKeep * gg_ + weight * dot(g, g);
    ft_ = kKeep * ft_ + weight * dot(f, t);
    gt_ = kKeep * gt_ + weight * dot(g, t);
  }

 private:
  static constexpr double kRidge = 0.5;  ///< towards x = 1 and y = 0
  double ff_ = 0, fg_ = 0, gg_ = 0, ft_ = 0, gt_ = 0;
};

/// A prediction and what it was made of.
struct NormalForecast {
  NormalFrame frame;
  bool learns = false;  ///< both the rule and neighbours gave a normal
  Vec3 mean{};          ///< of the coded neighbours
  Vec3 rule_off{};      ///< rule - mean
  Vec3 rules_off{};     ///< mean of the neighbours' rules - mean
  double near = 0;      ///< how far the neighbours were from their predictions, lattice radii
  // Squared lattice radii.
  double apart = 0;   ///< how far rule and neighbours' mean are apart
  double spread = 0;  ///< of the neighbours
  double bend = 0;    ///< of the faces around the vertex
  double expect = 0;  ///< distance by the noise
  double noise = 0;   ///< of the rule, squared radians for positions that are off by 1
  double count = 0;   ///< of coded vertices
  std::array<float, 3> rule{};
};

/// Two unit vectors orthogonal to the unit vector `pole` and to each other, the first as near to `way` as it
/// goes.
inline NormalFrame make_frame(const Vec3& pole, const Vec3& way) noexcept {
  NormalFrame frame{.pole = pole, .first = way - dot(way, pole) * pole, .second = {}};
  if (!(dot(frame.first, frame.first) > 1e-20) || !(normalize(frame.first) > 0)) {
    const double x = std::fabs(pole[0]);
    const double y = std::fabs(pole[1]);
    const double z = std::fabs(pole[2]);
    Vec3 axis{};
    axis[x <= y && x <= z ? 0 : (y <= z ? 1 : 2)] = 1;
    frame.first = axis - dot(axis, pole) * pole;
    normalize(frame.first);
  }
  frame.second = cross(pole, frame.first);
  return frame;
}

/// Blends rule and neighbours, with factors that it learns from how well they did [ATTR-23].
class NormalPredictor {
 public:
  /// `radius`: of the lattice. `blends`: false where the rule alone predicts.
  NormalPredictor(double radius, bool blends) noexcept : unit_(0.25 / (radius * radius)), blends_(blends) {}

  NormalForecast forecast(const NormalEvidence& e) const noexcept {
    NormalForecast f;
    Vec3 rule = e.rule_normal();
    const double inverse = normalize(rule);
    if (inverse > 0) describe_rule(e.rule, rule, inverse, f);
    f.count = e.count();
    if (!(f.count > 0)) {
      f.frame = make_frame(inverse > 0 ? rule : last_, {});
      return f;
    }
    const double part = 1 / f.count;
    f.mean = part * e.normals();
    f.near = part * e.sizes();
    f.spread = unit_ * (1 - dot(f.mean, f.mean));
    if (!(inverse > 0)) {
      Vec3 pole = f.mean;
      f.frame = make_frame(normalize(pole) > 0 ? pole : last_, {});
      return f;
    }
    f.rule_off = rule - f.mean;
    f.apart = unit_ * dot(f.rule_off, f.rule_off);
    f.learns = blends_;
    Vec3 pole = rule;
    if (blends_) {
      f.rules_off = part * e.rules() - f.mean;
      const auto [x, y] = factors_.solve();
      pole = f.mean + x * f.rule_off + y * f.rules_off;
      if (!(normalize(pole) > 0)) pole = rule;
    }
    f.frame = make_frame(pole, f.rule_off);
    return f;
  }

  /// `normal`: what was decoded, `size` radii from the prediction.
  void learn(const NormalForecast& f, const Vec3& normal, double size) noexcept {
    last_ = normal;
    if (f.noise > 0) {
      size_sum_ = kKeep * size_sum_ + size;
      noise_sum_ = kKeep * noise_sum_ + std::sqrt(f.noise);
    }
    if (!f.learns) return;
    const Vec3 target = normal - f.mean;
    const Vec3 error = normal - f.frame.pole;
    const double weight = unit_ / (1 + unit_ * dot(error, error));
    factors_.learn(f.rule_off, f.rules_off, target, weight);
  }

 private:
  /// `rule`: the unit vector of `sum`, `inverse`: one by the length of that.
  void describe_rule(const RuleSum& sum, const Vec3& rule, double inverse, NormalForecast& f) const noexcept {
    f.rule = narrow(rule);
    f.noise = static_cast<double>(sum[4]) * (inverse * inverse);
    if (!(f.noise < 1e60)) f.noise = 0;
    const double ratio = noise_sum_ > 0 ? size_sum_ / noise_sum_ : 0;
    f.expect = f.noise * (ratio * ratio);
    f.bend = unit_ * (2 - 2 / (inverse * static_cast<double>(sum[3])));
  }

  double unit_;  ///< squared lattice radii in a squared unit of the sphere
  bool blends_;
  double size_sum_ = 0;   ///< of sizes, and
  double noise_sum_ = 0;  ///< of the noise that was expected
  Vec3 last_{0, 0, 1};
  TwoFactors factors_;
};

}  // namespace deltamesh
