// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How far decoded attributes may be from the source's: a bound for each kind, in its own unit.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace deltamesh {

/// Of the generic attributes with this name: the largest absolute difference of any component.
struct NamedBound {
  std::string name;
  double error = 0;  ///< in the attribute's unit; 0 is exact
  /// Instead, `error`, above 0, is the largest root mean square of all differences, met within 1 % from below
  /// or better where that takes fewer bytes. Of one component of u8, u16 or f32 in the compact form, such as
  /// an intensity; others keep it as a largest difference.
  bool is_mean = false;
};

/// The mean error of photographs' colours where nothing is said of colours: 41 dB of PSNR.
inline constexpr double kPhotographicRms = 2.2727;  // 255ths

/// Upper bounds on the error of every attribute; finite, at least 0, and 0 is exact. The encoder measures
/// what it keeps (AttributeInfo::error). Generic attributes without a bound of their own, and joints, are
/// exact.
struct AttributeQuality {
  double normal_error = 0.5;  ///< largest angle, degrees
  /// Largest angle of a tangent, degrees; the same as normals where it is not set. Its sign is exact.
  std::optional<double> tangent_error = std::nullopt;
  double uv_error = 1.0 / 4096;  ///< largest distance, texture coordinate units
  /// Largest difference of a component of a colour, 255ths of its range. Without it and `color_rms` it is 0
  /// for labels, and `color_rms` is kPhotographicRms for photographs (ColorContent tells them apart).
  std::optional<double> color_error = std::nullopt;
  /// In place of `color_error`, above 0: the largest root mean square of the errors of all values of red,
  /// green and blue, 255ths of their range, and of those of alpha. Met within 1 % from below (1.5 % beyond 48
  /// dB), or better where that takes fewer bytes. Of 3 or 4 components of u8, u16 or f32 in the compact form;
  /// other colours keep it as a largest error.
  std::optional<double> color_rms = std::nullopt;
  /// Largest difference of a skinning weight. Sums of 1 stay 1; weights that do not add up to 1, as those of
  /// each of two sets, are exact, which takes several times the bytes.
  double weight_error = 1.0 / 1024;
  std::vector<NamedBound> named = {};  ///< of generic attributes; the first that fits holds
  /// Whether they hold within `target_bytes`, too: else all are scaled there together with the errors of
  /// positions.
  bool is_asked = false;
};

}  // namespace deltamesh
