// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "patch/container.h"

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/try.h"
#include "format/container_frame.h"
#include "message/entry_fields.h"
#include "part/header.h"

namespace deltamesh {
namespace {

std::uint32_t body_checksum(const PartPlace& place, std::uint64_t base_hash,
                            std::span<const std::byte> covered) {
  ByteWriter all;
  all.write(base_hash);
  all.write_bytes(covered);
  return part_checksum(place, all.bytes());
}

}  // namespace

bool is_patched(std::span<const std::byte> octets) noexcept {
  return !octets.empty() && octets.front() == std::byte{kFlagPatched};
}

std::size_t count_patches(std::span<const std::byte> octets) noexcept {
  std::size_t count = 0;
  for (; count <= kMostPatches && is_patched(octets); ++count) {
    const auto divided = divide_patched(octets);
    if (!divided) break;
    octets = divided->base;
  }
  return count;
}

Result<PatchedOctets> divide_patched(std::span<const std::byte> octets) {
  ByteReader in(octets.subspan(1));
  DELTAMESH_TRY(const auto base_key, read_key(in));
  DELTAMESH_TRY(const auto size, in.read_varint());
  DELTAMESH_TRY(const auto base, in.read_bytes(size));
  DELTAMESH_TRY(const auto body, in.read_bytes(in.remaining()));
  if (base.empty() || body.empty())
    return in.error(ErrorCode::kInvalidStream, "a patched part without a base or a patch", "MAP-17");
  return PatchedOctets{base_key, base, body};
}

std::vector<std::byte> join_patched(const PatchedOctets& parts) {
  ByteWriter out;
  out.write(kFlagPatched);
  write_key(out, parts.base_key);
  out.write_varint(parts.base.size());
  out.write_bytes(parts.base);
  out.write_bytes(parts.body);
  return out.take();
}

std::vector<std::byte> write_body(const PartPlace& place, std::uint64_t base_hash, const PatchBody& body) {
  ByteWriter out;
  out.write_varint(body.plan.size());
  out.write_bytes(body.plan);
  out.write_bytes(body.inserted);
  out.write(body_checksum(place, base_hash, out.bytes()));
  return out.take();
}

Result<PatchBody> open_body(const PartPlace& place, std::uint64_t base_hash,
                            std::span<const std::byte> bytes) {
  const auto checksum = [&](std::span<const std::byte> covered) {
    return body_checksum(place, base_hash, covered);
  };
  DELTAMESH_TRY(const auto covered,
                check_whole(bytes, "the checksum does not match: damaged, or a patch of something else",
                            "MAP-17", checksum));
  ByteReader in(covered);
  DELTAMESH_TRY(const auto size, in.read_varint());
  DELTAMESH_TRY(const auto plan, in.read_bytes(size));
  DELTAMESH_TRY(const auto inserted, in.read_bytes(in.remaining()));
  if (is_patched(inserted))
    return in.error(ErrorCode::kInvalidStream, "a patch whose inserted part is patched", "MAP-17");
  return PatchBody{plan, inserted};
}

}  // namespace deltamesh
