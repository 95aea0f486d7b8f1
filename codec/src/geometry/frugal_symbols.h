// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Symbols chosen by what they cost as well as by their error.
#pragma once

#include <array>
#include <cstdint>

#include "base/vec3.h"
#include "entropy/compact_pricer.h"
#include "field/field_coder.h"
#include "geometry/delta_quantizer.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// For every number the better of the nearest symbol and the next one towards zero: the smaller (error /
/// step)^2 + weight * bits, where bits is what the compact coder would spend, adapted to the symbols chosen
/// so far, in their contexts. A weight of 0.12 is near the best at all rates.
class FrugalSymbols {
 public:
  /// `graph` must outlive this; `weight` above 0.
  FrugalSymbols(const Adjacency& graph, const DeltaQuantizer& quantizer, double weight)
      : quantizer_(quantizer), weight_(weight), field_(pricer_, graph) {}

  /// Vertices come in order, each once. `nearest`: of `target`, model units.
  std::array<std::int32_t, 3> choose(std::uint32_t vertex, const std::array<std::int32_t, 3>& nearest,
                                     const Vec3& target);

  FrugalSymbols(const FrugalSymbols&) = delete;
  FrugalSymbols& operator=(const FrugalSymbols&) = delete;

 private:
  DeltaQuantizer quantizer_;
  double weight_;
  CompactPricer pricer_;
  FieldCoder<CompactPricer> field_;
};

}  // namespace deltamesh
