// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Properties of the target machine, and checks of those that the code relies on.
#pragma once

#include <bit>
#include <cfloat>

namespace deltamesh {

#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
/// Modules for the web have one thread each; what is for several is left out.
inline constexpr bool kHasThreads = false;
#else
inline constexpr bool kHasThreads = true;
#endif

static_assert(std::endian::native == std::endian::little, "numbers share registers, the lowest first");
static_assert(FLT_EVAL_METHOD == 0, "floats must be rounded to their own precision: -mfpmath=sse on i686");

}  // namespace deltamesh
