// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// DELT and ANCH: quantised delta coordinates and anchors, reconstructed by least squares (Yang, Li et al.,
// section 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "entropy/payload.h"
#include "format/highpass_parameters.h"
#include "highpass/settings.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "laplacian/operator/solved_part.h"
#include "laplacian/solver.h"
#include "topology/adjacency.h"

namespace deltamesh {

class ThreadTeam;

struct HighpassSymbols;
class PlanJudge;

struct CodedHighpass {
  HighpassParameters parameters;
  std::vector<std::byte> deltas;           ///< DELT payload, plain
  std::vector<std::byte> compact_deltas;   ///< the same in the compact form
  std::vector<std::byte> anchors;          ///< ANCH payload, plain
  std::vector<std::byte> compact_anchors;  ///< the same in the compact form
  /// n: what read_highpass will return, or nearly that.
  LargeVector<Vec3> positions{};
};

/// Codes one mesh under any settings, one after the other.
class HighpassCoder {
 public:
  /// `positions`: n, relative to the mesh's origin, in coding order; `graph`, `components`: of the decoded
  /// faces, same order; `anchors`: of `graph`; `box`: of `positions`. All but `components` must outlive the
  /// coder. O(n + edges).
  HighpassCoder(const Adjacency& graph, const Components& components, AnchorSequence& anchors,
                std::span<const Vec3> positions, const Box& box);

  /// Largest minus smallest delta over all axes.
  double range() const noexcept { return range_; }
  /// No delta exceeds this; a larger step than twice as much codes nothing but zeros.
  double largest_delta() const noexcept { return largest_; }

  /// Model units, above 0: range / 2^bits. A flat graph, all deltas equal, gets a step that rounds nothing
  /// but noise.
  double step_for_bits(int bits) const noexcept;

  /// As [ANCH-2] asks.
  Anchors anchors_for(const HighpassSettings& settings);

  /// Root mean square over the solved vertices of the distance between delta and its quantised form: what
  /// decides on VDE, without a solve. Infinite where the step is too small. O(n + edges).
  double delta_error(const HighpassSettings& settings);

  /// Exactly those that a decoder finds; or within a few percent of their errors, in half the time.
  enum class Positions { kDecoded, kApproximate };

  /// Without planned cycles: positions are the least-squares solution [DELT-4]. Errors: kInvalidArgument
  /// where the step is too small for 32-bit symbols. Cost: a solve, whose set-up is kept while the anchors
  /// stay.
  Result<CodedHighpass> code(const HighpassSettings& settings, Positions positions = Positions::kDecoded);

  /// The same without positions and without the solve.
  Result<CodedHighpass> code_only(const HighpassSettings& settings);

  /// The same mesh coded for the fewest planned cycles [DELT-7] whose positions are about as good as
  /// `settled`, those of code(settings), and that `accepts`; none where that takes too many. Deltas and
  /// anchors make up for what the cycles leave out (Compensation). Cost: at most five solves for each number
  /// of cycles.
  std::optional<CodedHighpass> plan(const HighpassSettings& settings, std::span<const Vec3> settled,
                                    const std::function<bool(const CodedHighpass&)>& accepts);

  /// The same mesh coded for so many planned cycles, 1 or more, with the deltas that code(settings) has:
  /// errors are where they are there, so that anchors at the largest serve here too. Anchors alone make up
  /// for what the cycles leave out, which takes more cycles than plan() does. Errors: kInvalidArgument,
  /// kInvalidStream where the mesh cannot be planned so. Cost: three solves.
  Result<CodedHighpass> code_planned(const HighpassSettings& settings, int cycles);

  HighpassCoder(const HighpassCoder&) = delete;
  HighpassCoder& operator=(const HighpassCoder&) = delete;

 private:
  /// Symbols of the deltas, and the shift that they are reconstructed with.
  struct Quantized {
    HighpassSettings settings{.step = 0};  ///< of which those of deltas count
    std::vector<std::int32_t> symbols{};
    ReconstructionShift shift{};
  };
  Result<Quantized> quantize(const HighpassSettings& settings, std::span<const Vec3> deltas) const;
  /// Sets quantized_.
  Result<void> quantize_own(const HighpassSettings& settings);
  /// `positions`: n, of which those of the anchors count.
  HighpassSymbols symbols_for(const Quantized& quantized, const Anchors& anchors, int anchor_bits,
                              std::span<const Vec3> positions) const;
  struct Attempt {
    std::optional<CodedHighpass> coded{};
    bool gains = false;  ///< whether compensation makes a difference
  };
  Attempt plan_for(int cycles, const HighpassSettings& settings, const Anchors& anchors,
                   const PlanJudge& judge, const std::function<bool(const CodedHighpass&)>& accepts);
  static HighpassParameters parameters_for(const HighpassSettings& settings, const Anchors& anchors,
                                           const ReconstructionShift& shift, int cycles);
  /// All but positions.
  CodedHighpass coded(const HighpassParameters& parameters, const Quantized& quantized,
                      const HighpassSymbols& symbols) const;

  const Adjacency& graph_;
  AnchorSequence& anchors_;
  std::span<const Vec3> positions_;
  Box box_;
  SolvedPart part_;
  std::vector<Vec3> deltas_;  ///< over the rows of part_
  double range_ = 0;
  double largest_ = 0;
  LeastSquaresSolver solver_;
  Quantized quantized_;  ///< of deltas_
};

/// Returns n finite positions. `graph`, `components`: of the decoded faces; given away, they are freed when
/// they have served. Without a team of threads it takes the least memory. Errors: kTruncated, kInvalidStream
/// [DELT-*, ANCH-*, CMP-3, FLD-1].
Result<LargeVector<Vec3>> read_highpass(Payload deltas, Payload anchors, Adjacency graph,
                                        Components components, const Box& box,
                                        const HighpassParameters& parameters, ThreadTeam* team = nullptr);

}  // namespace deltamesh
