// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The predictive geometry coder: POSN, positions predicted in closed loop [POSN-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "entropy/coder/learning.h"
#include "format/predictive_parameters.h"
#include "positions/blend/blend.h"
#include "positions/blend/fit.h"
#include "positions/coding_order.h"
#include "positions/lattice/replacements.h"

namespace deltamesh {

struct LatticeModels;

enum class Guessing : std::uint8_t { kNever, kAlways, kPrediction };  ///< kPrediction: where a sample says so

/// The choices of a writer.
struct PositionForm {
  CodingOrder coding_order = CodingOrder::kAsDecoded;
  BlendFit fit = BlendFit::kSquares;
  Guessing guesses = Guessing::kNever;  ///< of kLattice: suits flat and swept surfaces [POSN-9]
};

/// The compact POSN payload of `cells`, one for every vertex of `faces`, within the lattice; empty for no
/// vertices. `faces`: as decoded, whatever the coding order. `replacements`: of kLattice, ascending. `start`:
/// null for fresh models. O(n + m).
std::vector<std::byte> write_positions(const FaceList& faces, std::span<const Cell> cells,
                                       const PredictiveParameters& parameters, const PositionForm& form = {},
                                       std::span<const Replacement> replacements = {},
                                       const LatticeModels* start = nullptr);

/// The same for positions to the last bit, PositionKind::kFloats. `box`: of `positions`, which are floats.
std::vector<std::byte> write_floats(const FaceList& faces, std::span<const Vec3> positions, const Box& box,
                                    const PositionForm& form = {});

/// n x 3, from a compact payload of PositionKind::kLattice or kFloats. `box`: the header's. `learning`: not
/// of floats. Errors: kTruncated, kInvalidStream [POSN-1, POSN-7, POSN-10, POSN-11, FLT-1, CMP-3, GEO-1].
Result<std::vector<float>> read_positions(std::span<const std::byte> payload, const FaceList& faces,
                                          const PredictiveParameters& parameters, const Box& box,
                                          const Learning<LatticeModels>& learning = {});

/// The same of kFloats, which few streams have: small decoders leave them to another module (web/wasm).
/// `bytes`: compact; `faces` has vertices. Errors: those of this kind.
Result<std::vector<float>> read_float_positions(std::span<const std::byte> bytes, const FaceList& faces,
                                                const Box& box);

}  // namespace deltamesh
