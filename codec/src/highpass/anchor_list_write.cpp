// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/coder/writer.h"
#include "highpass/anchor_list.h"

namespace deltamesh {

std::vector<std::byte> write_compact_anchors(AnchorList list) {
  CompactWriter writer;
  code_anchors(writer, list);
  return writer.finish();
}

}  // namespace deltamesh
