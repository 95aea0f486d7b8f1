// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a header's fields must keep, and what follows from them.
#pragma once

#include "format/header.h"

namespace deltamesh {

/// Checks every field against its range. `in`: where an error is. Errors: kInvalidStream [HDR-6 .. HDR-14].
Result<void> check_header(const FileHeader& header, const ByteReader& in);

/// Sets the box to that of the lattice's points, as finite floats [HDR-8]. The header has passed
/// check_header.
void set_box_of_lattice(FileHeader& header) noexcept;

}  // namespace deltamesh
