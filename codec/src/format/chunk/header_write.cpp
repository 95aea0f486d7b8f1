// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/chunk/header.h"
#include "format/chunk/kinds.h"

namespace deltamesh {

void write_chunk_header(ByteWriter& out, const ChunkEntry& entry) {
  const unsigned kind = kind_of(entry.tag);
  out.write(static_cast<std::uint8_t>(kind | static_cast<unsigned>(entry.codec) << kCodecShift));
  if (kind == kLetters) out.write(entry.tag);
  out.write_varint(entry.coded_bytes);
  if (entry.codec == ChunkCodec::kZstd) out.write_varint(entry.decoded_bytes);
}

}  // namespace deltamesh
