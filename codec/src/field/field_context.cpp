// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "field/field_context.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "base/quick_ratio.h"

namespace deltamesh {
namespace {

constexpr std::int32_t kUnit = 16;                 ///< fixed point: parts of a step
constexpr std::int32_t kLargestRemembered = 8191;  ///< squares times kUnit stay below 2^30
constexpr std::size_t kMostNeighbors = 16;

/// round(65536 / count)
constexpr std::array<std::int64_t, kMostNeighbors + 1> kOneOver = [] {
  std::array<std::int64_t, kMostNeighbors + 1> table{};
  for (std::int64_t n = 1; n <= static_cast<std::int64_t>(kMostNeighbors); ++n)
    table[static_cast<std::size_t>(n)] = (65536 + n / 2) / n;
  return table;
}();

constexpr std::array<std::array<std::size_t, 3>, 3> kMoment = {{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};

std::int32_t clamp_remembered(std::int32_t q) noexcept {
  return std::clamp(q, -kLargestRemembered, kLargestRemembered);
}

/// 0.6 new + 0.4 old, as 5/8 and 3/8.
std::int32_t smooth(std::int32_t now, std::int32_t before) noexcept {
  return static_cast<std::int32_t>((std::int64_t{5} * now + std::int64_t{3} * before) >> 3);
}

/// Four classes per octave from 4 on: 0, 1, 2, 3, 4 .. 7, 8 .. 11 for 8 .. 15, and so on.
std::uint32_t quarter_octave(std::int32_t value) noexcept {
  const auto v = static_cast<std::uint32_t>(value);
  if (v < 4) return v;
  const auto width = static_cast<std::uint32_t>(std::bit_width(v));
  return 4 * (width - 2) + ((v >> (width - 3)) & 3);
}

std::uint32_t quarter_octave(std::int32_t value, std::uint32_t largest) noexcept {
  return std::min(quarter_octave(value), largest);
}

/// How far the mean is from 0 in terms of the scale: 0 to 5.
std::uint32_t sureness(std::int32_t distance, std::int32_t scale) noexcept {
  const std::int64_t ten = std::int64_t{10} * distance;
  const std::int64_t s = std::int64_t{scale} + 2;
  return (ten >= s ? 1U : 0U) + (ten >= 3 * s ? 1U : 0U) + (ten >= 6 * s ? 1U : 0U) +
         (ten >= 10 * s ? 1U : 0U) + (ten >= 17 * s ? 1U : 0U);
}

}  // namespace

FieldNeighborhood FieldHistory::around(std::uint32_t vertex) const noexcept {
  FieldNeighborhood around;
  around.degree_class = std::clamp<std::uint32_t>(graph_.degree(vertex), 3, 10) - 3;
  std::array<std::int64_t, 12> sums{};
  std::size_t count = 0;
  for (const std::uint32_t neighbor : graph_.of(vertex)) {
    if (neighbor >= vertex || count == kMostNeighbors) break;
    ++count;
    const Record& r = records_[neighbor];
    for (std::size_t a = 0; a < 3; ++a) sums[a] += r.q[a] * kUnit;
    for (std::size_t a = 0; a < 3; ++a) sums[3 + a] += r.magnitude[a];
    for (std::size_t t = 0; t < 6; ++t) sums[6 + t] += r.moments[t];
  }
  if (count == 0) return around;
  around.empty = false;
  const auto mean = [&](std::size_t i) {
    return static_cast<std::int32_t>((sums[i] * kOneOver[count]) >> 16);
  };
  for (std::size_t a = 0; a < 3; ++a) around.mean[a] = mean(a);
  for (std::size_t a = 0; a < 3; ++a) around.magnitude[a] = mean(3 + a);
  for (std::size_t t = 0; t < 6; ++t) around.moments[t] = mean(6 + t);
  return around;
}

void FieldHistory::remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& q,
                            const FieldNeighborhood& before) noexcept {
  Record& r = records_[vertex];
  for (std::size_t a = 0; a < 3; ++a) r.q[a] = clamp_remembered(q[a]);
  const auto blend = [&](std::int32_t now, std::int32_t old) {
    return before.empty ? now : smooth(now, old);
  };
  for (std::size_t a = 0; a < 3; ++a) {
    r.magnitude[a] = blend(std::abs(r.q[a]) * kUnit, before.magnitude[a]);
    for (std::size_t b = a; b < 3; ++b) {
      const std::size_t t = kMoment[a][b];
      r.moments[t] = blend(r.q[a] * r.q[b] * kUnit, before.moments[t]);
    }
  }
}

std::int32_t FieldPredictor::regress(unsigned axis) noexcept {
  constexpr std::int64_t kRidge = 5;
  const auto& m = around_.moments;
  if (axis == 0) return 0;
  if (axis == 1) {
    y_on_x_ = quick_ratio(m[1], m[0] + kRidge);
    z_on_x_ = quick_ratio(m[2], m[0] + kRidge);
    return (y_on_x_ * q_[0]) >> 8;
  }
  // What x leaves unexplained of y, and of its product with z.
  const std::int64_t yy = std::max<std::int64_t>(m[3] - ((std::int64_t{y_on_x_} * m[1]) >> kRatioBits), 0);
  const std::int64_t yz = m[4] - ((std::int64_t{y_on_x_} * m[2]) >> kRatioBits);
  const std::int32_t z_on_y = quick_ratio(yz, yy + kRidge);
  y_residual_ = q_[1] * kUnit - ((y_on_x_ * q_[0]) >> 8);
  return ((z_on_x_ * q_[0]) >> 8) +
         static_cast<std::int32_t>((std::int64_t{z_on_y} * y_residual_) >> kRatioBits);
}

std::int32_t FieldPredictor::expected_scale(unsigned axis) const noexcept {
  const std::int64_t all =
      (std::int64_t{around_.magnitude[0]} + around_.magnitude[1] + around_.magnitude[2]) / 3;
  const std::int64_t own = around_.magnitude[axis];
  if (axis == 0) return static_cast<std::int32_t>((39 * own + 22 * all) >> 6) + 1;
  const std::int64_t coded = axis == 1 ? std::int64_t{std::abs(q_[0])} * kUnit
                                       : (std::int64_t{std::abs(q_[0])} + std::abs(q_[1])) * (kUnit / 2);
  return static_cast<std::int32_t>((32 * own + 20 * all + 6 * coded) >> 6) + 1;
}

FieldForecast FieldPredictor::forecast(unsigned axis) noexcept {
  features_ = {regress(axis), around_.mean[axis]};
  const auto& weights = weights_[axis];
  FieldForecast f;
  f.mean = static_cast<std::int32_t>(
      (std::int64_t{weights[0]} * features_[0] + std::int64_t{weights[1]} * features_[1]) >> 16);
  f.scale = expected_scale(axis);
  f.shift = static_cast<unsigned>(
      std::max(static_cast<int>(std::bit_width(static_cast<std::uint32_t>(f.scale))) - 6, 0));
  f.negative = f.mean < 0;
  const std::int32_t distance = std::abs(f.mean);
  const std::int32_t near = distance >> f.shift;  // symbol units, times kUnit
  f.center = near < 56 ? 0 : near / kUnit;

  const std::uint32_t sure = sureness(distance, f.scale);
  const std::uint32_t sure3 = sure == 0 ? 0 : sure < 3 ? 1 : 2;
  const std::uint32_t shifted = f.shift > 0 ? 1 : 0;
  const std::uint32_t scale_class = quarter_octave(f.scale >> f.shift, 19) + 4 * shifted;
  const std::uint32_t degree = around_.degree_class;
  const std::uint32_t degree5 = std::clamp<std::uint32_t>(degree, 1, 5) - 1;
  const std::int32_t coded = axis == 0   ? 0
                             : axis == 1 ? std::abs(q_[0]) * kUnit
                                         : (std::abs(q_[0]) + std::abs(q_[1])) * (kUnit / 2);
  const std::uint32_t coded_class = quarter_octave(coded >> f.shift, 23);
  const std::int32_t all = (around_.magnitude[0] + around_.magnitude[1] + around_.magnitude[2]) / 3;
  const std::uint32_t own_class = quarter_octave(around_.magnitude[axis] >> f.shift, 23);
  f.contexts = {(scale_class * 6 + sure) * 5 + degree5, ((coded_class * 8 + degree) * 3 + axis) * 3 + sure3,
                (own_class * 12 + quarter_octave(near, 23) / 2) * 2 + shifted,
                (quarter_octave(all >> f.shift, 23) / 2 * 8 + degree) * 3 + axis};
  f.weight_set = scale_class / 4 * 3 + axis;
  f.tail_context = std::min(f.shift, 3U) * 6 + sure;
  return f;
}

void FieldPredictor::learn(unsigned axis, std::int32_t q, const FieldForecast& forecast) noexcept {
  q_[axis] = clamp_remembered(q);
  // Sign-sign least mean squares, the step clipped at two scales [FLD-4].
  constexpr std::int32_t kClip = 2 << kRatioBits;
  constexpr std::int32_t kStep = 65;
  const std::int32_t error =
      std::clamp(quick_ratio(q_[axis] * kUnit - forecast.mean, forecast.scale), -kClip, kClip);
  const std::int32_t step = (error * kStep) >> kRatioBits;
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::abs(features_[i]) <= forecast.scale / 4) continue;
    std::int32_t& w = weights_[axis][i];
    w = std::clamp(w + (features_[i] > 0 ? step : -step), -4 * 65536, 4 * 65536);
  }
}

}  // namespace deltamesh
