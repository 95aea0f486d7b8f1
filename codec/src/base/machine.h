// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the code relies on of every machine.
#pragma once

#include <bit>
#include <cfloat>

namespace deltamesh {

static_assert(std::endian::native == std::endian::little, "numbers share registers, the lowest first");
static_assert(FLT_EVAL_METHOD == 0, "floats must be rounded to their own precision: -mfpmath=sse on i686");

}  // namespace deltamesh
