// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From coded order back to the input's.
#pragma once

#include "connectivity/order/order.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// `order` fits `mesh`: read_order has checked it. O(size of the mesh).
Mesh restore_order(const Mesh& mesh, const MeshOrder& order);

}  // namespace deltamesh
