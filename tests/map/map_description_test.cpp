// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The map's message and its lattice.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "deltamesh/map/description.h"
#include "deltamesh/map/part_key.h"
#include "message/frame.h"

namespace deltamesh {
namespace {

MapDescription example() {
  MapDescription description{.id = 0x123456789abcdef0, .epoch = 3, .frame = "odom"};
  description.lattice = {.origin = {1, -2.5, 1e6}, .step_exponent = -10};
  description.cell_steps = 1000;
  description.cell_origin = {-3, 100, 0};
  description.grid = VoxelGrid{{0.5, 0, -7}, {0.05, 0.05, 0.1}};
  description.attributes = {{AttributeKind::kColor, ComponentType::kU8, 3, true, "red"},
                            {AttributeKind::kGeneric, ComponentType::kF32, 2, false, "confidence"}};
  description.primers = {{{std::byte{1}, std::byte{2}, std::byte{3}}, {std::byte{4}}}};
  return description;
}

TEST(MapDescription, MAP5RoundTrip) {
  const auto message = write_description(example());
  ASSERT_TRUE(message);
  EXPECT_EQ(message->size(), 131U);
  const auto back = read_description(*message);
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, example());
  EXPECT_EQ(hash_of(*back), hash_of(example()));
}

TEST(MapDescription, MAP1EveryDamageIsAnError) {
  const auto message = write_description(example());
  ASSERT_TRUE(message);
  for (std::size_t size = 0; size < message->size(); ++size)
    EXPECT_FALSE(read_description(std::span(*message).first(size))) << size;
  for (std::size_t i = 0; i < message->size(); ++i) {
    auto damaged = *message;
    damaged[i] ^= std::byte{4};
    EXPECT_FALSE(read_description(damaged)) << i;
  }
  auto longer = *message;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(read_description(longer));
  auto other = *message;
  other[0] = std::byte{'X'};
  EXPECT_EQ(read_description(other).error().code, ErrorCode::kBadMagic);
  EXPECT_STREQ(read_description(other).error().rule, "MAP-1");
}

TEST(MapDescription, MAP5DescriptorsAreAsShortAsCanBe) {
  const auto message = write_description(example());
  constexpr std::size_t kFirstDescriptor = 103;
  const auto with_descriptor = [&](std::vector<std::byte> descriptor) {
    const std::span whole(*message);
    ByteWriter out;
    out.write_bytes(whole.first(kFirstDescriptor));
    out.write_bytes(descriptor);
    out.write_bytes(whole.subspan(kFirstDescriptor + 1, whole.size() - kFirstDescriptor - 5));
    return read_description(end_message(std::move(out)));
  };
  const std::byte row = (*message)[kFirstDescriptor];
  EXPECT_EQ(*with_descriptor({row}), example());
  const std::byte zero{0};
  const auto with_error = with_descriptor({row | std::byte{0x80}, zero, zero, zero});
  const auto spelled_out =
      with_descriptor({zero, std::byte{static_cast<unsigned char>(AttributeKind::kColor)},
                       std::byte{static_cast<unsigned char>(ComponentType::kU8)}, std::byte{3}, std::byte{1},
                       std::byte{3}, std::byte{'r'}, std::byte{'e'}, std::byte{'d'}});
  for (const auto* longer : {&with_error, &spelled_out}) {
    ASSERT_FALSE(*longer);
    EXPECT_STREQ(longer->error().rule, "MAP-5");
  }
}

TEST(MapDescription, MAP2MAP3MAP6RangesAreChecked) {
  const auto rule_of = [](const MapDescription& description) {
    const auto result = write_description(description);
    return result ? std::string() : std::string(result.error().rule);
  };
  MapDescription description = example();
  description.lattice.origin[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rule_of(description), "MAP-2");
  description = example();
  description.lattice.step_exponent = 21;
  EXPECT_EQ(rule_of(description), "MAP-2");
  description = example();
  description.cell_steps = 0;
  EXPECT_EQ(rule_of(description), "MAP-3");
  description = example();
  description.cell_origin[2] = 1 << 24;
  EXPECT_EQ(rule_of(description), "MAP-3");
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    description = example();
    description.grid->edge[2] = bad;
    EXPECT_EQ(rule_of(description), "MAP-5") << bad;
  }
  description = example();
  description.grid->origin[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(rule_of(description), "MAP-5");
  description = example();
  description.attributes[0].components = 17;
  EXPECT_EQ(rule_of(description), "MAP-5");
  description = example();
  description.primers[0].border.resize(kMostPrimerBytes);
  EXPECT_EQ(rule_of(description), "MAP-6");
  description.primers = std::vector<MapPrimer>(1);
  EXPECT_EQ(rule_of(description), "MAP-6");
}

TEST(MapLattice, MAP2NearestPointTiesUpwards) {
  const MapLattice lattice{.step_exponent = -2};
  EXPECT_EQ(lattice.nearest({0.125F, -0.125F, 0.124F}), (LatticePoint{1, 0, 0}));
  EXPECT_EQ(lattice.position_of({1, -3, 0}), (std::array<float, 3>{0.25F, -0.75F, 0}));
  EXPECT_TRUE(lattice.is_within({4194303.75F, 0, -4194303.75F}));
  EXPECT_FALSE(lattice.is_within({4194304.0F, 0, 0}));
  EXPECT_FALSE(lattice.is_within({std::numeric_limits<float>::quiet_NaN(), 0, 0}));
}

TEST(MapLattice, StepThatKeepsAnError) {
  for (const double error : {1e-3, 0.5, 3.0, 1e-9}) {
    const int k = step_exponent_for(error);
    EXPECT_LE(std::sqrt(3.0) / 2 * std::ldexp(1.0, k), error);
    EXPECT_GT(std::sqrt(3.0) * std::ldexp(1.0, k), error);
  }
}

TEST(PartKey, MAP3AncestorsAndOverlap) {
  EXPECT_EQ(ancestor({0, -1, 3, 4}, 2), (PartKey{2, -1, 0, 1}));
  EXPECT_TRUE(overlap({0, -1, 3, 4}, {2, -1, 0, 1}));
  EXPECT_FALSE(overlap({0, -1, 3, 4}, {2, 0, 0, 1}));
  EXPECT_FALSE(overlap({0, 0, 0, 0}, {0, 0, 0, 1}));
}

}  // namespace
}  // namespace deltamesh
