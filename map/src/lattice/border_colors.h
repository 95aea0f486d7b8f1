// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours of border vertices on levels that all parts have in common, so that copies of a vertex have one
// colour [MAP-24]. One template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

inline constexpr std::uint32_t kMostBorderStep = 255;

struct BorderColorModels {
  static constexpr std::size_t kContexts = 12;
  BorderColorModels() {
    moved.fill(BitModel(1U << 14));
    away.fill(BitModel(1U << 14));
  }

  void limit_counts(std::uint8_t most) noexcept {
    step.length.limit_count(most);
    more.length.limit_count(most);
  }

  NumberModel step;
  std::array<BitModel, kContexts> moved;
  std::array<BitModel, kContexts> away;
  NumberModel more;
};

/// The multiple of `step` that is nearest to `level`, in steps; ties upwards.
constexpr std::int32_t border_steps(std::int32_t level, std::int32_t step) noexcept {
  return (2 * level + step) / (2 * step);
}

/// What becomes of a level at a border.
constexpr std::uint8_t border_level(std::uint8_t level, std::uint32_t step) noexcept {
  const auto whole = static_cast<std::int32_t>(step);
  return static_cast<std::uint8_t>(std::min(border_steps(level, whole) * whole, 255));
}

/// The colour of one vertex after the other, component by component.
template <class Coder>
class BorderColorCoder {
 public:
  /// `step`: 1 to kMostBorderStep, levels of 8 bits. The others must outlive the coder.
  BorderColorCoder(Coder& coder, BorderColorModels& models, std::uint32_t step)
      : coder_(coder), models_(models), step_(static_cast<std::int32_t>(step)) {}

  void begin_vertex() noexcept {
    is_first_ = true;
    last_ = 0;
  }

  /// `level`: as the stream has it. Writers give `wanted`, the source's. Returns the border's level.
  std::uint8_t code(std::uint8_t level, std::uint8_t wanted) {
    const std::int32_t expected = border_steps(level, step_);
    const std::int32_t rest = 2 * (level - expected * step_);  // -step to step
    const std::int32_t side = rest < 0 ? -1 : 1;               // where the next multiple is nearest
    const std::size_t context = context_of(std::abs(rest), side);
    const std::int32_t way = Coder::kWrites ? border_steps(wanted, step_) - expected : 0;
    std::int32_t moved = 0;
    if (coder_.bit(way != 0, models_.moved[context])) {
      const bool away = coder_.bit(way * side < 0, models_.away[context]);
      const auto more = static_cast<std::int32_t>(std::min(
          coder_.number(Coder::kWrites ? static_cast<std::uint32_t>(std::abs(way)) - 1 : 0, models_.more),
          kMostBorderStep));
      moved = (away ? -side : side) * (more + 1);
    }
    is_first_ = false;
    last_ = moved;
    return static_cast<std::uint8_t>(std::clamp((expected + moved) * step_, 0, 255));
  }

 private:
  /// 0 to 2 of a vertex' first component, by how near the next multiple is; 3 more for each way that the
  /// component before moved: none, to this side, to the other.
  std::size_t context_of(std::int32_t rest, std::int32_t side) const noexcept {
    const auto near = static_cast<std::size_t>(std::min(3 * rest / (step_ + 1), 2));
    if (is_first_) return near;
    return near + (last_ == 0 ? 3 : last_ * side > 0 ? 6 : 9);
  }

  Coder& coder_;
  BorderColorModels& models_;
  std::int32_t step_;
  bool is_first_ = true;
  std::int32_t last_ = 0;  ///< how the component before moved, steps
};

}  // namespace deltamesh
