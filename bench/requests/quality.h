// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How near achieved figures come to those asked for, and what effort takes.
#pragma once

#include <string>

#include "deltamesh/result.h"
#include "support/command_line.h"

namespace deltamesh::bench {

/// Prints, of ten meshes: figures achieved over those asked for, bytes and time of VDE at 0.2, 0.05 and 0.01
/// % of the diagonal, LFE at 0.5, 0.1 and 0.02 %, alone and with a VDE of 0.02 %, and largest errors of 0.5
/// and 0.05 %; of a map with colours the same at effort 0 beside 1. With `all`: of every mesh file of the
/// corpus a largest error of 0.1 % instead. Errors: encode()'s.
Result<void> print_quality(const Choice& choice, bool all);

}  // namespace deltamesh::bench
