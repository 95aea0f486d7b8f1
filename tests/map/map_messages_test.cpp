// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Entry, part and view messages.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "deltamesh/map/messages.h"
#include "deltamesh/map/part.h"
#include "message/frame.h"

namespace deltamesh {
namespace {

using Bytes = std::vector<std::byte>;

PartEntry example_entry() {
  PartEntry entry{.key = {1, -3, 4, 0}, .revision = 300, .group = 17, .bytes = 4000};
  entry.links = {
      {{0, 5, 5, 5}, 0x12345678, true, 0}, {{1, -4, 4, 0}, 0, false, 299}, {{1, -3, 5, 1}, 9, true, 1000}};
  entry.hash = 0x0123456789abcdef;
  entry.vertices = 300;
  entry.triangles = 500;
  entry.box_min = {-1, -2, -3};
  entry.box_max = {1, 2, 3};
  entry.quality = {.vde_rms = 0.25, .lfe_rms = 0.5, .max_error = 0.75};
  entry.attribute_errors = {3.5F, 0};
  return entry;
}

PartMessage example_part() {
  const PartEntry entry = example_entry();
  PartMessage part{.map = 5, .number = 3, .key = entry.key, .revision = 9, .group = 1, .links = entry.links};
  part.octets.assign(20, std::byte{7});
  return part;
}

ViewMessage example_view() {
  ViewMessage message{.viewer = 4, .number = 1000, .map_id = 6, .map = 7, .start = 8};
  message.receipt = {.highest = 30, .missing = {5, 29}};
  message.view.boxes = {{{-1, -1, -1}, {1, 2, 3}}, {}};
  message.view.level = 2;
  message.view.vde = 0.5F;
  message.view.max_error = 0.125F;
  message.view.attribute_errors = {0, 0.25F};
  message.view.color_error = 4;
  message.view.bytes_per_second = 100000;
  message.held = {{{0, 1, 2, 3}, 5, 77, true}, {{2, -9, 2, 3}, 500, 78, false}};
  return message;
}

/// Shorter, longer and damaged messages are errors.
void expect_every_damage_found(const Bytes& message, const std::function<bool(const Bytes&)>& reads) {
  ASSERT_TRUE(reads(message));
  for (std::size_t size = 0; size < message.size(); ++size)
    EXPECT_FALSE(reads(Bytes(message.begin(), message.begin() + static_cast<std::ptrdiff_t>(size)))) << size;
  for (std::size_t i = 0; i < message.size(); ++i) {
    Bytes damaged = message;
    damaged[i] ^= std::byte{16};
    EXPECT_FALSE(reads(damaged)) << i;
  }
  Bytes longer = message;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(reads(longer));
}

TEST(MapMessages, MAP13EntriesComeBack) {
  const auto bytes = write_entry({.map = 99, .entry = example_entry()});
  ASSERT_TRUE(bytes);
  const auto back = read_entry(*bytes, 2);
  ASSERT_TRUE(back) << describe(back.error());
  EXPECT_EQ(back->map, 99U);
  EXPECT_EQ(back->entry, example_entry());
  EXPECT_FALSE(read_entry(*bytes, 1));
  EXPECT_FALSE(read_entry(*bytes, 3));
  expect_every_damage_found(*bytes, [](const Bytes& b) { return bool{read_entry(b, 2)}; });
  PartEntry gone{.key = {0, 1, 2, 3}, .revision = 4};
  const auto removal = write_entry({.entry = gone});
  ASSERT_TRUE(removal);
  EXPECT_EQ(read_entry(*removal, 200)->entry, gone);
}

TEST(MapMessages, MAP14PartsComeBack) {
  const auto bytes = write_part(example_part());
  ASSERT_TRUE(bytes);
  const auto back = read_part(*bytes);
  ASSERT_TRUE(back) << describe(back.error());
  EXPECT_EQ(back->map, 5U);
  EXPECT_EQ(back->key, example_part().key);
  EXPECT_EQ(back->revision, 9U);
  EXPECT_EQ(back->group, 1U);
  EXPECT_EQ(back->links, example_part().links);
  EXPECT_EQ(back->octets, example_part().octets);
  expect_every_damage_found(*bytes, [](const Bytes& b) { return bool{read_part(b)}; });
  PartMessage empty = example_part();
  empty.octets.clear();
  EXPECT_STREQ(write_part(empty).error().rule, "MAP-14");
  empty.octets.resize(kMostPartBytes + 1);
  EXPECT_STREQ(write_part(empty).error().rule, "MAP-14");
}

TEST(MapMessages, MAP18PatchesComeBackWithTheirBase) {
  const PartKey own = example_part().key;
  std::vector<std::size_t> sizes;
  for (const PartKey& base : {own, PartKey{own.level, own.x - 1, own.y, own.z + 1},
                              PartKey{static_cast<std::uint8_t>(own.level + 1), own.x, 0, 0}}) {
    PatchMessage patch{.part = example_part(), .base_key = base, .body = {std::byte{5}}};
    patch.part.octets.clear();
    const auto bytes = write_patch(patch);
    ASSERT_TRUE(bytes);
    sizes.push_back(bytes->size());
    const auto back = read_patch(*bytes);
    ASSERT_TRUE(back) << describe(back.error());
    EXPECT_EQ(back->part.key, own);
    EXPECT_EQ(back->part.links, patch.part.links);
    EXPECT_EQ(back->base_key, base);
    EXPECT_EQ(back->body, patch.body);
    expect_every_damage_found(*bytes, [](const Bytes& b) { return bool{read_patch(b)}; });
    // A mark, which means nothing there: its byte is before the body and the checksum.
    if (base != own) continue;
    ByteWriter out;
    out.write_bytes(std::span(*bytes).first(bytes->size() - 6));
    out.write(std::uint8_t{13 + 32});
    out.write_bytes(std::span(*bytes).subspan(bytes->size() - 5, 1));
    const auto marked = read_patch(end_message(std::move(out)));
    ASSERT_FALSE(marked);
    EXPECT_STREQ(marked.error().rule, "MAP-18");
  }
  EXPECT_EQ(sizes[0], sizes[1]);
  EXPECT_LT(sizes[1], sizes[2]);
}

TEST(MapMessages, MAP16StartsComeBack) {
  const auto bytes = write_start({.map = 3, .start = 300, .number = 7});
  ASSERT_TRUE(bytes);
  EXPECT_EQ(read_start(*bytes)->map, 3U);
  EXPECT_EQ(read_start(*bytes)->start, 300U);
  EXPECT_EQ(read_start(*bytes)->number, 7U);
  expect_every_damage_found(*bytes, [](const Bytes& b) { return bool{read_start(b)}; });
}

TEST(MapMessages, MAP15ViewsComeBack) {
  const auto bytes = write_view(example_view());
  ASSERT_TRUE(bytes);
  const auto back = read_view(*bytes);
  ASSERT_TRUE(back) << describe(back.error());
  EXPECT_EQ(*back, example_view());
  expect_every_damage_found(*bytes, [](const Bytes& b) { return bool{read_view(b)}; });
  ViewMessage mean = example_view();
  mean.view.color_error.reset();
  EXPECT_EQ(*read_view(*write_view(mean)), mean);
  mean.view.color_rms = 2.5F;
  EXPECT_EQ(*read_view(*write_view(mean)), mean);
}

TEST(MapMessages, MAP12LinksAreChecked) {
  const auto rule_of = [](const std::function<void(PartMessage&)>& change) {
    PartMessage part = example_part();
    change(part);
    const auto written = write_part(part);
    return written ? std::string() : std::string(written.error().rule);
  };
  EXPECT_EQ(rule_of([](PartMessage&) {}), "");
  EXPECT_EQ(rule_of([](PartMessage& p) { p.links[1].key = p.key; }), "MAP-12");
  EXPECT_EQ(rule_of([](PartMessage& p) { p.links[1].key = p.links[0].key; }), "MAP-12");
  EXPECT_EQ(rule_of([](PartMessage& p) { p.links[2].key.level = 25; }), "MAP-12");
  EXPECT_EQ(rule_of([](PartMessage& p) { p.key.level = 25; }), "MAP-3");
  EXPECT_EQ(rule_of([](PartMessage& p) {
              p.links.clear();
              for (std::int32_t i = 0; i < 4097; ++i) p.links.push_back({{0, i, 0, 0}, 1, false, 0});
            }),
            "MAP-12");
}

TEST(MapMessages, MAP13MAP15RangesAreChecked) {
  PartEntry entry = example_entry();
  entry.box_min[0] = 2;
  EXPECT_STREQ(write_entry({.entry = entry}).error().rule, "MAP-13");
  entry = example_entry();
  entry.quality.max_error = -1;
  EXPECT_STREQ(write_entry({.entry = entry}).error().rule, "MAP-13");
  entry = example_entry();
  entry.bytes = kMostPartBytes + 1;
  EXPECT_STREQ(write_entry({.entry = entry}).error().rule, "MAP-7");
  const auto rule_of = [](const std::function<void(ViewMessage&)>& change) {
    ViewMessage message = example_view();
    change(message);
    const auto written = write_view(message);
    return written ? std::string() : std::string(written.error().rule);
  };
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.vde = -1.0F; }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.lfe = std::nanf(""); }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.color_error = -1; }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.color_rms = 1; }), "MAP-15");  // and a largest error
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.color_error.reset(), m.view.color_rms = 0; }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.attribute_errors = {0, -1}; }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.attribute_errors.resize(256); }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.level = 25; }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.receipt.missing = {30}; }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.boxes.resize(65); }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { m.view.boxes[0].high[1] = -2; }), "MAP-15");
  EXPECT_EQ(rule_of([](ViewMessage& m) { std::swap(m.held[0], m.held[1]); }), "MAP-15");
}

TEST(MapMessages, MAP12FiguresAreRoundedUpAndVersionsAreToldApart) {
  PartEntry entry = example_entry();
  entry.quality.max_error = 0.1;
  const auto bytes = write_entry({.entry = entry});
  ASSERT_TRUE(bytes);
  EXPECT_GE(read_entry(*bytes, 2)->entry.quality.max_error, 0.1);
  auto links = entry.links;
  const std::uint32_t version = version_hash(1, links);
  EXPECT_NE(version, version_hash(2, links));
  links[0].together = false;
  EXPECT_EQ(version, version_hash(1, links));
  links[0].border = 3;
  EXPECT_NE(version, version_hash(1, links));
}

}  // namespace
}  // namespace deltamesh
