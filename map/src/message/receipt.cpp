// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "message/receipt.h"

#include <algorithm>
#include <functional>

#include "base/guard.h"
#include "base/try.h"
#include "message/frame.h"

namespace deltamesh {

const char* what_is_wrong(const Receipt& receipt) noexcept {
  const auto& missing = receipt.missing;
  if (std::ranges::adjacent_find(missing, std::greater_equal()) != missing.end())
    return "numbers of messages that do not ascend";
  if (!missing.empty() && (missing.front() == 0 || missing.back() >= receipt.highest ||
                           receipt.highest - missing.front() > kReceiptNumbers))
    return "a number of a message that a receipt has no bit for";
  return nullptr;
}

void write_receipt_fields(ByteWriter& out, const Receipt& receipt) {
  std::vector<std::byte> bits;
  for (const std::uint64_t number : receipt.missing) {
    const auto bit = static_cast<std::size_t>(receipt.highest - 1 - number);
    bits.resize(std::max(bits.size(), bit / 8 + 1));
    bits[bit / 8] |= std::byte{1} << (bit % 8);
  }
  out.write_varint(receipt.highest);
  out.write(static_cast<std::uint8_t>(bits.size()));
  out.write_bytes(bits);
}

Result<Receipt> read_receipt_fields(ByteReader& in) {
  Receipt receipt;
  DELTAMESH_TRY(receipt.highest, in.read_varint());
  DELTAMESH_TRY(const auto size, in.read<std::uint8_t>());
  if (size > kReceiptNumbers / 8)
    return in.error(ErrorCode::kInvalidStream, "a receipt of more than 256 numbers", "MAP-21");
  DELTAMESH_TRY(const auto bits, in.read_bytes(size));
  if (size != 0 && bits.back() == std::byte{})
    return in.error(ErrorCode::kInvalidStream, "a receipt that is longer than it needs to be", "MAP-21");
  for (std::size_t bit = 8 * std::size_t{size}; bit-- > 0;) {
    if ((bits[bit / 8] >> (bit % 8) & std::byte{1}) == std::byte{}) continue;
    if (bit + 1 >= receipt.highest)
      return in.error(ErrorCode::kInvalidStream, "a receipt of numbers below 1", "MAP-21");
    receipt.missing.push_back(receipt.highest - 1 - bit);
  }
  return receipt;
}

Result<std::vector<std::byte>> write_receipt(const ReceiptMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    if (const char* wrong = what_is_wrong(message.receipt))
      return Error{.code = ErrorCode::kInvalidArgument, .message = wrong, .rule = "MAP-21"};
    ByteWriter out = begin_message(MessageKind::kReceipt);
    out.write(message.viewer);
    out.write_varint(message.number);
    out.write(message.map_id);
    out.write_varint(message.start);
    write_receipt_fields(out, message.receipt);
    return end_message(std::move(out));
  });
}

Result<ReceiptMessage> read_receipt(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<ReceiptMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kReceipt));
    ByteReader in(body);
    ReceiptMessage receipt;
    DELTAMESH_TRY(receipt.viewer, in.read<std::uint64_t>());
    DELTAMESH_TRY(receipt.number, in.read_varint());
    DELTAMESH_TRY(receipt.map_id, in.read<std::uint64_t>());
    DELTAMESH_TRY(receipt.start, in.read_varint());
    DELTAMESH_TRY(receipt.receipt, read_receipt_fields(in));
    DELTAMESH_CHECK(in.finish());
    return receipt;
  });
}

}  // namespace deltamesh
