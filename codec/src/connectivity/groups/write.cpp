// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_writer.h"
#include "connectivity/groups/coder.h"
#include "connectivity/groups/groups.h"
#include "entropy/coder/writer.h"
#include "entropy/planes.h"

namespace deltamesh {

CodedFaceGroups write_face_groups(std::vector<std::uint32_t> groups, std::span<const std::uint32_t> triangles,
                                  std::uint32_t vertex_count) {
  CodedFaceGroups coded;
  if (groups.empty()) return coded;
  ByteWriter plain;
  write_planes(plain, groups);
  coded.payload = plain.take();
  CompactWriter writer;
  FaceGroupCoder<CompactWriter>(writer, triangles, vertex_count).code(groups);
  coded.compact = writer.finish();
  return coded;
}

}  // namespace deltamesh
