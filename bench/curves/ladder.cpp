// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "curves/ladder.h"

#include <span>
#include <string>

#include "report/text.h"

namespace deltamesh::bench {
namespace {

struct Rung {
  int bits;
  double anchor_share;
};

/// 0.5 % throughout the range of VDE, 1 % where a small LFE is what counts, 0.2 % for the smallest files.
constexpr Rung kQuickRungs[] = {{3, 0.002}, {3, 0.005}, {4, 0.005}, {5, 0.005}, {6, 0.005},
                                {7, 0.005}, {8, 0.005}, {7, 0.01},  {9, 0.01},  {10, 0.01}};
constexpr double kShares[] = {0.002, 0.005, 0.01};

/// Bounds that are asked for, percent of the diagonal: about what Draco makes of qp 9 to 12.
constexpr double kAskedPercents[] = {0.1, 0.05, 0.025, 0.0125, 0.00625};

QualityBound bound(double percent) { return {.value = percent, .unit = QualityUnit::kDiagonal}; }

}  // namespace

std::vector<std::unique_ptr<Peer>> make_ladder(bool quick) {
  std::vector<std::unique_ptr<Peer>> ladder;
  if (quick) {
    for (const Rung& rung : kQuickRungs) ladder.push_back(make_deltamesh_peer(rung.bits, rung.anchor_share));
  } else {
    for (const double share : kShares)
      for (int bits = 3; bits <= 10; ++bits) ladder.push_back(make_deltamesh_peer(bits, share));
  }
  for (const double percent : kAskedPercents) {
    const std::string label = significant(percent, 3) + " %";
    ladder.push_back(make_deltamesh_peer({.vde = bound(percent)}, "VDE " + label));
    ladder.push_back(make_deltamesh_peer({.lfe = bound(percent)}, "LFE " + label));
  }
  for (const int level : {10, 7})
    for (int bits = 8; bits <= 14; ++bits) ladder.push_back(make_draco_peer(level, bits));
  for (int bits = 8; bits <= 14; bits += quick ? 3 : 1) {
    ladder.push_back(make_meshoptimizer_peer(bits));
    ladder.push_back(make_openctm_peer(bits));
  }
  return ladder;
}

}  // namespace deltamesh::bench
