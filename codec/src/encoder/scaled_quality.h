// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Bounds of attributes that grow and shrink together, for a stream of a given size.
#pragma once

#include "deltamesh/attribute_quality.h"

namespace deltamesh {

/// `quality` with every bound `scale` times as large, at most to where an attribute would mean nothing any
/// more, or no larger than asked (is_asked). What is exact stays so. `scale`: above 0.
AttributeQuality scaled(const AttributeQuality& quality, double scale);

}  // namespace deltamesh
