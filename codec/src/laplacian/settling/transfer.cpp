// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/transfer.h"

namespace deltamesh::settling {

void restrict_rows(const Level& level, std::span<const Row> fine, std::span<Row> coarse) {
  for (std::uint32_t i = 0; i < coarse.size(); ++i) coarse[i] = Row{};
  level.chunks.visit([&](std::uint32_t i) {
    level.interpolation[i].spread(fine[i], [&](std::uint32_t node) -> Row& { return coarse[node]; });
  });
}

void prolong_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine) {
  for (std::uint32_t i = 0; i < fine.size(); ++i) fine[i] = level.interpolation[i].of(coarse);
}

void add_prolonged_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine) {
  for (std::uint32_t i = 0; i < fine.size(); ++i) fine[i] += level.interpolation[i].of(coarse);
}

}  // namespace deltamesh::settling
