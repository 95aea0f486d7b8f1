// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Matches that cannot be right, where two meshes do not have the same faces.
#pragma once

#include <vector>

#include "quality/face_matching.h"

namespace deltamesh {

/// Drops matches whose corners are too far apart to be the same face; all of them where most are. For meshes
/// whose faces do not correspond one to one. O(m).
void drop_far_matches(const FaceGraph& a, const FaceGraph& b, std::vector<FaceMatch>& matches);

}  // namespace deltamesh
