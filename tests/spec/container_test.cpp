// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/container.h"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <algorithm>
#include <initializer_list>

#include "deltamesh/stream_info.h"
#include "entropy/code_chunk.h"
#include "entropy/expand_chunk.h"

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
  return code_plain_chunk(tag, std::move(payload));
}

std::vector<std::byte> sample_stream() {
  return write_container(sample_header(), std::vector{chunk(kTagConnectivity, bytes_of(13, 1)),
                                                      chunk(kTagDeltas, std::vector<std::byte>(500))});
}

/// The sample with `bytes` behind its last chunk, and a checksum that is right.
std::vector<std::byte> with_more_bytes(std::initializer_list<unsigned> bytes) {
  auto stream = sample_stream();
  stream.resize(stream.size() - 4);
  for (const unsigned byte : bytes) stream.push_back(static_cast<std::byte>(byte));
  ByteWriter checksum;
  checksum.write(static_cast<std::uint32_t>(XXH3_64bits(stream.data(), stream.size())));
  stream.insert(stream.end(), checksum.bytes().begin(), checksum.bytes().end());
  return stream;
}

std::string open_rule(std::span<const std::byte> stream) {
  const auto result = Container::open(stream);
  return result ? "none" : result.error().rule;
}

TEST(Container, CNT1HoldsHeaderChunksAndChecksum) {
  const auto stream = sample_stream();
  const auto container = Container::open(stream);
  ASSERT_TRUE(container);
  ASSERT_EQ(container->entries().size(), 2U);
  EXPECT_EQ(container->entries()[0].codec, ChunkCodec::kRaw) << "random bytes do not shrink";
  EXPECT_EQ(container->entries()[1].codec, ChunkCodec::kZstd);
  const auto raw = expand_single(*container, kTagConnectivity);
  EXPECT_TRUE(std::ranges::equal(raw->bytes(), bytes_of(13, 1)));
  const auto expanded = expand_single(*container, kTagDeltas);
  EXPECT_TRUE(std::ranges::equal(expanded->bytes(), std::vector<std::byte>(500)));
  EXPECT_TRUE(expand_single(*container, kTagAnchors)->bytes().empty());
}

TEST(Container, CNT2ChecksumCoversEveryByte) {
  const auto clean = sample_stream();
  for (std::size_t i = 0; i < clean.size(); ++i) {
    auto stream = clean;
    stream[i] ^= std::byte{1};
    const auto result = Container::open(stream);
    ASSERT_FALSE(result) << "byte " << i;
    EXPECT_FALSE(inspect(stream)) << "byte " << i;
    if (i <= 3) continue;  // magic and version are asked before
    EXPECT_EQ(result.error().code, ErrorCode::kCorrupt) << "byte " << i;
    EXPECT_STREQ(result.error().rule, "CNT-2") << "byte " << i;
  }
}

TEST(Container, CNT4ChunksEndAtTheChecksum) {
  EXPECT_EQ(open_rule(with_more_bytes({0x01})), "CON-1") << "a chunk without a length";
  EXPECT_EQ(open_rule(with_more_bytes({0x03, 0})), "none") << "an empty chunk";
  EXPECT_EQ(open_rule(with_more_bytes({0x01, 1})), "DIR-7") << "a chunk without its byte";
}

TEST(Container, CNT5BoundsTheCountsByTheLength) {
  FileHeader header = sample_header();
  header.vertices = header.geometric_vertices = header.triangles = 10'000'000;
  const auto stream = write_container(header, {});
  EXPECT_GE(stream.size() * 2048, std::size_t{20'000'000}) << "the writer fills up";
  EXPECT_EQ(open_rule(stream), "none");
  EXPECT_EQ(stream_bytes(header, 0), stream.size());
  auto shorter = std::vector(stream.begin(), stream.begin() + 5000);
  ByteWriter checksum;
  checksum.write(static_cast<std::uint32_t>(XXH3_64bits(shorter.data(), shorter.size())));
  shorter.insert(shorter.end(), checksum.bytes().begin(), checksum.bytes().end());
  EXPECT_EQ(open_rule(shorter), "CNT-5");
}

