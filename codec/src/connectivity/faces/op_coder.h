// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Border ops by the compact coder, in the context of what both sides know at the gate [CONN-12].
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "connectivity/faces/border.h"
#include "connectivity/faces/border_item.h"
#include "connectivity/faces/cut.h"
#include "connectivity/faces/op_models.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// No stream has more: a symbol's probability is at most 1 - 30 / 2^15 and it stands for at most 7 faces, so
/// that a byte holds at most 42380 [CONN-2].
inline constexpr std::uint64_t kFacesPerCompactByte = 42400;

/// An S op names its target by a few steps along the loop where that reaches, else by the item's number. The
/// bound on these keeps hostile streams linear. References 1, 3, 5 ... go 2, 3, 4 ... items forward from the
/// gate, 2, 4, 6 ... go 1, 2, 3 ... items back [CONN-10].
inline constexpr std::uint32_t kFarReference = 0;
inline constexpr std::uint32_t kLargestReference = 255;

/// The item that a reference from 1 to kLargestReference names. At most 129 steps.
inline std::uint32_t follow_reference(const Border& border, std::uint32_t gate, std::uint32_t reference) {
  std::uint32_t i = gate;
  if (reference % 2 == 0) {
    for (std::uint32_t steps = reference / 2; steps > 0; --steps) i = border.item(i).previous;
  } else {
    for (std::uint32_t steps = (reference + 3) / 2; steps > 0; --steps) i = border.item(i).next;
  }
  return i;
}

