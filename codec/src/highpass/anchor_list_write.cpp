// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_writer.h"
#include "entropy/coder/writer.h"
#include "entropy/planes.h"
#include "highpass/anchor_list.h"

namespace deltamesh {

std::vector<std::byte> write_plain_anchors(const AnchorList& list) {
  ByteWriter out;
  write_planes(out, list.gaps);
  write_planes(out, list.steps);
  return out.take();
}

std::vector<std::byte> write_compact_anchors(AnchorList list) {
  CompactWriter writer;
  code_anchors(writer, list);
  return writer.finish();
}

}  // namespace deltamesh