TEST(Container, DIR2RejectsUnknownChunksUnlessSkippable) {
  EXPECT_EQ(
      open_rule(write_container(sample_header(), std::vector{chunk(chunk_tag("NEWS"), bytes_of(5, 1))})),
      "DIR-2");
  EXPECT_EQ(
      open_rule(write_container(sample_header(), std::vector{chunk(chunk_tag("NEWs"), bytes_of(5, 1))})),
      "none");
}

TEST(Container, DIR7RejectsAChunkBeyondTheEnd) {
  EXPECT_EQ(open_rule(with_more_bytes({0x01, 5, 1, 2, 3, 4})), "DIR-7");
}

TEST(Container, DIR5BoundsAPayloadByTheHeadersCounts) {
  const std::size_t most = 1024 + 160 * 8;
  for (const std::uint32_t tag :
       {kTagDeltas, kTagPositions, kTagOrder, kTagGrid}) {  // the last three mean nothing here
    const auto of_size = [tag](std::size_t size) {
      return write_container(sample_header(), std::vector{chunk(tag, std::vector<std::byte>(size))});
    };
    EXPECT_EQ(open_rule(of_size(most)), "none");
    EXPECT_EQ(open_rule(of_size(most + 1)), "DIR-5");
  }
  EXPECT_EQ(
      open_rule(write_container(sample_header(), std::vector{chunk(kTagFiller, bytes_of(most + 1, 1))})),
      "none");
}

TEST(Container, DIR1RejectsMoreThan65536Chunks) {
  std::vector<CodedChunk> chunks(kMaxChunks, chunk(kTagFiller, {}));
  EXPECT_EQ(open_rule(write_container(sample_header(), chunks)), "none");
  chunks.push_back(chunks.front());
  EXPECT_EQ(open_rule(write_container(sample_header(), chunks)), "DIR-1");
}

TEST(Container, DIR8RejectsASecondChunkOfASingleKind) {
  const auto twice = [](std::uint32_t tag) {
    return write_container(sample_header(),
                           std::vector{chunk(tag, bytes_of(5, 1)), chunk(kTagConnectivity, bytes_of(5, 1)),
                                       chunk(tag, bytes_of(5, 2))});
  };
  for (const std::uint32_t tag :
       {kTagDeltas, kTagPositions, kTagOrder, kTagGrid})  // the last three mean nothing here
    EXPECT_EQ(open_rule(twice(tag)), "DIR-8");
  for (const std::uint32_t tag : {kTagAttribute, kTagFiller}) EXPECT_EQ(open_rule(twice(tag)), "none");
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
    EXPECT_STREQ(expand_single(*container, tag).error().rule, "ENT-1");
}

TEST(Container, EveryPrefixFails) {
  const auto stream = sample_stream();
  for (std::size_t size = 0; size < stream.size(); ++size)
    EXPECT_NE(open_rule(std::span(stream).first(size)), "none");
}

TEST(Container, SizesAreKnownBeforehand) {
  std::vector<CodedChunk> chunks{
      chunk(kTagConnectivity, bytes_of(200, 1)), chunk(kTagDeltas, std::vector<std::byte>(500)),
      chunk(kTagAttribute, bytes_of(20, 2)), chunk(kTagAttribute, {}), chunk(kTagFiller, bytes_of(3, 3))};
  chunks[2].attribute = {.kind = AttributeKind::kNormal, .components = 3, .name = "NORMAL", .error = 0.5F};
  const auto stream = write_container(sample_header(), chunks);
  std::uint64_t bytes = 0;
  for (const CodedChunk& stored : chunks) bytes += stored_bytes(stored);
  EXPECT_EQ(stream_bytes(sample_header(), bytes), stream.size());
  const auto container = Container::open(stream);
  EXPECT_EQ(container->header().attributes, std::vector({chunks[2].attribute, chunks[3].attribute}));
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
