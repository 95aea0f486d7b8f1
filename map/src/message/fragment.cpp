// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Fragments [MAP-25].
#include "deltamesh/map/fragment.h"

#include <xxhash.h>

#include <algorithm>
#include <utility>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/guard.h"
#include "base/try.h"
#include "message/frame.h"
#include "support/errors.h"

namespace deltamesh {
namespace {

constexpr std::size_t kMostBegun = 64;
constexpr std::size_t kMostOctets = std::size_t{1} << 20;
constexpr std::size_t kAround = 24;  // bytes of a fragment beside its octets, at the most: magic, kind, id,
                                     // size, offset, checksum

/// The reason why not, or null.
const char* what_is_wrong(std::uint64_t size, std::uint64_t offset, std::size_t octets) noexcept {
  if (size > kMostMessageBytes) return "fragments of a message of more than 262144 bytes";
  if (octets == 0 || octets >= size || offset > size - octets)
    return "a fragment that is no piece of its message";
  return nullptr;
}

}  // namespace

Result<std::vector<std::byte>> write_fragment(const FragmentMessage& fragment) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    if (const char* wrong = what_is_wrong(fragment.size, fragment.offset, fragment.octets.size()))
      return invalid_argument(wrong, "MAP-25");
    ByteWriter out = begin_message(MessageKind::kFragment);
    out.write(fragment.id);
    out.write_varint(fragment.size);
    out.write_varint(fragment.offset);
    out.write_bytes(fragment.octets);
    return end_message(std::move(out));
  });
}

Result<FragmentMessage> read_fragment(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<FragmentMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kFragment));
    ByteReader in(body);
    FragmentMessage fragment;
    DELTAMESH_TRY(fragment.id, in.read<std::uint64_t>());
    DELTAMESH_TRY(fragment.size, in.read_varint());
    DELTAMESH_TRY(fragment.offset, in.read_varint());
    if (const char* wrong = what_is_wrong(fragment.size, fragment.offset, in.remaining()))
      return in.error(ErrorCode::kInvalidStream, wrong, "MAP-25");
    DELTAMESH_TRY(const auto octets, in.read_bytes(in.remaining()));
    fragment.octets.assign(octets.begin(), octets.end());
    return fragment;
  });
}

Result<std::vector<std::vector<std::byte>>> cut_message(std::vector<std::byte> message,
                                                        std::size_t most) noexcept {
  return guarded([&]() -> Result<std::vector<std::vector<std::byte>>> {
    if (most != 0 && most < kLeastFragment)
      return invalid_argument("a largest message of less than 64 bytes", "MAP-25");
    std::vector<std::vector<std::byte>> pieces;
    if (most == 0 || message.size() <= most) {
      pieces.push_back(std::move(message));
      return pieces;
    }
    const std::uint64_t id = XXH3_64bits(message.data(), message.size());
    const std::size_t count = (message.size() + most - kAround - 1) / (most - kAround);
    const std::size_t length = (message.size() + count - 1) / count;
    for (std::size_t offset = 0; offset < message.size(); offset += length) {
      const auto octets = std::span(message).subspan(offset, std::min(length, message.size() - offset));
      DELTAMESH_TRY(pieces.emplace_back(),
                    write_fragment({id, message.size(), offset, {octets.begin(), octets.end()}}));
    }
    return pieces;
  });
}

FragmentJoiner::Begun& FragmentJoiner::begun_for(const FragmentMessage& fragment) {
  const auto is_it = [&](const Begun& begun) {
    return begun.id == fragment.id && begun.bytes.size() == fragment.size;
  };
  if (const auto found = std::ranges::find_if(begun_, is_it); found != begun_.end()) return *found;
  const auto size = static_cast<std::size_t>(fragment.size);  // at most kMostMessageBytes
  std::size_t octets = size;
  for (const Begun& begun : begun_) octets += begun.bytes.size();
  while (!begun_.empty() && (octets > kMostOctets || begun_.size() >= kMostBegun)) {
    octets -= begun_.front().bytes.size();
    begun_.pop_front();
  }
  return begun_.emplace_back(Begun{fragment.id, std::vector<std::byte>(size), std::vector<bool>(size), size});
}

Result<std::optional<std::vector<std::byte>>> FragmentJoiner::add(std::span<const std::byte> bytes) noexcept {
  return guarded([&]() -> Result<std::optional<std::vector<std::byte>>> {
    DELTAMESH_TRY(const FragmentMessage fragment, read_fragment(bytes));
    Begun& begun = begun_for(fragment);
    for (std::size_t i = 0; i < fragment.octets.size(); ++i) {
      const std::size_t place = static_cast<std::size_t>(fragment.offset) + i;
      if (begun.has[place]) continue;
      begun.has[place] = true;
      begun.bytes[place] = fragment.octets[i];
      --begun.missing;
    }
    if (begun.missing > 0) return std::optional<std::vector<std::byte>>();
    std::vector<std::byte> message = std::move(begun.bytes);
    std::erase_if(begun_, [](const Begun& b) { return b.missing == 0; });
    if (XXH3_64bits(message.data(), message.size()) != fragment.id)
      return Error{.code = ErrorCode::kCorrupt,
                   .message = "fragments that do not make the message that they say",
                   .rule = "MAP-25"};
    return std::optional(std::move(message));
  });
}

}  // namespace deltamesh
