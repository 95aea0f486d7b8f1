// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Figures as streams declare them: short floats, and never better than what was measured.
#pragma once

#include "base/short_float.h"

namespace deltamesh {

/// The smallest short float that is not below `value`, which is 0 or more; infinity where there is none.
inline float round_up(double value) noexcept { return short_float_above(value); }

}  // namespace deltamesh
