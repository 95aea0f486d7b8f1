// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "measure/colors/color_difference.h"

#include <cmath>

#include "base/numbers/portable_math.h"
#include "base/numbers/srgb.h"

namespace deltamesh {
namespace {

struct Lab {
  double l;
  double a;
  double b;
};

double lab_curve(double t) noexcept {
  constexpr double kBend = 6.0 / 29;
  return t > kBend * kBend * kBend ? std::cbrt(t) : t / (3 * kBend * kBend) + 4.0 / 29;
}

Lab lab_of(const std::array<double, 3>& shown) noexcept {
  const double red = linear_of_shown(shown[0]);
  const double green = linear_of_shown(shown[1]);
  const double blue = linear_of_shown(shown[2]);
  const double x = lab_curve((0.4124564 * red + 0.3575761 * green + 0.1804375 * blue) / 0.95047);
  const double y = lab_curve(0.2126729 * red + 0.7151522 * green + 0.0721750 * blue);
  const double z = lab_curve((0.0193339 * red + 0.1191920 * green + 0.9503041 * blue) / 1.08883);
  return {.l = 116 * y - 16, .a = 500 * (x - y), .b = 200 * (y - z)};
}

/// Degrees, 0 to 360.
double hue(double a, double b) noexcept {
  if (a == 0 && b == 0) return 0;
  const double degrees = std::atan2(b, a) * (180 / kPi);
  return degrees < 0 ? degrees + 360 : degrees;
}

double cosine(double degrees) noexcept { return std::cos(degrees * (kPi / 180)); }
double square(double x) noexcept { return x * x; }

/// sqrt(c^7 / (c^7 + 25^7)).
double chroma_share(double chroma) noexcept {
  const double power = std::pow(chroma, 7);
  return std::sqrt(power / (power + 6103515625.0));
}

}  // namespace

double color_difference(const std::array<double, 3>& a, const std::array<double, 3>& b) noexcept {
  const Lab first = lab_of(a);
  const Lab second = lab_of(b);
  const double stretch =
      1.5 - 0.5 * chroma_share((std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2);
  const double c1 = std::hypot(first.a * stretch, first.b);
  const double c2 = std::hypot(second.a * stretch, second.b);
  const double h1 = hue(first.a * stretch, first.b);
  const double h2 = hue(second.a * stretch, second.b);
  const bool is_grey = c1 * c2 == 0;
  double way = is_grey ? 0 : h2 - h1;
  double h = h1 + h2;
  if (!is_grey) {
    const bool is_far = std::abs(way) > 180;
    if (is_far) way += way > 0 ? -360 : 360;
    h = (is_far ? h + (h < 360 ? 360 : -360) : h) / 2;
  }
  const double lightness = (first.l + second.l) / 2;
  const double chroma = (c1 + c2) / 2;
  const double t =
      1 - 0.17 * cosine(h - 30) + 0.24 * cosine(2 * h) + 0.32 * cosine(3 * h + 6) - 0.20 * cosine(4 * h - 63);
  const double of_l = 1 + 0.015 * square(lightness - 50) / std::sqrt(20 + square(lightness - 50));
  const double by_l = (second.l - first.l) / of_l;
  const double by_c = (c2 - c1) / (1 + 0.045 * chroma);
  const double by_h = 2 * std::sqrt(c1 * c2) * std::sin(way / 2 * (kPi / 180)) / (1 + 0.015 * chroma * t);
  const double turn = 60 * std::exp(-square((h - 275) / 25));
  const double rotation = -2 * chroma_share(chroma) * std::sin(turn * (kPi / 180));
  return std::sqrt(square(by_l) + square(by_c) + square(by_h) + rotation * by_c * by_h);
}

}  // namespace deltamesh
