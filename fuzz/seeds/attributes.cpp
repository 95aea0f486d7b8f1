// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Seeds of attributes of all kinds, of numbers on lattices, of skins and of colours.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "attribute_values.h"
#include "attributes/attribute.h"
#include "attributes/colors/colors.h"
#include "attributes/haar/haar.h"
#include "seeds.h"
#include "support/attribute_coding.h"
#include "targets/chunks/meshes.h"

namespace deltamesh::fuzz {
namespace {

constexpr std::uint8_t kAlone = 30;         ///< vertices without copies, as targets are told
constexpr std::uint8_t kCopied = 128 + 30;  ///< with

struct Shape {
  const char* name;
  AttributeKind kind;
  ComponentType type;
  unsigned components;
};
constexpr Shape kShapes[] = {{"colors_u8", kColor, kU8, 3},
                             {"colors_u16", kColor, kU16, 4},
                             {"normals", kNormal, kF32, 3},
                             {"tangents", kTangent, kF32, 4},
                             {"uvs", kUv, kF32, 2},
                             {"joints_u8", kJoints, kU8, 4},
                             {"joints_u16", kJoints, kU16, 4},
                             {"weights_u8", kWeights, kU8, 4},
                             {"weights_u16", kWeights, kU16, 4},
                             {"weights_f32", kWeights, kF32, 4},
                             {"labels", kGeneric, kU8, 1},
                             {"numbers_u16", kGeneric, kU16, 2},
                             {"floats", kGeneric, kF32, 3},
                             {"doubles", kGeneric, kF64, 1}};

Attribute with_shape(const Shape& shape, std::uint32_t vertices) {
  return attribute_of(shape.kind, shape.type, shape.components, vertices);
}

/// Bytes that say so to targets.
Bytes shape_bytes(const Attribute& a) {
  return bytes_of({static_cast<std::size_t>(a.kind), static_cast<std::size_t>(a.type), a.components - 1U});
}

Bytes payload_of(const Attribute& a, const AttributeSurface& surface, std::span<const Attribute> others,
                 const AttributeQuality& quality, bool is_plain) {
  const CodedAttribute coded =
      check(write_attribute(test::view(a), test::identity(surface.vertex_count()),
                            {.quality = quality, .plain = is_plain}, surface, others));
  if (coded.is_compact == is_plain) std::abort();
  return coded.payload;
}

/// Attributes of all kinds in the plain form, and in the compact one for the coder's target.
void make_all(const Corpora& corpora) {
  constexpr std::uint32_t kPlain = 20;
  const test::GraphMesh mesh = test::sheet(6, 5);
  const AttributeSurface surface(mesh.triangles, 30);
  const AttributeQuality exactly{.normal_error = 0, .uv_error = 0, .color_error = 0.0, .weight_error = 0};
  const Attribute no_rows = attribute_of(kColor, kU8, 3, 0);
  corpora.add(
      "attribute", "no_rows",
      payload_of(no_rows, AttributeSurface({}, 0), {}, exactly, true) + bytes_of({0}) + shape_bytes(no_rows));
  for (const Shape& shape : kShapes) {
    const Attribute plain = with_shape(shape, kPlain);
    for (const bool is_exact : {false, true})
      corpora.add("attribute", shape.name + std::string(is_exact ? "_exact" : ""),
                  payload_of(plain, AttributeSurface({}, kPlain), {},
                             is_exact ? exactly : AttributeQuality{.color_error = 2.0}, true) +
                      bytes_of({kPlain}) + shape_bytes(plain));
    const Attribute a = with_shape(shape, 30);
    corpora.add("compact", shape.name,
                bytes_of({4, 0}) + shape_bytes(a) + payload_of(a, surface, {}, {}, false));
  }
}

Attribute generic(std::span<const float> numbers, std::uint8_t components) {
  return {.type = kF32, .components = components, .name = "a", .values = float_bytes(numbers)};
}

void make_lattice(const Corpora& corpora) {
  constexpr std::uint8_t kFaces = 60;
  const auto add = [&](const std::string& name, const Attribute& a, std::uint8_t vertices, double bound) {
    const SpreadFaces spread(vertices, kFaces);
    const AttributeQuality quality{.named = {{a.name, bound}}};
    const Bytes payload = payload_of(a, spread.surface(vertices >= 128), {}, quality, false);
    const unsigned flag = std::to_integer<unsigned>(payload[0]) & 0x80U;
    corpora.add("lattice", name,
                Bytes(payload.begin() + 1, payload.end()) +
                    bytes_of({vertices, kFaces, flag | static_cast<unsigned>(a.type), a.components - 1U}));
  };
  for (const Shape& shape : kShapes) {
    if (shape.kind != kGeneric) continue;
    Attribute a = with_shape(shape, kAlone);
    for (const std::uint8_t vertices : {kAlone, kCopied}) {
      const std::string name = shape.name + std::string(vertices >= 128 ? "_copies" : "");
      add(name, a, vertices, 0);
      if (shape.type == kF32) add(name + "_bounded", a, vertices, 0.01);
    }
    if (shape.type != kF32) continue;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(a.values.data() + 24, &nan, sizeof nan);
    add("exceptions", a, kAlone, 0.01);
  }
  // As a morph target has them: most do not move.
  std::vector<float> numbers(90);
  for (std::size_t i = 36; i < 54; ++i) numbers[i] = 0.25F * static_cast<float>(i % 5);
  add("at_rest", generic(numbers, 3), kAlone, 0.01);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<float>(i * i % 1000) / 100;
  add("decimals", generic(numbers, 3), kAlone, 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = std::sqrt(static_cast<float>(i % 7));
  add("list", generic(numbers, 1), kAlone, 0);
  add("one_value", {.type = kU8, .name = "a", .values = Bytes(kAlone, std::byte{3})}, kAlone, 0);
  add("no_rows", {.type = kU8, .name = "a"}, 0, 0);
}

void make_skin(const Corpora& corpora) {
  constexpr std::uint8_t kFaces = 60;
  const std::vector<Attribute> others{skin_joints(kAlone)};
  unsigned joints = 0;   // whose type is first u8, then u16
  unsigned weights = 0;  // then f32
  for (const Shape& shape : kShapes) {
    if (shape.kind != kJoints && shape.kind != kWeights) continue;
    const unsigned choice = shape.kind == kJoints ? 2 * joints++ : 2 * weights++ + 1;
    for (const std::uint8_t vertices : {kAlone, kCopied}) {
      const SpreadFaces spread(vertices, kFaces);
      const Bytes payload =
          payload_of(with_shape(shape, kAlone), spread.surface(vertices >= 128), others, {}, false);
      corpora.add("skin", shape.name + std::string(vertices >= 128 ? "_copies" : ""),
                  Bytes(payload.begin() + 1, payload.end()) + bytes_of({vertices, kFaces, choice}));
    }
  }
}

void make_colors(const Corpora& corpora) {
  const ColoredMesh meshes[] = {ColoredMesh(test::fragments()), ColoredMesh(test::fan(30))};
  constexpr ComponentType kTypes[] = {kU8, kU16, kF32};
  constexpr double kErrors[] = {1, 250, 0.004};  // of numbers
  // As the target's last byte says it: type, components, mesh, positions and copies, coding.
  for (unsigned type = 0; type < 3; ++type) {
    for (const unsigned more : {0U, 8U + 16, 16U + 32, 4U + 32, 64U, 64U + 4 + 16 + 32, 64U + 8, 64U + 128,
                                64U + 128 + 8 + 16 + 32}) {
      const bool are_numbers = (more & 128) != 0;
      const AttributeSurface surface = meshes[more / 8 % 2].surface((more & 16) != 0, (more & 32) != 0);
      const Attribute a = attribute_of(are_numbers ? kGeneric : kColor, kTypes[type],
                                       are_numbers ? 1 : 3 + more / 4 % 2, surface.vertex_count());
      const auto order = test::identity(surface.vertex_count());
      const AttributeView view = test::view(a);
      const AttributeRows rows(view, order);
      const auto coded = (more & 64) != 0
                             ? write_haar_values(a.type, rows, are_numbers ? kErrors[type] : 2, surface)
                             : write_surface_colors(a.type, rows, 0, surface);
      corpora.add("colors",
                  std::string(are_numbers        ? "numbers_"
                              : (more & 64) != 0 ? "mean_"
                                                 : "exact_") +
                      std::to_string(type + more),
                  check(coded).bytes + bytes_of({type + more}));
    }
  }
}

}  // namespace

void make_attributes(const Corpora& corpora) {
  make_all(corpora);
  make_lattice(corpora);
  make_skin(corpora);
  make_colors(corpora);
}

}  // namespace deltamesh::fuzz
