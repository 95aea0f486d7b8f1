// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_writer.h"
#include "entropy/compact_writer.h"
#include "entropy/planes.h"
#include "geometry/anchor_list.h"

namespace deltamesh {

std::vector<std::byte> write_plain_anchors(const AnchorList& list) {
  ByteWriter out;
  write_planes(out, list.gaps);
  write_planes(out, list.steps);
  return out.take();
}

std::vector<std::byte> write_compact_anchors(const AnchorList& list) {
  CompactWriter writer;
  AnchorModels models;
  const std::size_t count = list.gaps.size();
  for (std::size_t i = 0; i < count; ++i) {
    writer.number(list.gaps[i], models.gaps);
    for (std::size_t axis = 0; axis < 3; ++axis)
      writer.number(list.steps[axis * count + i], models.steps[axis]);
  }
  return writer.finish();
}

}  // namespace deltamesh
