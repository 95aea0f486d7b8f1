// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a part is asked for when it is encoded, and what comes of it.
#pragma once

#include <cstddef>
#include <vector>

#include "deltamesh/encode.h"

namespace deltamesh {

/// The quality that a part is asked for.
struct PartQuality {
  /// Percent of the diagonal counts in the part's bounding box. `target_bytes` is not for parts. Empty: as
  /// EncodeOptions. No bound on the largest error may be below half the diagonal of a lattice cell.
  QualityRequest bounds{};
  /// Colours of which nothing is said are exact: parts are too small to tell labels from photographs. Ask
  /// ColorContent of the whole map, as encode_map() does.
  AttributeQuality attributes{};
  GeometryCoder geometry = GeometryCoder::kAuto;
  int effort = 1;  ///< 0 to 2
};

struct CodedPart {
  std::vector<std::byte> bytes;            ///< as MapCodec::decode() takes them
  Quality quality{};                       ///< measured on what decode() returns
  std::vector<double> attribute_errors{};  ///< of every attribute, in its kind's unit (AttributeInfo::error)
  double color_rms = 0;                    ///< of red, green and blue of all colours, 255ths
};

}  // namespace deltamesh
