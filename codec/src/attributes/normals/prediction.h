// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From what is known around a vertex to the normal that is expected there [ATTR-23]. Floats, + - * / sqrt
// only, in the order written.
#pragma once

#include "attributes/normals/lattice.h"
#include "attributes/normals/rule.h"
#include "base/simd/four_floats.h"

namespace deltamesh {

/// The record kept of a coded vertex. All 0 if its normal is 0.
struct CodedNormal {
  FourFloats normal{};  ///< as decoded; then the smoothed distance from the prediction, lattice radii
  FourFloats rule{};    ///< what the rule gave, unit length or 0; then 1
};

/// The context of a normal before it is coded.
struct NormalEvidence {
  RuleSum rule{};
  CodedNormal known{};  ///< sum over the coded vertices at the next corners of the faces

  float count() const noexcept { return known.rule[3]; }

  void add(const CodedNormal& coded) noexcept {
    known.normal += coded.normal;
    known.rule += coded.rule;
  }
  void add(const NormalEvidence& other) noexcept {
    rule += other.rule;
    add(other.known);
  }
};

/// A prediction and what it was made of.
struct NormalPrediction {
  NormalFrame frame;
  FourFloats rule{};           ///< unit length, or 0
  FourFloats correction{};     ///< how far the neighbours are off their rule
  bool is_corrected = false;   ///< both the rule and neighbours gave a normal
  bool has_neighbors = false;  ///< near is of theirs
  float near = 0;              ///< how far they were from their predictions, lattice radii
  // Squared lattice radii.
  float scale = 0;   ///< what is to be expected
  float apart = 0;   ///< how far rule and neighbours' mean are apart
  float spread = 0;  ///< of the neighbours
  float bend = 0;    ///< of the faces around the vertex
};

inline constexpr float kLeastPole = 1e-12F;  ///< square of what has a direction

/// The rule's normal, and a part of what neighbours were off theirs by, which it learns [ATTR-23].
class NormalPredictor {
 public:
  /// `radius`: of the lattice. `blends`: false where the rule alone predicts.
  NormalPredictor(float radius, bool blends) noexcept : unit_(0.25F / (radius * radius)), blends_(blends) {}

  NormalPrediction prediction(const NormalEvidence& e) const noexcept {
    NormalPrediction f;
    const float square = dot3(e.rule, e.rule);
    const bool has_rule = square > 1e-36F && square < 1e36F;
    if (has_rule) {
      f.rule = e.rule * (1 / std::sqrt(square));
      f.bend = 2 * unit_ * (f.rule[3] - 1);
    }
    const float count = e.count();
    f.has_neighbors = count > 0;
    if (!f.has_neighbors) {
      f.scale = f.bend < 4 ? f.bend : 4;
      f.frame = make_frame(has_rule ? f.rule : last_, FourFloats{});
      return f;
    }
    const float part = 1 / count;
    const FourFloats mean = part * e.known.normal;
    f.near = mean[3];
    f.scale = f.near * f.near;
    f.spread = unit_ * (1 - dot3(mean, mean));
    if (!has_rule) {
      f.frame = make_frame(dot3(mean, mean) > kLeastPole ? mean : last_, FourFloats{});
      return f;
    }
    const FourFloats off = f.rule - mean;
    f.apart = unit_ * dot3(off, off);
    FourFloats pole = f.rule;
    if (blends_) {
      f.is_corrected = true;
      f.correction = mean - part * e.known.rule;
      pole += factor_ * f.correction;
      if (!(dot3(pole, pole) > kLeastPole)) pole = f.rule;
    }
    f.frame = make_frame(pole, off);
    return f;
  }

  /// `normal`: what was decoded, the root of `square` radii from the prediction.
  void learn(const NormalPrediction& f, FourFloats normal, float square) noexcept {
    last_ = normal;
    if (!f.is_corrected) return;
    const float weight = unit_ / (1 + square);
    squares_ = kKeep * squares_ + weight * dot3(f.correction, f.correction);
    products_ = kKeep * products_ + weight * dot3(f.correction, normal - f.rule);
    factor_ = products_ / (squares_ + 0.5F);
  }

 private:
  static constexpr float kKeep = 1 - 1.0F / 256;  ///< of sums when one more is added

  float unit_;  ///< squared lattice radii in a squared unit of the sphere
  bool blends_;
  FourFloats last_{0, 0, 1, 0};
  float squares_ = 0;
  float products_ = 0;
  float factor_ = 0;  ///< of the correction
};

}  // namespace deltamesh
