// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From vertex to vertex: groups of copies, predictions, residuals. One template for both directions
// [ATTR-21 .. ATTR-25].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/attribute_surface.h"
#include "attributes/normal_corners.h"
#include "attributes/normal_groups.h"
#include "attributes/normal_lattice.h"
#include "attributes/normal_prediction.h"
#include "attributes/normal_residual.h"
#include "attributes/normal_rule.h"
#include "base/large_vector.h"
#include "entropy/compact_model.h"

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

/// `Source` tells a writer what to code: same(v, u), is_zero(v), choose(forecast, vertices).
template <class Coder, class Source>
class NormalWalk {
 public:
  NormalWalk(Coder& coder, Source& source, const AttributeSurface& surface, const CornersByVertex& corners,
             const NormalParameters& parameters)
      : coder_(coder),
        source_(source),
        surface_(surface),
        corners_(corners),
        parameters_(parameters),
        lattice_(static_cast<double>(parameters.radius)),
        predictor_(static_cast<double>(parameters.radius), parameters.blends),
        groups_(coder),
        residuals_(coder),
        sums_(parameters.rule == NormalRule::kNone
                  ? LargeVector<RuleSum>{}
                  : sum_by_rule(parameters.rule, surface.triangles(), surface.positions())),
        coded_(surface.vertex_count() + std::size_t{1}),
        leaders_(parameters.shares ? surface.vertex_count() : 0) {
    coded_.back() = CodedNormal{};
  }

  /// `failed()`: asked after every geometric vertex; true ends the walk. False where a lattice point is off
  /// the sphere [ATTR-24].
  template <class Failed>
  bool run(Failed failed) {
    for (std::uint32_t g = 0; g < corners_.geometric_count() && !failed(); ++g)
      if (!code_geometric(g)) return false;
    return true;
  }

  /// n x 3.
  std::vector<float> values() const {
    std::vector<float> result;
    result.resize(3 * std::size_t{surface_.vertex_count()});
    for (std::size_t v = 0; v < surface_.vertex_count(); ++v)
      for (std::size_t c = 0; c < 3; ++c) result[3 * v + c] = coded_[v][c];
    return result;
  }

 private:
  bool code_geometric(std::uint32_t g) {
    const std::uint32_t first = corners_.first_vertex(g);
    const std::uint32_t count = corners_.first_vertex(g + 1) - first;
    copies_.assign(count, NormalEvidence{});
    for (std::uint32_t i = 0; i < count && !sums_.empty(); ++i) copies_[i].rule = sums_[first + i];
    edges_.clear();
    for (const std::uint32_t corner : corners_.of(g)) add_corner(corner, first, count);
    if (count == 1 || !parameters_.shares) {
      for (std::uint32_t v = first; v < first + count; ++v)
        if (!code_group(copies_[v - first], {&v, 1})) return false;
      return true;
    }
    return code_copies(first, count);
  }

  /// Copies of a geometric vertex that may share normals.
  bool code_copies(std::uint32_t first, std::uint32_t count) {
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

  /// What the face at a corner says of its copy of the vertex.
  void add_corner(std::uint32_t corner, std::uint32_t first, std::uint32_t count) {
    const std::uint32_t place = corner % 3;
    const std::uint32_t* const face = surface_.triangles().data() + (corner - place);
    const std::uint32_t v = face[place];
    const std::uint32_t next = face[place == 2 ? 0 : place + 1];
    const std::uint32_t last = face[place == 0 ? 2 : place - 1];
    copies_[v - first].known += coded_[next < first ? next : surface_.vertex_count()];
    if (count > 1 && parameters_.shares) {
      for (const std::uint32_t other : {next, last})
        edges_.push_back({.copy = v - first,
                          .geometric = surface_.geometric_of(other),
                          .leader = other < first ? leaders_[other] : 0,
                          .is_coded = other < first});
    }
  }

  /// One normal for all `members`.
  bool code_group(const NormalEvidence& evidence, std::span<const std::uint32_t> members) {
    const NormalForecast forecast = predictor_.forecast(evidence);
    CodedNormal coded{};
    const bool is_zero =
        parameters_.has_zeros && coder_.bit(Coder::kWrites && source_.is_zero(members[0]), zero_);
    if (!is_zero) {
      LatticePoint point;
      if constexpr (Coder::kWrites) point = source_.choose(forecast, members);
      if (!residuals_.code(forecast, point)) return false;
      const auto plane = lattice_.at(point);
      Vec3 direction{};
      if (!direction_at(forecast.frame, plane, direction)) return false;
      const auto normal = narrow(direction);
      const double x = plane[0] / parameters_.radius;
      const double y = plane[1] / parameters_.radius;
      const double size = std::sqrt(x * x + y * y);
      const auto smooth = rounded(!(forecast.count > 0) ? size : (5 * size + 3 * forecast.near) / 8);
      const auto& rule = forecast.rule;
      coded = CodedNormal{normal[0], normal[1], normal[2], rule[0], rule[1], rule[2], smooth, 1};
      predictor_.learn(forecast, widen(normal), size);
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
  const CornersByVertex& corners_;
  NormalParameters parameters_;
  NormalLattice lattice_;
  NormalPredictor predictor_;
  NormalGroupCoder<Coder> groups_;
  NormalResidualCoder<Coder> residuals_;
  BitModel zero_;
  LargeVector<RuleSum> sums_;       ///< n, or empty
  LargeVector<CodedNormal> coded_;  ///< and one of 0
  LargeVector<std::uint32_t> leaders_;
  // Of the geometric vertex in work.
  std::vector<NormalEvidence> copies_;
  std::vector<NormalEdge> edges_;
  std::vector<std::uint32_t> group_;
  std::vector<NormalEvidence> evidence_;  ///< by group
  std::vector<std::uint32_t> ends_;       ///< of the groups among members_
  std::vector<std::uint32_t> members_;
};

}  // namespace deltamesh
