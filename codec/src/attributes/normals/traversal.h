// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From vertex to vertex: groups of copies, predictions, residuals. One template for both directions
// [ATTR-21 .. ATTR-25].
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/normals/groups.h"
#include "attributes/normals/lattice.h"
#include "attributes/normals/prediction.h"
#include "attributes/normals/residual.h"
#include "attributes/normals/rule.h"
#include "attributes/surface.h"
#include "base/memory/large_vector.h"
#include "entropy/coder/model.h"
#include "topology/vertex_corners.h"

namespace deltamesh {

/// The fields before the compact stream [ATTR-20].
struct NormalParameters {
  NormalRule rule = NormalRule::kNone;
  bool shares = false;     ///< copies of a geometric vertex may share a normal
  bool has_zeros = false;  ///< some normals are 0
  bool blends = false;     ///< coded neighbours help to predict; else they do so only where no rule does
  float radius = 0;        ///< of the lattice: kLeastRadius to 1
};
inline constexpr float kLeastRadius = 1e-6F;
// Their first byte.
inline constexpr int kRuleMask = 7;
inline constexpr int kSharesFlag = 8;
inline constexpr int kZerosFlag = 16;
inline constexpr int kBlendsFlag = 32;

/// `Source` tells a writer what to code: same(v, u), is_zero(v), choose(prediction, vertices).
template <class Coder, class Source>
class NormalTraversal {
 public:
  NormalTraversal(Coder& coder, Source& source, const AttributeSurface& surface,
                  const NormalParameters& parameters)
      : coder_(coder),
        source_(source),
        surface_(surface),
        corners_(surface.corners()),
        parameters_(parameters),
        lattice_(parameters.radius),
        predictor_(parameters.radius, parameters.blends),
        groups_(coder),
        residuals_(coder),
        sums_(parameters.rule == NormalRule::kNone
                  ? LargeVector<RuleSum>{}
                  : sum_by_rule(parameters.rule, surface.triangles(), surface.positions())),
        coded_(surface.vertex_count() + std::size_t{1}),
        leaders_(parameters.shares ? surface.vertex_count() : 0) {
    coded_.back() = CodedNormal{};
  }

  /// To the end, or until the coder has failed. False where a lattice point is off the sphere [ATTR-24].
  bool run() {
    for (std::uint32_t v = 0; v < surface_.vertex_count() && !coder_.failed();) {
      const std::uint32_t end = surface_.copies_end(v);
      if (!code_geometric(v, end - v)) return false;
      v = end;
    }
    return true;
  }

  /// n x 3.
  std::vector<float> values() const {
    std::vector<float> result;
    result.resize(3 * std::size_t{surface_.vertex_count()});
    for (std::size_t v = 0; v < surface_.vertex_count(); ++v)
      for (std::size_t c = 0; c < 3; ++c) result[3 * v + c] = coded_[v].normal[c];
    return result;
  }

 private:
  /// `first` and its copies, `count` in all.
  bool code_geometric(std::uint32_t first, std::uint32_t count) {
    if (count > 1 && parameters_.shares) return code_copies(first, count);
    for (std::uint32_t v = first; v < first + count; ++v)
      if (!code_group(evidence_at(v, first), {&v, 1})) return false;
    return true;
  }

  /// Copies of a geometric vertex that may share normals.
  bool code_copies(std::uint32_t first, std::uint32_t count) {
    copies_.clear();
    edges_.clear();
    for (std::uint32_t v = first; v < first + count; ++v) {
      copies_.push_back(evidence_at(v, first));
      for (const Corner& corner : corners_.of(v)) add_edges(corner, v - first, first);
    }
    const std::uint32_t groups = groups_.code(copies_, edges_, group_, [&](std::uint32_t i, std::uint32_t j) {
      return source_.same(first + i, first + j);
    });
    evidence_.assign(groups, NormalEvidence{});
    ends_.assign(groups + std::size_t{1}, 0);
    for (const std::uint32_t k : group_) ++ends_[k + std::size_t{1}];
    for (std::size_t k = 1; k <= groups; ++k) ends_[k] += ends_[k - 1];
    members_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      evidence_[group_[i]].add(copies_[i]);
      members_[ends_[group_[i]]++] = first + i;
    }
    std::uint32_t begin = 0;
    for (std::uint32_t k = 0; k < groups; ++k) {
      if (!code_group(evidence_[k], std::span(members_).subspan(begin, ends_[k] - begin))) return false;
      begin = ends_[k];
    }
    return true;
  }

  /// The evidence of the faces at a vertex; vertices below `first` are coded.
  NormalEvidence evidence_at(std::uint32_t v, std::uint32_t first) const {
    NormalEvidence evidence;
    if (!sums_.empty()) evidence.rule = sums_[v];
    for (const Corner& corner : corners_.of(v))
      evidence.add(coded_[corner.next < first ? corner.next : surface_.vertex_count()]);
    return evidence;
  }

  void add_edges(const Corner& corner, std::uint32_t copy, std::uint32_t first) {
    for (const std::uint32_t other : {corner.next, corner.before}) {
      edges_.push_back({.copy = copy,
                        .geometric = surface_.geometric_of(other),
                        .leader = other < first ? leaders_[other] : 0,
                        .is_coded = other < first});
    }
  }

  /// One normal for all `members`.
  bool code_group(const NormalEvidence& evidence, std::span<const std::uint32_t> members) {
    const NormalPrediction prediction = predictor_.prediction(evidence);
    CodedNormal coded{};
    const bool is_zero =
        parameters_.has_zeros && coder_.bit(Coder::kWrites && source_.is_zero(members[0]), zero_);
    if (!is_zero) {
      LatticePoint point;
      if constexpr (Coder::kWrites) point = source_.choose(prediction, members);
      if (!residuals_.code(prediction, point)) return false;
      FourFloats direction{};
      if (!direction_at(prediction.frame, lattice_.at(point), direction)) return false;
      const PlanePoint place = NormalLattice::in_radii(point);
      const float square = place[0] * place[0] + place[1] * place[1];
      predictor_.learn(prediction, direction, square);
      const float size = std::sqrt(square);
      coded.normal = direction;
      coded.normal[3] = prediction.has_neighbors ? (5 * size + 3 * prediction.near) * 0.125F : size;
      coded.rule = prediction.rule;
      coded.rule[3] = 1;
    }
    for (const std::uint32_t v : members) {
      coded_[v] = coded;
      if (parameters_.shares) leaders_[v] = members[0];
    }
    return true;
  }

  Coder& coder_;
  Source& source_;
  const AttributeSurface& surface_;
  const VertexCorners& corners_;
  NormalParameters parameters_;
  NormalLattice lattice_;
  NormalPredictor predictor_;
  NormalGroupCoder<Coder> groups_;
  NormalResidualCoder<Coder> residuals_;
  BitModel zero_;
  LargeVector<RuleSum> sums_;       ///< n, or empty
  LargeVector<CodedNormal> coded_;  ///< and one of 0
  LargeVector<std::uint32_t> leaders_;
  // For the current geometric vertex:
  std::vector<NormalEvidence> copies_;
  std::vector<NormalEdge> edges_;
  std::vector<std::uint32_t> group_;
  std::vector<NormalEvidence> evidence_;  ///< by group
  std::vector<std::uint32_t> ends_;       ///< of the groups among members_
  std::vector<std::uint32_t> members_;
};

}  // namespace deltamesh
