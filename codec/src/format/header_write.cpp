// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_writer.h"
#include "format/field_io.h"
#include "format/header_fields.h"

namespace deltamesh {
std::vector<std::byte> write_header(const FileHeader& header) {
  ByteWriter out;
  const std::uint8_t flags = flags_of(header);
  for (const char letter : kMagic) out.write(letter);
  out.write(kFormatVersion);
  out.write(flags);
  FieldWriter fields(out);
  visit_fields(fields, flags, header);
  return out.take();
}

}  // namespace deltamesh
