// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes at a mean error: which coding is for it.
#pragma once

#include <optional>

#include "attributes/attribute.h"
#include "attributes/rows.h"

namespace deltamesh {

/// By the transform, or within a largest error that keeps `rms` where that is smaller. `rms`: of
/// mean_bound_of(). Empty where neither keeps it.
std::optional<CodedAttribute> code_at_mean_error(const AttributeView& attribute, const AttributeRows& rows,
                                                 double rms, const AttributeSettings& settings,
                                                 const AttributeSurface& surface);

}  // namespace deltamesh
