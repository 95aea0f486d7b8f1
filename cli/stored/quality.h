// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The quality that was asked for, as members of JSON files.
#pragma once

#include <array>
#include <optional>

#include "deltamesh/attribute_quality.h"
#include "deltamesh/quality_request.h"
#include "stored/json_value.h"

namespace deltamesh::cli {

struct PositionBound {
  const char* key;   ///< in JSON
  const char* name;  ///< in reports
  std::optional<QualityBound> QualityRequest::*bound;
};
inline constexpr std::array<PositionBound, 3> kPositionBounds{
    {{"max_error", "max error", &QualityRequest::max_error},
     {"vde", "vde", &QualityRequest::vde},
     {"lfe", "lfe", &QualityRequest::lfe}}};

/// Bounds as the command line has them, so that none and percents stay what they are.
nlohmann::json json_of(const QualityRequest& request);
nlohmann::json json_of(const AttributeQuality& quality);

/// What json_of() makes the same JSON of. `percent`: may be in percent of the diagonal.
QualityRequest bounds_of(const JsonValue& json, bool percent);
AttributeQuality attributes_of(const JsonValue& json);

}  // namespace deltamesh::cli
