// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Interpolation by coarse nodes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "laplacian/multigrid/level/interpolation.h"

namespace deltamesh::multigrid {

/// Rows of P^T: the nodes that are interpolated from each coarse one, ascending.
struct Transposed {
  Transposed(std::span<const Interpolation> rows, std::uint32_t nodes) : start(nodes + 1, 0) {
    const auto visit = [&](const auto& each) {
      for (std::uint32_t i = 0; i < rows.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          if (rows[i].counts(k)) each(i, k);
        }
      }
    };
    visit([&](std::uint32_t i, std::size_t k) { ++start[rows[i].node(k) + 1]; });
    for (std::uint32_t c = 0; c < nodes; ++c) start[c + 1] += start[c];
    entries.resize(start[nodes]);
    LargeVector<std::uint32_t> next(start.begin(), start.end() - 1);
    visit([&](std::uint32_t i, std::size_t k) { entries[next[rows[i].node(k)]++] = {i, rows[i].weight(k)}; });
  }

  struct Entry {
    std::uint32_t node;
    float weight;
  };
  std::span<const Entry> of(std::uint32_t c) const noexcept {
    return std::span(entries).subspan(start[c], start[c + 1] - start[c]);
  }

  LargeVector<std::uint32_t> start;  ///< nodes + 1
  LargeVector<Entry> entries;
};

}  // namespace deltamesh::multigrid
