// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The step by the mean error asked for.
#include <cmath>
#include <utility>

#include "attributes/error.h"
#include "attributes/haar/haar.h"
#include "attributes/haar/writer.h"
#include "base/numbers/portable_math.h"
#include "search/bracket.h"

namespace deltamesh {
namespace {

/// The step, 64ths of a level, that leaves an error of 1, and the slope of errors over steps, as logarithms.
struct StepForecast {
  double step_of_one;
  double slope;
};
constexpr StepForecast kOfPhotographs{137, 0.72};
constexpr StepForecast kOfOneAxis{211, 0.95};
constexpr double kTolerance = 0.01;

}  // namespace

std::optional<CodedValues<std::byte>> write_haar_values(ComponentType type, const AttributeRows& rows,
                                                        double rms, const AttributeSurface& surface,
                                                        const HaarModels* start, bool about) {
  auto picture = rows.components() == 1 ? picture_of_numbers(type, rows) : picture_of_colors(type, rows);
  if (!picture) return std::nullopt;
  const double unit = picture->fields.scale.unit;  // 1 of colours
  const StepForecast forecast = picture->fields.axes == 1 ? kOfOneAxis : kOfPhotographs;
  const auto levels = make_haar_levels(surface);
  const HaarWriter writer(*std::move(picture), levels);
  const double first = forecast.step_of_one * portable_exp2(portable_log2(rms / unit) / forecast.slope);
  Bracket bracket({.first = std::round(first),
                   .least = 1,
                   .most = kMostHaarStep,
                   .whole = true,
                   .slope = forecast.slope,
                   .aim = -kTolerance / 2,
                   .tolerance = portable_log2(1 - kTolerance),
                   .trials = 12});
  std::optional<CodedValues<std::byte>> best;
  while (!bracket.is_done()) {
    auto trial = writer.code(static_cast<std::uint32_t>(bracket.setting()), type, start);
    const double reached = bounded_rms(type, rows, trial.values);
    if (about && reached < kAbout * rms && rms < kAbout * reached) return trial;
    if (bracket.tell(excess_of_load(reached / rms))) best = std::move(trial);
  }
  return best;
}

}  // namespace deltamesh
