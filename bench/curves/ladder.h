// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which peers at which settings a run goes through.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "peers/peer.h"

namespace deltamesh::bench {

/// What the equal-quality table compares, and with what.
inline constexpr std::string_view kOurName = "deltamesh";
inline constexpr std::string_view kReferenceName = "Draco cl 10";

/// Full: ours at 3 to 10 bits with 0.2, 0.5 and 1 % anchors and at asked bounds on VDE and LFE; Draco cl 7
/// and cl 10, meshoptimizer and OpenCTM at qp 8 to 14. Quick: fewer of ours and of the last two.
std::vector<std::unique_ptr<Peer>> make_ladder(bool quick);

}  // namespace deltamesh::bench
