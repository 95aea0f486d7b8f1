// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/gluing_write.h"

#include <utility>

#include "base/zigzag.h"
#include "connectivity/glue_coder.h"

namespace deltamesh {

GlueList list_glued(std::span<const std::uint32_t> vertex) {
  GlueList list;
  std::uint32_t fresh = 0;
  std::uint32_t gap_begin = 0;
  std::uint32_t last_target = 0;
  for (std::uint32_t m = 0; m < vertex.size(); ++m) {
    if (vertex[m] == fresh) {
      ++fresh;
    } else {
      list.gaps.push_back(fresh - std::exchange(gap_begin, fresh));
      list.targets.push_back(
          zigzag(static_cast<std::int32_t>(vertex[m] - std::exchange(last_target, vertex[m]))));
    }
  }
  return list;
}

void write_compact_gluing(CompactWriter& writer, std::span<const std::uint32_t> faces,
                          std::vector<std::uint32_t> vertex) {
  const GlueList list = list_glued(vertex);
  NumberModel counts;
  writer.number(static_cast<std::uint32_t>(list.gaps.size()), counts);
  if (is_dense(list.gaps.size(), vertex.size())) {
    GlueCoder(writer, faces, vertex.size()).code(vertex, [] { return false; });
    return;
  }
  NumberModel gaps;
  NumberModel targets;
  for (std::size_t i = 0; i < list.gaps.size(); ++i) {
    writer.number(list.gaps[i], gaps);
    writer.number(list.targets[i], targets);
  }
}

}  // namespace deltamesh
