// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the versions of other parts that a version must not be shown beside [MAP-12].
#pragma once

#include <vector>

#include "send/viewer_state.h"

namespace deltamesh {

PartBox part_box(const Mesh& mesh);

/// The links of the newest version of a part, for a receiver: with least revisions of what is near and may be
/// there in an older version, or be on its way. `mesh`: as the receiver gets it.
std::vector<PartLink> links_for(const SourcePart& source, const Mesh& mesh, const Viewer& viewer,
                                const SendPlan& plan);

}  // namespace deltamesh
