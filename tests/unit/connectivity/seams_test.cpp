// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/seams/seams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/byte_writer.h"
#include "connectivity/seams/coder.h"
#include "entropy/coder/writer.h"
#include "entropy/planes.h"
#include "support/soups.h"

namespace deltamesh::seams_test {
namespace {

using test::Indices;
using test::Random;

/// Geometric faces, and what the corners use.
struct Case {
  std::string name;
  Indices triangles;
  std::uint32_t geometric_count = 0;
  Indices corners;
  Indices lone;
};

/// Splits a soup: every corner takes one of up to `copies` input vertices of its geometric vertex, a new one
/// about once in `rarity` corners; input vertices are numbered backwards from 10 000.
Case split_case(const test::Soup& soup, std::uint32_t copies, std::uint32_t rarity, std::uint32_t seed) {
  Random random(seed);
  Case result{soup.name, soup.triangles, 0, {}, {}};
  // Unused vertices last, as connectivity leaves them.
  Indices number(soup.vertex_count, 0xffffffff);
  for (std::uint32_t& v : result.triangles) {
    if (number[v] == 0xffffffff) number[v] = result.geometric_count++;
    v = number[v];
  }
  std::vector<Indices> inputs(result.geometric_count);
  std::uint32_t next_input = 10000;
  for (const std::uint32_t g : result.triangles) {
    const bool fresh = inputs[g].empty() || (inputs[g].size() < copies && random.below(rarity) == 0);
    if (fresh) inputs[g].push_back(next_input--);
    const auto pick =
        fresh ? inputs[g].size() - 1 : random.below(static_cast<std::uint32_t>(inputs[g].size()));
    result.corners.push_back(inputs[g][pick]);
  }
  for (const std::uint32_t v : number) {
    if (v != 0xffffffff) continue;
    result.lone.push_back(next_input--);
    ++result.geometric_count;
  }
  return result;
}

std::vector<Case> cases() {
  std::vector<Case> result;
  std::uint32_t seed = 0;
  for (const test::Soup& soup : test::awkward_soups()) {
    const std::uint32_t copies = 1 + seed % 5;
    result.push_back(split_case(soup, copies, 1 + seed % 7, seed));
    ++seed;
  }
  return result;
}

CodedSeams write(const Case& c) { return write_seams(c.triangles, c.geometric_count, c.corners, c.lone); }

/// Reads from a copy, so that a sanitizer sees the bounds.
Result<SplitVertices> read(Payload payload, const Case& c, std::size_t vertex_count) {
  const std::vector<std::byte> copy(payload.bytes.begin(), payload.bytes.end());
  payload.bytes = copy;
  return read_seams(payload, c.triangles, c.geometric_count, static_cast<std::uint32_t>(vertex_count));
}

/// Both forms of what was written; none where nothing is split.
struct Form {
  std::vector<std::byte> bytes;
  bool is_compact;

