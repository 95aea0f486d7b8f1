// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/container.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "deltamesh/stream_info.h"
#include "entropy/chunk_codec.h"

namespace deltamesh {
namespace {

std::vector<std::byte> bytes_of(std::size_t count, unsigned seed) {
  std::vector<std::byte> bytes(count);
  for (std::byte& b : bytes) b = static_cast<std::byte>((seed = seed * 1664525 + 1013904223) >> 24);
  return bytes;
}

FileHeader sample_header() {
  FileHeader h;
  h.vertices = h.geometric_vertices = 4;
  h.triangles = 4;
  h.components = 1;
  h.highpass = {.bits = 8, .step = 1, .anchor_bits = 12, .anchors = 1, .anchor_density = 1};
  return h;
}

CodedChunk chunk(std::uint32_t tag, std::vector<std::byte> payload) {
  return *code_chunk(tag, std::move(payload));
}

std::vector<std::byte> sample_stream() {
  return write_container(sample_header(), std::vector{chunk(kTagConnectivity, bytes_of(13, 1)),
                                                      chunk(kTagDeltas, std::vector<std::byte>(500))});
}

std::string open_rule(std::span<const std::byte> stream) {
  const auto result = Container::open(stream);
  return result ? "none" : result.error().rule;
}

TEST(Container, CNT1HoldsHeaderDirectoryAndChunks) {
  const auto stream = sample_stream();
  const auto container = Container::open(stream);
  ASSERT_TRUE(container);
  ASSERT_EQ(container->entries().size(), 2U);
  EXPECT_EQ(container->entries()[0].codec, ChunkCodec::kRaw) << "random bytes do not shrink";
  EXPECT_EQ(container->entries()[1].codec, ChunkCodec::kZstd);
  const auto raw = expand_single(*container, kTagConnectivity, 1000);
  EXPECT_TRUE(std::ranges::equal(raw->bytes(), bytes_of(13, 1)));
  const auto expanded = expand_single(*container, kTagDeltas, 1000);
  EXPECT_TRUE(std::ranges::equal(expanded->bytes(), std::vector<std::byte>(500)));
  EXPECT_TRUE(expand_single(*container, kTagAnchors, 1000)->bytes().empty());
}

TEST(Container, CNT2ChecksumCoversHeaderAndDirectory) {
  const auto clean = sample_stream();
  const std::size_t first_chunk = static_cast<std::size_t>(Container::open(clean)->entries()[0].offset);
  for (std::size_t i = 0; i < first_chunk; ++i) {
    auto stream = clean;
    stream[i] ^= std::byte{1};
    EXPECT_NE(open_rule(stream), "none") << "byte " << i;
  }
}

TEST(Container, CNT3ChunksStartAtMultiplesOf8AfterZeros) {
  auto stream = sample_stream();
  const auto container = Container::open(stream);
  ASSERT_TRUE(container);
  for (const ChunkEntry& entry : container->entries()) EXPECT_EQ(entry.offset % 8, 0U);
  const std::size_t padding = static_cast<std::size_t>(container->entries()[1].offset) - 1;
  stream[padding] = std::byte{1};
  EXPECT_EQ(open_rule(stream), "CNT-3");
}

TEST(Container, CNT4RejectsBytesAfterTheLastChunk) {
  auto stream = sample_stream();
  stream.push_back(std::byte{0});
  EXPECT_EQ(open_rule(stream), "CNT-4");
}

TEST(Container, CNT5BoundsTheCountsByTheLength) {
  FileHeader header = sample_header();
  header.vertices = header.geometric_vertices = header.triangles = 10'000'000;
  const auto stream = write_container(header, {});
  EXPECT_GE(stream.size() * 2048, std::size_t{20'000'000}) << "the writer fills up";
  EXPECT_EQ(open_rule(stream), "none");
  EXPECT_EQ(open_rule(std::span(stream).first(5000)), "CNT-5");
}

TEST(Container, DIR2RejectsUnknownChunksUnlessSkippable) {
  EXPECT_EQ(
      open_rule(write_container(sample_header(), std::vector{chunk(chunk_tag("NEWS"), bytes_of(5, 1))})),
      "DIR-2");
  EXPECT_EQ(
      open_rule(write_container(sample_header(), std::vector{chunk(chunk_tag("NEWs"), bytes_of(5, 1))})),
      "none");
}

TEST(Container, DIR5BoundsAPayloadByTheHeadersCounts) {
  const auto stream = sample_stream();
  EXPECT_STREQ(expand_single(*Container::open(stream), kTagDeltas, 499).error().rule, "DIR-5");
}

TEST(Container, DIR6ChecksumCoversEveryChunk) {
  auto stream = sample_stream();
  stream.back() ^= std::byte{1};
  const auto container = Container::open(stream);
  ASSERT_TRUE(container);
  const auto result = expand_single(*container, kTagDeltas, 1000);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kCorrupt);
  EXPECT_STREQ(result.error().rule, "DIR-6");
  EXPECT_EQ(result.error().where, container->entries()[1].offset);
  EXPECT_STREQ(inspect(stream).error().rule, "DIR-6");
}

TEST(Container, DIR7RejectsAChunkBeyondTheEnd) {
  const auto stream = sample_stream();
  EXPECT_EQ(open_rule(std::span(stream).first(stream.size() - 1)), "DIR-7");
}

TEST(Container, DIR8RejectsASecondChunkOfASingleKind) {
  const auto stream = write_container(
      sample_header(), std::vector{chunk(kTagDeltas, bytes_of(5, 1)), chunk(kTagDeltas, bytes_of(5, 2))});
  EXPECT_STREQ(expand_single(*Container::open(stream), kTagDeltas, 1000).error().rule, "DIR-8");
}

TEST(Container, ENT1RejectsAFrameThatDoesNotFit) {
  CodedChunk lying = chunk(kTagDeltas, std::vector<std::byte>(500));
  lying.decoded_bytes = 501;
  CodedChunk garbage{
      .tag = kTagAnchors, .codec = ChunkCodec::kZstd, .bytes = bytes_of(9, 3), .decoded_bytes = 20};
  CodedChunk twice = chunk(kTagConnectivity, std::vector<std::byte>(250));
  twice.bytes.insert(twice.bytes.end(), twice.bytes.begin(), twice.bytes.end());
  twice.decoded_bytes = 500;
  const auto stream = write_container(sample_header(), std::vector{lying, garbage, twice});
  const auto container = Container::open(stream);
  ASSERT_TRUE(container);
  for (const std::uint32_t tag : {kTagDeltas, kTagAnchors, kTagConnectivity})
    EXPECT_STREQ(expand_single(*container, tag, 1000).error().rule, "ENT-1");
}

TEST(Container, EveryPrefixFails) {
  const auto stream = sample_stream();
  for (std::size_t size = 0; size < stream.size(); ++size)
    EXPECT_NE(open_rule(std::span(stream).first(size)), "none");
}

TEST(Inspect, AddsUpTheSizes) {
  const auto stream = sample_stream();
  const auto info = inspect(stream);
  ASSERT_TRUE(info);
  EXPECT_EQ(info->bytes, stream.size());
  EXPECT_EQ(info->connectivity_bytes, 13U);
  EXPECT_EQ(info->connectivity_bytes + info->geometry_bytes + info->anchor_bytes + info->attribute_bytes +
                info->container_bytes,
            info->bytes);
  EXPECT_STREQ(info->chunks[0].tag.data(), "CONN");
}

}  // namespace
}  // namespace deltamesh
