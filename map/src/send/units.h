// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The order in which a receiver gets what it lacks.
#pragma once

#include <vector>

#include "send/viewer_state.h"

namespace deltamesh {

/// Parts that are shown together and so are sent together.
struct SendUnit {
  std::vector<PartKey> removed;
  std::vector<PartKey> needed;
};

/// Units without new parts first, then the coarsest, longest unsent, nearest to the view's boxes.
std::vector<SendUnit> units_of(const SendPlan& plan, const Viewer& viewer, const SourceMap& map,
                               const KnownVersions& known, const MapDescription& description);

PartEntry entry_of(const SourcePart& source, const Encoding& encoding, std::uint64_t revision,
                   std::vector<PartLink> links);

}  // namespace deltamesh
