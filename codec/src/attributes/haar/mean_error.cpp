// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The step by the mean error asked for.
#include <algorithm>
#include <cmath>
#include <utility>

#include "attributes/colors/fields.h"
#include "attributes/error.h"
#include "attributes/haar/haar.h"
#include "attributes/haar/writer.h"
#include "base/numbers/portable_math.h"
#include "search/bracket.h"

namespace deltamesh {
namespace {

constexpr double kStepOfRms = 64 * 3.3;  ///< 64ths of a level; of photographs
constexpr double kTolerance = 0.01;
constexpr std::uint32_t kMoreSteps = 4;

std::optional<HaarPicture> picture_of(ComponentType type, const AttributeRows& rows) {
  HaarPicture picture{.levels = {}, .components = static_cast<unsigned>(rows.components())};
  picture.levels.reserve(rows.count() * rows.components());
  for (std::size_t i = 0; i < rows.count(); ++i) {
    for (std::size_t c = 0; c < rows.components(); ++c) {
      const auto level = nearest_color_level(type, 8, static_cast<std::uint32_t>(rows.bits(i, c)));
      if (!level) return std::nullopt;
      picture.levels.push_back(static_cast<std::uint8_t>(*level));
    }
  }
  return picture;
}

/// Of colours, or of alpha where that is more.
double rms_of(ComponentType type, const AttributeRows& rows, std::span<const std::byte> values) noexcept {
  return std::max(color_rms(type, rows, values), alpha_rms(type, rows, values));
}

}  // namespace

std::optional<CodedValues<std::byte>> write_haar_colors(ComponentType type, const AttributeRows& rows,
                                                        double rms, const AttributeSurface& surface) {
  if (!color_bits_fit(type, 8)) return std::nullopt;
  const auto picture = picture_of(type, rows);
  if (!picture) return std::nullopt;
  const auto levels = make_haar_levels(surface);
  const HaarWriter writer(*picture, levels);
  Bracket bracket({.first = std::round(kStepOfRms * rms),
                   .least = 1,
                   .most = kMostHaarStep,
                   .whole = true,
                   .aim = -kTolerance / 2,
                   .tolerance = portable_log2(1 - kTolerance),
                   .trials = 12});
  std::optional<CodedValues<std::byte>> best;
  double kept = 0;
  while (!bracket.is_done()) {
    auto trial = writer.code(static_cast<std::uint32_t>(bracket.setting()), type);
    const double reached = rms_of(type, rows, trial.values);
    if (!bracket.tell(excess_of_load(reached / rms))) continue;
    best = std::move(trial);
    kept = reached;
  }
  // Levels are rounded, so that small errors do not quite grow with the step.
  const auto step = static_cast<std::uint32_t>(bracket.best());
  for (std::uint32_t i = 1; best && i <= kMoreSteps && kept < (1 - kTolerance) * rms; ++i) {
    if (step + i > kMostHaarStep) break;
    auto trial = writer.code(step + i, type);
    const double reached = rms_of(type, rows, trial.values);
    if (reached > rms || reached <= kept) continue;
    best = std::move(trial);
    kept = reached;
  }
  return best;
}

}  // namespace deltamesh
