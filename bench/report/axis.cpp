// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/axis.h"

#include <algorithm>
#include <cmath>

#include "report/text.h"

namespace deltamesh::bench {
namespace {

/// `digit` x 10^`exponent`: a place where a tick may be.
struct Mark {
  int digit = 1;  ///< 1 to 9
  int exponent = 0;

  double value() const { return digit * std::pow(10.0, exponent); }
  Mark next() const { return digit == 9 ? Mark{1, exponent + 1} : Mark{digit + 1, exponent}; }
};

constexpr double kSlack = 1e-9;  // relative: rounding must not move a tick value to the next mark

/// The largest mark that is not above `value`.
Mark mark_below(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value) + kSlack));
  const double digit = std::floor(value / std::pow(10.0, exponent) + kSlack);
  return {std::clamp(static_cast<int>(digit), 1, 9), exponent};
}

bool has_label(int digit, double decades) {
  if (decades > 4) return digit == 1;
  if (decades > 1.2) return digit == 1 || digit == 2 || digit == 5;
  if (decades > 0.6) return digit == 1 || digit == 2 || digit == 3 || digit == 5 || digit == 7;
  return true;
}

/// The smallest of 1, 2, 5 times a power of ten that needs at most ten steps to `high`.
double linear_step(double high) {
  const double tenth = high / 10;
  const double power = std::pow(10.0, std::floor(std::log10(tenth) + kSlack));
  for (const double multiple : {1.0, 2.0, 5.0})
    if (tenth <= multiple * power * (1 + kSlack)) return multiple * power;
  return 10 * power;
}

}  // namespace

LinearAxis::LinearAxis(double high, double pixel_low, double pixel_high)
    : step_(linear_step(high)),
      steps_(static_cast<int>(std::ceil(high / step_ - kSlack))),
      pixel_low_(pixel_low),
      pixel_high_(pixel_high) {}

double LinearAxis::place(double value) const {
  return pixel_low_ + (pixel_high_ - pixel_low_) * value / (step_ * steps_);
}

std::vector<Tick> LinearAxis::ticks() const {
  std::vector<Tick> ticks;
  for (int i = 0; i <= steps_; ++i) ticks.push_back({i * step_, significant(i * step_, 6)});
  return ticks;
}

LogAxis::LogAxis(double low, double high, double pixel_low, double pixel_high)
    : low_(mark_below(low).value()), high_(high), pixel_low_(pixel_low), pixel_high_(pixel_high) {
  const Mark below = mark_below(high);
  high_ = below.value() * (1 + kSlack) >= high ? below.value() : below.next().value();
  if (high_ <= low_) high_ = below.next().value();
}

double LogAxis::place(double value) const {
  return pixel_low_ + (pixel_high_ - pixel_low_) * std::log(value / low_) / std::log(high_ / low_);
}

std::vector<Tick> LogAxis::ticks() const {
  const double decades = std::log10(high_ / low_);
  std::vector<Tick> ticks;
  for (Mark mark = mark_below(low_); mark.value() <= high_ * (1 + kSlack); mark = mark.next())
    ticks.push_back(
        {mark.value(), has_label(mark.digit, decades) ? significant(mark.value(), 6) : std::string()});
  return ticks;
}

}  // namespace deltamesh::bench
