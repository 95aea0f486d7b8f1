// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// DELT and ANCH: quantised delta coordinates and anchors, reconstructed by planned cycles (Yang, Li et al.,
// section 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/result.h"
#include "entropy/payload.h"
#include "format/highpass_parameters.h"
#include "highpass/cycles/compensation.h"
#include "highpass/cycles/plan.h"
#include "highpass/settings.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "laplacian/operator/solved_part.h"
#include "laplacian/solver.h"
#include "topology/adjacency.h"

namespace deltamesh {

class ThreadTeam;

struct HighpassSymbols;

struct CodedHighpass {
  HighpassParameters parameters;
  std::vector<std::byte> deltas;   ///< DELT payload
  std::vector<std::byte> anchors;  ///< ANCH payload
  LargeVector<Vec3> positions{};   ///< n: what read_highpass() will return
};

/// Codes one mesh under any settings, one after the other.
class HighpassCoder {
 public:
  /// `positions`: n, relative to the mesh's origin, in coding order; `graph`, `components`: of the decoded
  /// faces, same order; `anchors`: of `graph`; `box`: of `positions`; `is_plain`: the form of payloads. All
  /// but `components` must outlive the coder. O(n + edges).
  HighpassCoder(const Adjacency& graph, const Components& components, AnchorSequence& anchors,
                std::span<const Vec3> positions, const Box& box, bool is_plain = false);

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

  /// What so many cycles leave out of positions at most, before deltas and anchors make up for it;
  /// settings.more_anchors do not matter. Errors: as Compensation::improve(). Cost: a solve, where the last
  /// call was not for the same anchors and cycles.
  Result<double> left_out_by(const HighpassSettings& settings, int cycles);

  /// The fewest cycles that serve `settings`: left_out_by() is `most_left_out` at most, flat regions lose
  /// hardly any of it, compensation makes up for it at no cost in bytes and shape, and with more cycles
  /// errors of rounding would hardly be smaller. 16 where no fewer do. They serve larger steps and more
  /// anchors, too. Errors: as code(). Cost: some 20 cycles, each looked at, and a code().
  Result<int> fewest_cycles(const HighpassSettings& settings, double most_left_out);

  /// Deltas and anchors for so many planned cycles, 1 or more, make up for what these leave out
  /// (Compensation); with the positions that a decoder finds. settings.more_anchors change nothing but the
  /// anchors: errors stay where they are, so that anchors at the largest serve, if little is left out.
  /// Errors: kInvalidArgument where the step is too small for the symbols, kInvalidStream where the cycles
  /// diverge or numbers leave their range. Cost: a solve; for other anchors or cycles than before some solves
  /// besides.
  Result<CodedHighpass> code(const HighpassSettings& settings, int cycles);

  /// The same with the fewest cycles that serve, whatever they leave out.
  Result<CodedHighpass> code(const HighpassSettings& settings);

  /// Nearly the same without positions and without a solve.
  Result<CodedHighpass> code_only(const HighpassSettings& settings);

  HighpassCoder(const HighpassCoder&) = delete;
  HighpassCoder& operator=(const HighpassCoder&) = delete;

 private:
  /// Symbols of the deltas, and the shift that they are reconstructed with.
  struct Quantized {
    HighpassSettings settings{.step = 0};  ///< of which those of deltas count
    std::vector<std::int32_t> symbols{};
    ReconstructionShift shift{};
    std::optional<std::vector<std::byte>> payload{};  ///< of the symbols, once it has been asked for
  };
  /// Into `kept`, which may hold it already: symbols of `deltas`, always the same.
  Result<void> quantize(const HighpassSettings& settings, std::span<const Vec3> deltas,
                        Quantized& kept) const;
  /// Positions whose deltas and anchors are coded.
  struct Source {
    std::vector<std::uint32_t> rows{};  ///< of the sequence's anchors
    int cycles = 0;
    Compensation compensation;
    int rounds = 0;
    double left_out_at_first = 0;  ///< before the first round
    PlanErrors left_out{};         ///< before the last round
    Quantized quantized{};
  };
  /// One more round of source_.
  Result<void> compensate_once();
  /// Sets source_.
  Result<void> compensate(const HighpassSettings& settings, int cycles);
  /// `positions`: n, of which those of the anchors count.
  HighpassSymbols symbols_for(const Quantized& quantized, const Anchors& anchors, int anchor_bits,
                              std::span<const Vec3> positions) const;
  double invisible() const noexcept;
  Compensation uncompensated() const;
  /// The fewest cycles that leave out at most so much (LeftOut::largest), and of it lose at most so much
  /// where deltas are flat (LeftOut::lost). Precondition: quantized_ has the symbols of `settings`.
  Result<int> first_that_leave_little(const HighpassSettings& settings, double most_left_out,
                                      double most_lost);
  /// Whether a stream of so many cycles is good enough: compensation leaves little compared with `rounding`,
  /// the decoded mesh is hardly rougher than that makes it, and the deltas take at most `most_bytes`.
  bool serve(const HighpassSettings& settings, int cycles, const PlanErrors& rounding,
             std::size_t most_bytes);
  /// Rows of the sequence's anchors.
  std::vector<std::uint32_t> first_anchor_rows(const HighpassSettings& settings);
  /// The errors that rounding adds to positions with 1, 2, 3... cycles, up to 10, on which more hardly
  /// improve.
  Result<std::vector<PlanErrors>> rounding_errors(const HighpassSettings& settings);
  static HighpassParameters parameters_for(const HighpassSettings& settings, const Anchors& anchors,
                                           const ReconstructionShift& shift, int cycles);
  /// All but positions.
  CodedHighpass coded(const HighpassParameters& parameters, Quantized& quantized,
                      const HighpassSymbols& symbols) const;

  const Adjacency& graph_;
  AnchorSequence& anchors_;
  std::span<const Vec3> positions_;
  Box box_;
  bool is_plain_;
  SolvedPart part_;
  std::vector<Vec3> deltas_;  ///< over the rows of part_
  double range_ = 0;
  double largest_ = 0;
  PlannedSolver solver_;
  Quantized quantized_;  ///< of deltas_
  std::optional<Source> source_;
};

/// Returns n finite positions. `graph`, `components`: of the decoded faces; given away, they are freed when
/// they have served. Without a team of threads it takes the least memory. Errors: kTruncated, kInvalidStream
/// [DELT-*, ANCH-*, CMP-3, FLD-1].
Result<LargeVector<Vec3>> read_highpass(Payload deltas, Payload anchors, Adjacency graph,
                                        Components components, const Box& box,
                                        const HighpassParameters& parameters, ThreadTeam* team = nullptr);

}  // namespace deltamesh
