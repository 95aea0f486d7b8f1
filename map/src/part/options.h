// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A part's quality as the encoder's options.
#pragma once

#include "deltamesh/encode.h"
#include "deltamesh/map/part_quality.h"

namespace deltamesh {

/// Where nothing is said of colours they are exact: a part alone does not tell labels from photographs.
inline EncodeOptions options_for(const PartQuality& quality) {
  EncodeOptions options;
  options.quality = quality.bounds;
  options.attributes = quality.attributes;
  if (!options.attributes.color_rms && !options.attributes.color_error) options.attributes.color_error = 0;
  options.geometry = quality.geometry;
  options.effort = quality.effort;
  return options;
}

}  // namespace deltamesh
