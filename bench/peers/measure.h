// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One peer on one mesh: size, errors and times.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"
#include "peers/peer.h"
#include "support/timing.h"

namespace deltamesh::bench {

struct Measurement {
  std::string mesh;
  std::string peer;
  std::string setting;
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  double diagonal = 0;  ///< of the bounding box, model units
  std::uint64_t bytes = 0;
  Quality quality;            ///< model units
  double encode_seconds = 0;  ///< processor time, median
  double decode_seconds = 0;  ///< processor time, median
  std::optional<ByteShares> shares{};

  double bits_per_vertex() const { return 8 * static_cast<double>(bytes) / static_cast<double>(vertices); }
  double percent(double error) const { return 100 * error / diagonal; }
};

/// `mesh`: from welded_geometry(). Each direction is timed by itself. Errors: the peer's; compare()'s;
/// kInternal where the decoded mesh does not have the topology of `mesh`.
Result<Measurement> measure(Peer& peer, const std::string& name, const Mesh& mesh,
                            const TimingEffort& effort = {});

}  // namespace deltamesh::bench
