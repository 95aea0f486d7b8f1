// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Fault messages [MAP-22].
#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "message/entry_fields.h"
#include "message/frame.h"

namespace deltamesh {

Result<std::vector<std::byte>> write_fault(const FaultMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    DELTAMESH_CHECK(check_links(message.key, {}));
    ByteWriter out = begin_message(MessageKind::kFault);
    out.write(message.map);
    out.write_varint(message.start);
    out.write_varint(message.number);
    write_key(out, message.key);
    out.write(message.code);
    return end_message(std::move(out));
  });
}

Result<FaultMessage> read_fault(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<FaultMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kFault));
    ByteReader in(body);
    FaultMessage fault;
    DELTAMESH_TRY(fault.map, in.read<std::uint64_t>());
    DELTAMESH_TRY(fault.start, in.read_varint());
    DELTAMESH_TRY(fault.number, in.read_varint());
    DELTAMESH_TRY(fault.key, read_key(in));
    DELTAMESH_TRY(fault.code, in.read<std::uint16_t>());
    DELTAMESH_CHECK(in.finish());
    return fault;
  });
}

}  // namespace deltamesh