  Payload payload(std::size_t size) const {
    Payload payload(std::span<const std::byte>(bytes).first(size));
    payload.is_compact = is_compact;
    return payload;
  }
};
std::vector<Form> forms(const CodedSeams& coded) {
  if (coded.payload.empty()) return {};
  return {{coded.payload, false}, {coded.compact, true}};
}

TEST(Seams, SEAM5RoundTripsNumberedByGeometricVertex) {
  for (const Case& c : cases()) {
    const CodedSeams coded = write(c);
    ASSERT_EQ(coded.split.triangles.size(), c.triangles.size());
    ASSERT_EQ(coded.vertex_order.size(), coded.split.geometric.size());
    EXPECT_TRUE(std::is_sorted(coded.split.geometric.begin(), coded.split.geometric.end()));
    for (std::size_t k = 0; k < c.corners.size(); ++k) {
      EXPECT_EQ(coded.vertex_order[coded.split.triangles[k]], c.corners[k]) << c.name;
      EXPECT_EQ(coded.split.geometric[coded.split.triangles[k]], c.triangles[k]) << c.name;
    }
    EXPECT_TRUE(std::equal(c.lone.begin(), c.lone.end(), coded.vertex_order.end() - std::ssize(c.lone)));
    EXPECT_EQ(coded.payload.empty(), coded.compact.empty());
    for (const Form& form : forms(coded)) {
      const auto split = read(form.payload(form.bytes.size()), c, coded.vertex_order.size());
      ASSERT_TRUE(split) << c.name << ": " << describe(split.error());
      EXPECT_EQ(split->triangles, coded.split.triangles) << c.name;
      EXPECT_EQ(split->geometric, coded.split.geometric) << c.name;
    }
  }
}

TEST(Seams, SEAM7KnowsASeamFromOneEndOfAnEdge) {
  // Two sheets sewn along a straight line: after its first corners every choice follows from the edges.
  Case c{"two_sheets", test::grid(40, 40, false, false, 0, 1).triangles, 41 * 41, {}, {}};
  for (std::size_t f = 0; f < c.triangles.size(); f += 3) {
    const auto column = [&](std::size_t k) { return c.triangles[f + k] % 41; };
    const bool right = std::max({column(0), column(1), column(2)}) > 20;
    for (std::size_t k = 0; k < 3; ++k) c.corners.push_back(c.triangles[f + k] + (right ? 41 * 41 : 0));
  }
  const CodedSeams coded = write(c);
  ASSERT_EQ(coded.split.geometric.size(), 41 * 41 + 41);
  EXPECT_LT(coded.compact.size() * 4, coded.payload.size());
}

TEST(Seams, SEAM1NoBytesWhereNothingIsSplit) {
  const Case c = split_case(test::grid(5, 5, false, false, 0, 1), 1, 1, 1);
  EXPECT_TRUE(write(c).payload.empty());
  EXPECT_TRUE(read({}, c, c.geometric_count));
  EXPECT_FALSE(read({}, c, c.geometric_count + 1));
  EXPECT_FALSE(read({}, c, c.geometric_count - 1));
  EXPECT_FALSE(read(std::vector<std::byte>(4), c, c.geometric_count));
}

TEST(Seams, EveryPrefixAndExtensionFails) {
  for (const Case& c : cases()) {
    if (c.triangles.size() > 400) continue;
    const CodedSeams coded = write(c);
    for (Form form : forms(coded)) {
      for (std::size_t size = 0; size < form.bytes.size(); ++size)
        EXPECT_FALSE(read(form.payload(size), c, coded.vertex_order.size()));
      form.bytes.push_back(std::byte{0});
      EXPECT_FALSE(read(form.payload(form.bytes.size()), c, coded.vertex_order.size()));
    }
  }
}

void expect_valid(const SplitVertices& split, const Case& c, std::size_t vertex_count) {
  ASSERT_EQ(split.geometric.size(), vertex_count);
  for (std::size_t k = 0; k < c.triangles.size(); ++k) {
    ASSERT_LT(split.triangles[k], split.geometric.size());
    ASSERT_EQ(split.geometric[split.triangles[k]], c.triangles[k]);
  }
}

TEST(Seams, FlippedBytesGiveAnErrorOrValidFaces) {
  for (const Case& c : cases()) {
    if (c.triangles.size() > 400) continue;
    const CodedSeams coded = write(c);
    for (Form form : forms(coded)) {
      for (std::byte& byte : form.bytes) {
        for (const std::byte flip : {std::byte{1}, std::byte{2}, std::byte{0x80}, std::byte{0xff}}) {
          byte ^= flip;
          const auto split = read(form.payload(form.bytes.size()), c, coded.vertex_order.size());
          byte ^= flip;
          if (split) expect_valid(*split, c, coded.vertex_order.size());
        }
      }
    }
  }
}

/// Three faces around geometric vertex 0.
constexpr std::uint32_t kGeometric = 5;
const Indices kFan = {0, 1, 2, 0, 2, 3, 0, 3, 4};

/// `rule`: that is broken; null for none.
void expect_broken(const Result<SplitVertices>& split, const char* rule) {
  if (rule == nullptr) {
    EXPECT_TRUE(split) << describe(split.error());
  } else {
    ASSERT_FALSE(split);
    EXPECT_STREQ(split.error().rule, rule) << describe(split.error());
  }
}

void expect_rule(std::uint64_t count, const Indices& gaps, const Indices& extra, const Indices& choices,
                 std::uint32_t vertex_count, const char* rule) {
  ByteWriter out;
  out.write_varint(count);
  write_planes(out, gaps);
  write_planes(out, extra);
  write_planes(out, choices);
  expect_broken(read_seams(out.bytes(), kFan, kGeometric, vertex_count), rule);
}

TEST(Seams, SEAM2RejectsSplitVerticesOutOfRange) {
  expect_rule(1, {0}, {0}, {1, 0}, 6, nullptr);
  expect_rule(0, {}, {}, {}, 6, "SEAM-2");
  expect_rule(6, {0, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 0}, {}, 11, "SEAM-2");
  expect_rule(2, {0, 0}, {0, 0}, {}, 6, "SEAM-2");  // two split vertices, one more vertex
  expect_rule(1, {5}, {0}, {1}, 6, "SEAM-2");
}

TEST(Seams, SEAM3RejectsCopiesThatDoNotAddUp) {
  expect_rule(1, {0}, {1}, {1, 1}, 7, nullptr);
  expect_rule(1, {0}, {1}, {1, 1}, 6, "SEAM-3");
  expect_rule(1, {0}, {0}, {1, 0}, 7, "SEAM-3");
  expect_rule(1, {0}, {2}, {1, 1}, 8, "SEAM-3");  // four copies, three corners
  expect_rule(1, {1}, {0}, {}, 6, "SEAM-3");      // two copies, one corner
}

TEST(Seams, SEAM4RejectsChoicesOfNoCopy) {
  expect_rule(1, {0}, {0}, {1, 1}, 6, "SEAM-4");  // a third of two
  expect_rule(1, {0}, {0}, {0, 0}, 6, "SEAM-4");  // the second is never used
  expect_rule(1, {0}, {0}, {4, 1}, 6, "SEAM-4");  // copy 1 by name before its first use
  expect_rule(1, {0}, {0}, {1, 3}, 6, nullptr);   // copy 0 by name
  expect_rule(1, {0}, {0}, {1, 2}, 6, nullptr);   // copy 0 as the other one
}

/// The compact form that a writer makes of `counts` (per geometric vertex) and `copies` (per corner).
std::vector<std::byte> compact_form(const Indices& counts, const Indices& copies,
                                    std::uint32_t extra_copies) {
  CompactWriter writer;
  SeamCoder<CompactWriter> coder(writer, kGeometric, extra_copies);
  CornerCopies all{counts, copies};
  coder.code(kFan, all);
  return writer.finish();
}

void expect_compact_rule(const Indices& counts, const Indices& copies, std::uint32_t vertex_count,
                         const char* rule) {
  const std::vector<std::byte> bytes = compact_form(counts, copies, 100);
  expect_broken(read_seams(Payload::compact(bytes), kFan, kGeometric, vertex_count), rule);
}

TEST(Seams, SEAM6RejectsCountsThatDoNotAddUp) {
  expect_compact_rule({2, 1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 1, 0, 0}, 6, nullptr);
  expect_compact_rule({2, 1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 1, 0, 0}, 7, "SEAM-6");   // one too few
  expect_compact_rule({3, 1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 2, 0, 0}, 6, "SEAM-6");   // one too many
  expect_compact_rule({90, 1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 2, 0, 0}, 7, "SEAM-6");  // by a long number
  expect_compact_rule({2, 1, 1, 1, 1}, {0, 0, 0, 1, 0, 0, 1, 0, 0}, 15, "SEAM-6");  // more than corners

  // 2^32 + 1 more copies are not one more.
  CompactWriter writer;
  SymbolModel counts{{60, 10, 3, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
  NumberModel large;
  writer.symbol(15, Mixture<1>{{&counts}});
  writer.number(0xfffffff2, large);
  const std::vector<std::byte> bytes = writer.finish();
  expect_broken(read_seams(Payload::compact(bytes), kFan, kGeometric, 6), "SEAM-6");
}

TEST(Seams, SEAM8RejectsCopiesThatAreNotThere) {
  expect_compact_rule({2, 1, 1, 1, 1}, {0, 0, 0, 0, 0, 0, 0, 0, 0}, 6, "SEAM-8");  // copy 1 never used
  expect_compact_rule({2, 1, 1, 1, 1}, {0, 0, 0, 2, 0, 0, 1, 0, 0}, 6, "SEAM-8");  // before copy 1
  expect_compact_rule({2, 1, 1, 1, 1}, {0, 0, 0, 40, 0, 0, 1, 0, 0}, 6, "SEAM-8");
}

}  // namespace
}  // namespace deltamesh::seams_test
