// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/chunk/attribute_descriptor.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "base/numbers/short_float.h"

namespace deltamesh {
namespace {

std::vector<std::byte> write(const AttributeDescriptor& attribute) {
  ByteWriter out;
  write_descriptor(out, attribute);
  return out.take();
}

std::string broken_rule(const std::vector<std::byte>& bytes) {
  ByteReader in(bytes);
  const auto attribute = read_descriptor(in);
  return attribute ? "none" : attribute.error().rule;
}

/// NORMAL as glTF has it.
AttributeDescriptor normal() {
  return {.kind = AttributeKind::kNormal, .components = 3, .name = "NORMAL", .error = 0.25F};
}

TEST(AttributeDescriptor, ATTR1ReadsEveryRowOfUsualAttributesBackToOneByte) {
  for (unsigned row = 1; row <= 21; ++row) {
    const std::vector<std::byte> byte{static_cast<std::byte>(row)};
    ByteReader in(byte);
    const auto attribute = read_descriptor(in);
    ASSERT_TRUE(attribute) << row;
    EXPECT_EQ(write(*attribute), byte) << row;
    EXPECT_EQ(attribute->error, 0);
  }
  EXPECT_EQ(broken_rule({std::byte{22}}), "ATTR-1");
  EXPECT_EQ(broken_rule({std::byte{127}}), "ATTR-1");
}

TEST(AttributeDescriptor, ATTR1KnowsTheNamesOfGltfAndOfReaders) {
  EXPECT_EQ(write(normal()).size(), 4U);
  const AttributeDescriptor color{.kind = AttributeKind::kColor,
                                  .type = ComponentType::kU8,
                                  .components = 4,
                                  .flags = 3,
                                  .name = "COLOR_0"};
  EXPECT_EQ(write(color), std::vector{std::byte{5}});
  AttributeDescriptor plain = color;
  plain.flags = 0;
  EXPECT_EQ(write(plain).size(), 6U + plain.name.size());
  AttributeDescriptor other = color;
  other.name = "COLOR_7";
  EXPECT_EQ(write(other).size(), 6U + other.name.size());
}

TEST(AttributeDescriptor, ATTR1OnlyColorsAreLinear) {
  Attribute shape{.kind = AttributeKind::kColor, .linear = true};
  EXPECT_TRUE(descriptor_of(shape).is_linear());
  std::vector<std::byte> bytes = write(descriptor_of(shape));
  ByteReader in(bytes);
  const auto back = read_descriptor(in);
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->is_linear());
  bytes[1] = static_cast<std::byte>(AttributeKind::kGeneric);
  EXPECT_EQ(broken_rule(bytes), "ATTR-1");
  shape.kind = AttributeKind::kGeneric;
  EXPECT_FALSE(descriptor_of(shape).is_linear());
}

TEST(AttributeDescriptor, ATTR1RoundTrips) {
  for (const AttributeDescriptor& attribute :
       {AttributeDescriptor{}, normal(),
        AttributeDescriptor{.type = ComponentType::kF64, .components = 16, .name = std::string(255, 'x')},
        AttributeDescriptor{
            .kind = AttributeKind::kWeights, .type = ComponentType::kU8, .flags = 1, .error = 3}}) {
    const auto bytes = write(attribute);
    ByteReader in(bytes);
    const auto back = read_descriptor(in);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, attribute);
    EXPECT_EQ(in.remaining(), 0U);
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_NE(broken_rule({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}), "none");
  }
}

TEST(AttributeDescriptor, ATTR1RejectsWhatNoAttributeHas) {
  const auto rule_of = [](const AttributeDescriptor& attribute) { return broken_rule(write(attribute)); };
  EXPECT_EQ(rule_of({}), "none");
  EXPECT_EQ(rule_of({.kind = AttributeKind{kAttributeKinds}}), "ATTR-1");
  EXPECT_EQ(rule_of({.type = ComponentType{8}}), "ATTR-1");
  EXPECT_EQ(rule_of({.components = 0}), "ATTR-1");
  EXPECT_EQ(rule_of({.components = 17}), "ATTR-1");
  EXPECT_EQ(rule_of({.flags = 2}), "ATTR-1");
  EXPECT_EQ(rule_of({.error = -1}), "ATTR-1");
  EXPECT_EQ(rule_of({.error = std::numeric_limits<float>::infinity()}), "ATTR-1");
}

}  // namespace
}  // namespace deltamesh
