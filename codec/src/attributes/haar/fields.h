// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What stands before the coefficients [HAAR-6].
#pragma once

#include <cmath>
#include <cstdint>

#include "attributes/haar/color_axes.h"
#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/try.h"
#include "deltamesh/result.h"

namespace deltamesh {

inline constexpr std::uint32_t kMostHaarStep = 65535;

enum class HaarAlpha : std::uint8_t { kNone, kConstant, kCoded };

/// What levels of numbers that are no colours stand for: low + unit * level.
struct HaarScale {
  float low = 0;
  float unit = 1;

  bool is_valid() const noexcept { return std::isfinite(low) && std::isfinite(unit) && unit > 0; }
};

struct HaarFields {
  HaarScale scale;                     ///< of one component
  unsigned axes = kHaarAxes;           ///< 1 or 3, of colours; of one component 1
  HaarAlpha alpha = HaarAlpha::kNone;  ///< of 3 components kNone, of 4 another
  std::uint8_t alpha_level = 0;        ///< of a constant one
  std::uint32_t step = 1;              ///< of a coefficient, 64ths of a level, 1 to kMostHaarStep
};

/// `components`: 1, 3 or 4.
inline void write_haar_fields(ByteWriter& out, const HaarFields& fields, unsigned components) {
  if (components == 1) {
    out.write(fields.scale.low);
    out.write(fields.scale.unit);
  } else {
    out.write(static_cast<std::uint8_t>(fields.axes));
  }
  if (fields.alpha != HaarAlpha::kNone) out.write(static_cast<std::uint8_t>(fields.alpha));
  if (fields.alpha == HaarAlpha::kConstant) out.write(fields.alpha_level);
  out.write(static_cast<std::uint16_t>(fields.step));
}

/// `components`: 1, 3 or 4. Errors: kTruncated, kInvalidStream [HAAR-6].
inline Result<HaarFields> read_haar_fields(ByteReader& in, unsigned components) {
  HaarFields fields;
  if (components == 1) {
    DELTAMESH_TRY(fields.scale.low, in.read<float>());
    DELTAMESH_TRY(fields.scale.unit, in.read<float>());
    fields.axes = 1;
    if (!fields.scale.is_valid()) return in.invalid("numbers have no scale", "HAAR-6");
  } else {
    DELTAMESH_TRY(fields.axes, in.read<std::uint8_t>());
  }
  if (fields.axes != 1 && fields.axes != kHaarAxes)
    return in.invalid("number of axes of colours is neither 1 nor 3", "HAAR-6");
  if (components > kHaarAxes) {
    DELTAMESH_TRY(const auto alpha, in.read<std::uint8_t>());
    fields.alpha = static_cast<HaarAlpha>(alpha);
    if (fields.alpha == HaarAlpha::kConstant) {
      DELTAMESH_TRY(fields.alpha_level, in.read<std::uint8_t>());
    } else if (fields.alpha != HaarAlpha::kCoded) {
      return in.invalid("alpha is neither constant nor coded", "HAAR-6");
    }
  }
  DELTAMESH_TRY(fields.step, in.read<std::uint16_t>());
  if (fields.step == 0) return in.invalid("step is 0", "HAAR-6");
  return fields;
}

}  // namespace deltamesh
