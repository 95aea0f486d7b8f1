// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Vertices with coordinates that are not finite, which no stream can hold.
#pragma once

#include "deltamesh/io.h"

namespace deltamesh {

/// Drops the faces at such vertices, and tells the report how many.
void drop_invalid_faces(Imported& imported);

/// Drops such vertices where no face uses them, likewise. Others keep their order.
void drop_invalid_unused(Imported& imported);

}  // namespace deltamesh
