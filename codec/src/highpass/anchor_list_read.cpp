// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_reader.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "entropy/planes.h"
#include "format/chunk/tags.h"
#include "highpass/anchor_list.h"

namespace deltamesh {
namespace {

Result<AnchorList> read_plain(std::span<const std::byte> bytes, std::uint32_t count) {
  ByteReader in(bytes, kTagAnchors);
  AnchorList list;
  DELTAMESH_TRY(list.gaps, read_planes(in, count));
  DELTAMESH_TRY(list.steps, read_planes(in, 3 * std::uint64_t{count}));
  DELTAMESH_CHECK(in.finish());
  return list;
}

Result<AnchorList> read_compact(std::span<const std::byte> bytes, std::uint32_t count) {
  CompactReader reader(bytes);
  AnchorList list{.gaps = std::vector<std::uint32_t>(count),
                  .steps = std::vector<std::uint32_t>(3 * std::size_t{count})};
  code_anchors(reader, list);
  DELTAMESH_CHECK(reader.finish(kTagAnchors));
  return list;
}

}  // namespace

Result<AnchorList> read_anchors(Payload payload, std::uint32_t count) {
  return payload.is_compact ? read_compact(payload.bytes, count) : read_plain(payload.bytes, count);
}

}  // namespace deltamesh
