// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/directory.h"

#include <gtest/gtest.h>

namespace deltamesh {
namespace {

ChunkEntry sample_entry() {
  return {.tag = kTagDeltas,
          .codec = ChunkCodec::kZstd,
          .coded_bytes = 300,
          .decoded_bytes = 70000,
          .checksum = 42};
}

Result<std::vector<ChunkEntry>> reread(const ChunkEntry& entry) {
  ByteWriter out;
  write_directory(out, std::vector{entry});
  ByteReader in(out.bytes());
  return read_directory(in);
}

std::string broken_rule(const ChunkEntry& entry) {
  const auto result = reread(entry);
  return result ? "none" : result.error().rule;
}

TEST(Directory, DIR1RoundTripsAndRejectsMoreEntriesThanBytes) {
  const auto entries = reread(sample_entry());
  ASSERT_TRUE(entries);
  ASSERT_EQ(entries->size(), 1U);
  EXPECT_EQ(entries->front().tag, kTagDeltas);
  EXPECT_EQ(entries->front().coded_bytes, 300U);
  EXPECT_EQ(entries->front().decoded_bytes, 70000U);
  EXPECT_EQ(entries->front().checksum, 42U);
  const std::byte lying[] = {std::byte{0x7f}, std::byte{0}};
  ByteReader in(lying);
  EXPECT_STREQ(read_directory(in).error().rule, "DIR-1");
}

TEST(Directory, DIR2TagsAreLettersAndTheLastOnesCaseSaysSkippable) {
  ChunkEntry entry = sample_entry();
  entry.tag = 0x20202020;
  EXPECT_EQ(broken_rule(entry), "DIR-2");
  EXPECT_FALSE(is_skippable(chunk_tag("NEWS")));
  EXPECT_TRUE(is_skippable(chunk_tag("NEWs")));
}

TEST(Directory, DIR3RejectsOtherParts) {
  ChunkEntry entry = sample_entry();
  entry.part = 1;
  EXPECT_EQ(broken_rule(entry), "DIR-3");
}

TEST(Directory, DIR4RejectsUnknownCodecs) {
  ChunkEntry entry = sample_entry();
  entry.codec = static_cast<ChunkCodec>(9);
  EXPECT_EQ(broken_rule(entry), "DIR-4");
}

TEST(Directory, DIR5RejectsLengthsThatCannotBothBe) {
  ChunkEntry entry = sample_entry();
  entry.decoded_bytes = 300 * kMaxExpansion;
  EXPECT_EQ(broken_rule(entry), "none");
  entry.decoded_bytes += 1;
  EXPECT_EQ(broken_rule(entry), "DIR-5");
  entry.codec = ChunkCodec::kRaw;
  entry.decoded_bytes = entry.coded_bytes + 1;
  EXPECT_EQ(broken_rule(entry), "DIR-5");
}

}  // namespace
}  // namespace deltamesh
