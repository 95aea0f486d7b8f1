// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rows of planned cycles and their interpolation, which solutions that settle are made of as well.
#pragma once

#include "laplacian/multigrid/level/interpolation.h"
#include "laplacian/multigrid/level/row.h"

namespace deltamesh::settling {

using multigrid::Double4;
using multigrid::Float4;
using multigrid::Interpolation;
using multigrid::narrow;
using multigrid::Row;
using multigrid::to_float4;
using multigrid::to_vec3;
using multigrid::widen;

}  // namespace deltamesh::settling
