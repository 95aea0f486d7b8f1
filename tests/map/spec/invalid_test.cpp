// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Committed messages and parts of maps that break one rule each are refused with the tag of that rule. They
// are kept by tests/spec/make_invalid_maps.py, which says what is in the files, and the reference decoder
// refuses them with the same tags.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/byte_reader.h"
#include "deltamesh/io.h"
#include "deltamesh/map/fragment.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"
#include "message/entry_fields.h"
#include "message/frame.h"

namespace deltamesh {
namespace {

using Blob = std::span<const std::byte>;

std::vector<Blob> blobs_of(Blob file) {
  ByteReader in(file);
  std::vector<Blob> blobs;
  while (in.remaining() > 0) {
    const auto size = in.read_varint();
    const auto blob = in.read_bytes(size ? *size : 0);
    if (!size || !blob) break;
    blobs.push_back(*blob);
  }
  return blobs;
}

Result<void> decode_keyed(const MapDescription& description, Blob keyed) {
  const auto codec = MapCodec::open(description);
  if (!codec) return codec.error();
  ByteReader in(keyed);
  const auto key = read_key(in);
  if (!key) return key.error();
  const auto octets = in.read_bytes(in.remaining());
  const auto part = codec->decode(*key, *octets);
  return part ? Result<void>() : part.error();
}

Result<void> read_blobs(const std::vector<Blob>& blobs) {
  const auto kind = kind_of_message(blobs.front());
  if (kind && *kind == MessageKind::kPose) {
    const auto pose = read_pose(blobs.front());
    return pose ? Result<void>() : pose.error();
  }
  if (kind && *kind == MessageKind::kFragment) {
    FragmentJoiner joiner;
    for (const Blob blob : blobs)
      if (const auto whole = joiner.add(blob); !whole) return whole.error();
    return {};
  }
  const auto description = read_description(blobs.front());
  if (!description) return description.error();
  return decode_keyed(*description, blobs.back());
}

TEST(InvalidMaps, AreRefusedWithTheTagOfTheRuleThatTheyBreak) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DELTAMESH_INVALID_MAPS_DIR)) {
    const std::string name = entry.path().filename().string();
    SCOPED_TRACE(name);
    const auto bytes = read_file(entry.path().string());
    ASSERT_TRUE(bytes) << describe(bytes.error());
    const auto outcome = read_blobs(blobs_of(*bytes));
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().rule, name.substr(0, name.find('.'))) << describe(outcome.error());
    ++count;
  }
  EXPECT_GE(count, 20U);
}

}  // namespace
}  // namespace deltamesh
