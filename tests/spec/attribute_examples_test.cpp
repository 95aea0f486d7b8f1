// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The worked examples of attributes: attributes of the four points of POSN's example. Their bytes decode to
// their values, and are what the encoder writes.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "attributes/haar/picture.h"
#include "attributes/haar/writer.h"
#include "spec/example_lines.h"
#include "support/attribute_coding.h"

namespace deltamesh {
namespace {

using test::bytes_of;
using test::line_of;

class AttributeExamples : public ::testing::Test {
 protected:
  template <class Number>
  static Attribute attribute(AttributeKind kind, ComponentType type, int components,
                             const std::vector<Number>& numbers) {
    return test::attribute_of(kind, type, components, "", numbers);
  }

  /// The payload of `file` gives `expected`; so does encoding `expected`'s numbers, or `source`'s.
  void check(const std::string& file, const Attribute& source, const Attribute& expected,
             const AttributeQuality& quality = test::kExactly, const std::string& name = "payload") {
    const auto payload = bytes_of(file, name);
    const AttributeSurface surface(triangles_, 4, {}, positions_);
    const auto coded =
        write_attribute(test::view(source), test::identity(4), {.quality = quality}, surface, others_);
    ASSERT_TRUE(coded);
    EXPECT_EQ(coded->payload, payload) << file;
    const auto read = read_attribute(Payload::compact(payload), coded->descriptor, surface, others_, 1000);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->values, expected.values) << file;
  }

  std::vector<std::uint32_t> triangles_ = {0, 1, 2, 2, 1, 3};
  std::vector<float> positions_ = line_of<float>("posn.md", "q");
  std::vector<Attribute> others_;
};

TEST_F(AttributeExamples, ATTR55ATTR56ATTR57Heights) {
  const Attribute values = attribute(AttributeKind::kGeneric, ComponentType::kU16, 1,
                                     line_of<std::uint16_t>("attr_lattice.md", "values"));
  check("attr_lattice.md", values, values);
}

TEST_F(AttributeExamples, ATTR45ATTR47ATTR51Colours) {
  const Attribute values = attribute(AttributeKind::kColor, ComponentType::kU8, 3,
                                     line_of<std::uint8_t>("attr_colors.md", "values"));
  check("attr_colors.md", values, values);
}

TEST_F(AttributeExamples, HAAR6HAAR7HAAR13ColoursAtAMeanError) {
  const AttributeSurface surface(triangles_, 4, {}, positions_);
  const auto levels = make_haar_levels(surface);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[1].children[0].second, 1U);
  const Attribute source = attribute(AttributeKind::kColor, ComponentType::kU8, 3,
                                     line_of<std::uint8_t>("attr_haar.md", "source"));
  const auto order = test::identity(4);
  const HaarWriter writer(*picture_of_colors(source.type, AttributeRows(test::view(source), order)), levels);
  auto payload = writer.code(64, ComponentType::kU8).bytes;
  payload.insert(payload.begin(), std::byte{11});
  EXPECT_EQ(payload, bytes_of("attr_haar.md", "payload"));
  const Attribute expected = attribute(AttributeKind::kColor, ComponentType::kU8, 3,
                                       line_of<std::uint8_t>("attr_haar.md", "values"));
  const auto read =
      read_attribute(Payload::compact(payload), descriptor_of(expected), surface, others_, 1000);
  ASSERT_TRUE(read) << describe(read.error());
  EXPECT_EQ(read->values, expected.values);
}

TEST_F(AttributeExamples, ATTR31ATTR32ATTR37TextureCoordinates) {
  const auto numbers = [](const char* name) {
    return attribute(AttributeKind::kUv, ComponentType::kF32, 2, line_of<float>("attr_uvs.md", name));
  };
  check("attr_uvs.md", numbers("source"), numbers("values"), {.uv_error = 0.125});
}

TEST_F(AttributeExamples, ATTR20ATTR21ATTR24ATTR25Normals) {
  const auto numbers = [](const char* name) {
    return attribute(AttributeKind::kNormal, ComponentType::kF32, 3, line_of<float>("attr_normals.md", name));
  };
  check("attr_normals.md", numbers("source"), numbers("values"), {.normal_error = 5});
}

TEST_F(AttributeExamples, ATTR38ATTR39ATTR40ATTR44Tangents) {
  others_ = {attribute(AttributeKind::kUv, ComponentType::kF32, 2, line_of<float>("attr_uvs.md", "values"))};
  const auto numbers = [](const char* name) {
    return attribute(AttributeKind::kTangent, ComponentType::kF32, 4,
                     line_of<float>("attr_tangents.md", name));
  };
  check("attr_tangents.md", numbers("source"), numbers("values"), {.normal_error = 5});
}

TEST_F(AttributeExamples, ATTR60ATTR61ATTR62Joints) {
  const Attribute values = attribute(AttributeKind::kJoints, ComponentType::kU8, 4,
                                     line_of<std::uint8_t>("attr_skin.md", "joints"));
  check("attr_skin.md", values, values);
}

TEST_F(AttributeExamples, ATTR62ATTR63ATTR64ATTR65Weights) {
  others_ = {attribute(AttributeKind::kJoints, ComponentType::kU8, 4,
                       line_of<std::uint8_t>("attr_skin.md", "joints"))};
  const Attribute values = attribute(AttributeKind::kWeights, ComponentType::kU8, 4,
                                     line_of<std::uint8_t>("attr_skin.md", "weights"));
  check("attr_skin.md", values, values, test::kExactly, "weights-payload");
}

}  // namespace
}  // namespace deltamesh