/// The smallest reference to `target`, or kFarReference. At most 258 steps.
inline std::uint32_t find_reference(const Border& border, std::uint32_t gate, std::uint32_t target) {
  std::uint32_t forward = border.item(gate).next;
  std::uint32_t backward = gate;
  for (std::uint32_t reference = 1; reference <= kLargestReference; ++reference) {
    std::uint32_t& i = reference % 2 == 0 ? backward : forward;
    i = reference % 2 == 0 ? border.item(i).previous : border.item(i).next;
    if (i == target) return reference;
  }
  return kFarReference;
}

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class OpCoder {
 public:
  explicit OpCoder(Coder& coder, OpModels start = {}) : coder_(coder), models_(std::move(start)) {}

  const OpModels& models() const noexcept { return models_; }

  /// Writes `step`, or reads one; a reader's may not fit the border.
  [[gnu::always_inline]] BorderStep code(const BorderStep& step, const Border& border, const Gate& gate) {
    if (gate.at_origin) return code_rare<true>(step, border, gate.item);
    if constexpr (Coder::kWrites) {
      write(step, border, gate);
      return step;
    } else {
      return read(border, gate);
    }
  }

  /// Ops that a reader knows of: so many C and the one that closes them.
  struct Run {
    std::uint32_t new_vertices = 0;
    BorderOp closing = BorderOp::kNewVertex;  ///< R, kNone for a rare op, or C for none

    bool is_empty() const noexcept { return new_vertices == 0 && closing == BorderOp::kNewVertex; }
    bool is_fan() const noexcept { return closing == BorderOp::kRight; }
  };

  /// Reads the run that begins at a gate in step 1 [CONN-6], or what is left of one.
  [[gnu::always_inline]] Run run(const Gate& gate) {
    if (!to_come_.is_empty()) return std::exchange(to_come_, Run{});
    const unsigned symbol = code_run(0, context_of(gate));
    if (symbol < kClosedByRare) return {symbol, BorderOp::kRight};
    if (symbol < kGoesOn) return {symbol - kClosedByRare, BorderOp::kNone};
    return {kLongestRun, BorderOp::kNewVertex};
  }
  /// The next ops to read are those of `run`.
  void begin(const Run& run) { to_come_ = run; }

 private:
  static constexpr unsigned kLongestRun = OpModels::kLongestRun;
  static constexpr unsigned kClosedByRare = OpModels::kClosedByRare;
  static constexpr unsigned kGoesOn = OpModels::kGoesOn;

  struct RunContext {
    std::size_t first;
    std::size_t second;
    std::size_t weights;
  };

  static std::uint32_t few(std::uint32_t faces, std::uint32_t most) noexcept {
    return std::min(faces, most) - 1;
  }

  [[gnu::always_inline]] static RunContext context_of(const Gate& gate) noexcept {
    const std::uint32_t focus = gate.focus_faces - 1;
    const std::uint32_t last = std::max<std::uint32_t>(gate.last_focus_faces, 5) - 5;
    const std::uint32_t closed = gate.after_closed ? 1 : 0;
    const std::uint32_t behind = (focus * 4 + last) * 4 + few(gate.left_faces, 3);
    const std::uint32_t ahead = (focus * 4 + few(gate.past_faces, 4)) * 4 + few(gate.right_faces, 4);
    return {.first = (behind * 2 + closed) * 4 + gate.loop,
            .second = (ahead * 2 + closed) * 4 + few(gate.other_faces, 4),
            .weights = focus * 4 + gate.loop};
  }

  unsigned code_run(unsigned symbol, const RunContext& context) {
    last_ = 0;
    return coder_.symbol(
        symbol, Mixture<2>{{&models_.first_runs[context.first], &models_.second_runs[context.second]},
                           &models_.run_weights[context.weights]});
  }

  /// A writer knows a run when it closes.
  void write(const BorderStep& step, const Border& border, const Gate& gate) {
    if (new_vertices_ == 0) run_context_ = context_of(gate);
    if (step.op == BorderOp::kNewVertex) {
      if (++new_vertices_ < kLongestRun) return;
      code_run(kGoesOn, run_context_);
      new_vertices_ = 0;
      return;
    }
    const bool is_rare = step.op != BorderOp::kRight;
    code_run(std::exchange(new_vertices_, 0) + (is_rare ? kClosedByRare : 0), run_context_);
    if (is_rare) code_rare<false>(step, border, gate.item);
  }

  [[gnu::always_inline]] BorderStep read(const Border& border, const Gate& gate) {
    if (to_come_.is_empty()) to_come_ = run(gate);
    if (to_come_.new_vertices > 0) {
      --to_come_.new_vertices;
      return {BorderOp::kNewVertex};
    }
    if (std::exchange(to_come_.closing, BorderOp::kNewVertex) == BorderOp::kRight) return {BorderOp::kRight};
    return code_rare<false>({}, border, gate.item);
  }

  template <bool AtOrigin>
  [[gnu::noinline]] BorderStep code_rare(const BorderStep& step, const Border& border, std::uint32_t item) {
    const Gate gate = border.gate_at<AtOrigin>(item);
    const std::uint32_t closed = (gate.after_closed ? 2 : 0) + (gate.before_closed ? 1 : 0);
    const std::uint32_t near = ((AtOrigin ? 1 + last_ : 0) * 4 + closed) * 4 + gate.loop;
    const std::uint32_t focus = std::clamp<std::uint32_t>(gate.focus_faces, 2, 5) - 2;
    const std::size_t first = (near * 4 + focus) * 4 + few(gate.other_faces, 4);
    const std::size_t second = (near * 2 + few(gate.left_faces, 2)) * 4 + few(gate.right_faces, 4);
    const auto symbol = coder_.symbol(static_cast<unsigned>(step.op),
                                      Mixture<2>{{&models_.first_rares[first], &models_.second_rares[second]},
                                                 &models_.rare_weights[near]});
    BorderStep coded{static_cast<BorderOp>(symbol)};
    if (AtOrigin) last_ = coded.op == BorderOp::kNewVertex ? 1 : 2;
    if (coded.op == BorderOp::kSplit) coded.target = code_target(step.target, border, item);
    return coded;
  }

  std::uint32_t code_target(std::uint32_t target, const Border& border, std::uint32_t gate) {
    const std::uint32_t reference =
        coder_.number(Coder::kWrites ? find_reference(border, gate, target) : 0, models_.references);
    if (reference > kLargestReference) return kNoIndex;
    if (reference != kFarReference) return follow_reference(border, gate, reference);
    return coder_.bits(target, static_cast<unsigned>(std::bit_width(border.item_count())));
  }

  Coder& coder_;
  Run to_come_;                     ///< a reader's
  std::uint32_t new_vertices_ = 0;  ///< of a writer's run so far
  RunContext run_context_{};        ///< where that began
  std::uint32_t last_ = 0;          ///< the last op: 0 in step 1 [CONN-6], else 1 C, 2 another
  OpModels models_;
};

}  // namespace deltamesh
