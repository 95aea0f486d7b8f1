// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "format/chunk/header.h"

namespace deltamesh::chunk_header_test {
namespace {

constexpr std::uint32_t kTags[] = {kTagConnectivity, kTagSeams,     kTagFaceGroups, kTagDeltas, kTagAnchors,
                                   kTagPositions,    kTagAttribute, kTagOrder,      kTagGrid,   kTagFiller};

std::vector<std::byte> bytes_of(std::initializer_list<unsigned> values) {
  std::vector<std::byte> bytes;
  for (const unsigned value : values) bytes.push_back(static_cast<std::byte>(value));
  return bytes;
}

std::vector<std::byte> write(const ChunkEntry& entry) {
  ByteWriter out;
  write_chunk_header(out, entry);
  return out.take();
}

std::string broken_rule(const std::vector<std::byte>& bytes) {
  ByteReader in(bytes);
  const auto entry = read_chunk_header(in);
  return entry ? "none" : entry.error().rule;
}

TEST(ChunkHeader, DIR2RoundTripsEveryKind) {
  for (const std::uint32_t tag : kTags) {
    for (const ChunkCodec codec : {ChunkCodec::kRaw, ChunkCodec::kZstd, ChunkCodec::kCompact}) {
      const std::uint64_t decoded = codec == ChunkCodec::kZstd ? 70000 : 300;
      const auto bytes = write({.tag = tag, .codec = codec, .coded_bytes = 300, .decoded_bytes = decoded});
      ByteReader in(bytes);
      const auto entry = read_chunk_header(in);
      ASSERT_TRUE(entry);
      EXPECT_EQ(in.remaining(), 0U);
      EXPECT_EQ(entry->tag, tag);
      EXPECT_EQ(entry->codec, codec);
      EXPECT_EQ(entry->coded_bytes, 300U);
      EXPECT_EQ(entry->decoded_bytes, decoded);
    }
  }
}

TEST(ChunkHeader, DIR2TakesTwoBytesForAShortCompactChunk) {
  EXPECT_EQ(write({.tag = kTagPositions, .codec = ChunkCodec::kCompact, .coded_bytes = 127}),
            bytes_of({0x26, 127}));
}

TEST(ChunkHeader, DIR2SpellsOutOtherTagsOfWhichOnlySkippableOnesAreRead) {
  EXPECT_EQ(broken_rule(bytes_of({0, 'N', 'E', 'W', 's', 5})), "none");
  EXPECT_EQ(broken_rule(bytes_of({0, 'N', 'E', 'W', 'S', 5})), "DIR-2");
  EXPECT_EQ(broken_rule(bytes_of({0, 'N', 'E', ' ', 's', 5})), "DIR-2");
  EXPECT_EQ(broken_rule(bytes_of({0, 'C', 'O', 'N', 'N', 5})), "DIR-2");
  EXPECT_FALSE(is_skippable(chunk_tag("NEWS")));
  EXPECT_TRUE(is_skippable(chunk_tag("NEWs")));
}

TEST(ChunkHeader, DIR2RejectsUnknownKinds) { EXPECT_EQ(broken_rule(bytes_of({0x0a, 5})), "DIR-2"); }

TEST(ChunkHeader, DIR4RejectsUnknownCodecs) { EXPECT_EQ(broken_rule(bytes_of({0x31, 5})), "DIR-4"); }

TEST(ChunkHeader, DIR5RejectsLengthsThatCannotBothBe) {
  ChunkEntry entry{.tag = kTagDeltas, .codec = ChunkCodec::kZstd, .coded_bytes = 300};
  entry.decoded_bytes = 300 * kMaxExpansion;
  EXPECT_EQ(broken_rule(write(entry)), "none");
  entry.decoded_bytes += 1;
  EXPECT_EQ(broken_rule(write(entry)), "DIR-5");
}

}  // namespace
}  // namespace deltamesh::chunk_header_test
