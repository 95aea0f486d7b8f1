// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the coders of one attribute learn, for other streams to begin with [CMP-16].
#pragma once

#include <cstdint>
#include <optional>

#include "attributes/colors/coder.h"
#include "attributes/haar/models.h"

namespace deltamesh {

/// Empty: no such coder was used.
struct AttributeModels {
  std::optional<ColorModels> colors;
  std::optional<HaarModels> mean;

  void limit_counts(std::uint8_t most) noexcept {
    if (colors) colors->limit_counts(most);
    if (mean) mean->limit_counts(most);
  }
};

/// `models`: null for fresh ones.
inline const ColorModels* color_models(const AttributeModels* models) noexcept {
  return models != nullptr && models->colors ? &*models->colors : nullptr;
}
inline const HaarModels* mean_models(const AttributeModels* models) noexcept {
  return models != nullptr && models->mean ? &*models->mean : nullptr;
}

}  // namespace deltamesh
