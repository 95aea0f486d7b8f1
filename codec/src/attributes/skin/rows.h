// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Joints and weights as rows of whole numbers, and back; and the rows coded over a surface, one template for
// both directions.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

#include "attributes/copies.h"
#include "attributes/field_faces.h"
#include "attributes/skin/joint_coder.h"
#include "attributes/skin/weight_coder.h"
#include "attributes/values.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

inline constexpr std::uint32_t kMostWeightSum = 1U << 16;

/// The largest integer of u8 or u16; 1 of floats.
constexpr std::uint32_t top_of(ComponentType type) noexcept {
  return type == ComponentType::kU8 ? 255 : type == ComponentType::kU16 ? 65535 : 1;
}

constexpr bool is_four_integers(const Attribute& a) noexcept {
  return a.components == kInfluences && (a.type == ComponentType::kU8 || a.type == ComponentType::kU16);
}

/// `values`: four u8 or u16 per vertex.
inline std::vector<JointRow> joint_rows(std::span<const std::byte> values, ComponentType type) {
  const std::size_t size = component_size(type);
  std::vector<JointRow> rows(values.size() / (kInfluences * size));
  for (std::size_t i = 0; i < kInfluences * rows.size(); ++i)
    rows[i / kInfluences][i % kInfluences] =
        static_cast<std::int32_t>(load_component(values.data() + i * size, size));
  return rows;
}

/// The values whose bits are `bits_of(number)`. `rows`: n x 4 numbers.
template <class Rows, class BitsOf>
std::vector<std::byte> skin_values(const Rows& rows, ComponentType type, BitsOf bits_of) {
  AttributeValues values(type, kInfluences, rows.size());
  for (std::size_t slot = 0; slot < kInfluences; ++slot)
    values.set_component(slot, [&](std::size_t i) { return bits_of(rows[i][slot]); });
  return values.take();
}

inline std::vector<std::byte> joint_values(std::span<const JointRow> rows, ComponentType type) {
  return skin_values(rows, type, [](std::int32_t joint) { return static_cast<std::uint64_t>(joint); });
}

/// The bits of `weight` of `sum`, which divides the top of an integer type [ATTR-63].
inline std::uint64_t weight_bits(std::int32_t weight, std::uint32_t sum, ComponentType type) noexcept {
  if (type != ComponentType::kF32) return static_cast<std::uint64_t>(weight) * (top_of(type) / sum);
  return std::bit_cast<std::uint32_t>(static_cast<float>(static_cast<double>(weight) / sum));
}

inline std::vector<std::byte> weight_values(std::span<const WeightRow> rows, std::uint32_t sum,
                                            ComponentType type) {
  return skin_values(rows, type, [&](std::int32_t weight) { return weight_bits(weight, sum, type); });
}

/// The joints that the next weights attribute is of: as many attributes of joints come before them as of
/// weights; each slot its own joint where there are none, or not of this shape [ATTR-62].
inline std::vector<JointRow> joints_of_weights(std::span<const Attribute> others, std::size_t count) {
  std::size_t before = 0;
  for (const Attribute& other : others)
    before += other.kind == AttributeKind::kWeights && !other.values.empty() ? 1 : 0;
  for (const Attribute& other : others) {
    if (other.kind != AttributeKind::kJoints || before-- != 0) continue;
    if (!is_four_integers(other)) break;
    auto rows = joint_rows(other.values, other.type);
    if (rows.size() == count) return rows;
    break;
  }
  return std::vector<JointRow>(count, JointRow{0, 1, 2, 3});
}

/// False where the stream breaks a rule, or, in a reader, its bytes end.
template <class Coder>
bool code_joints(Coder& coder, const FieldFaces& over, std::uint32_t most, std::span<JointRow> rows) {
  JointCoder<Coder> joints(coder, over.faces(), most);
  CopyCoder<Coder, kInfluences> copies(coder, kInfluences);
  return code_with_copies(
      coder, over.geometric(), over.vertex_count(), rows,
      [&](std::uint32_t vertex, std::span<JointRow> all) { return joints.code_vertex(vertex, all); },
      [&](const JointRow& before, JointRow& row) {
        copies.code(before, row);
        return std::all_of(row.begin(), row.end(), [most](std::int32_t joint) {
          return joint >= 0 && static_cast<std::uint32_t>(joint) <= most;
        });
      });
}

/// The rule that the stream breaks, or null; in a reader whose bytes end, any rule. `joints`: of every
/// vertex.
template <class Coder>
const char* code_weights(Coder& coder, const FieldFaces& over, std::span<const JointRow> joints,
                         std::uint32_t sum, std::size_t blend, std::span<WeightRow> rows) {
  const std::vector<JointRow> shared = over.first_copies(joints);
  WeightCoder<Coder> weights(coder, over.faces(), shared, static_cast<std::int32_t>(sum),
                             weight_blends(blend));
  CopyCoder<Coder, kInfluences> copies(coder, kInfluences - 1);
  const char* broken = "ATTR-65";
  const bool is_valid = code_with_copies(
      coder, over.geometric(), over.vertex_count(), rows,
      [&](std::uint32_t vertex, std::span<WeightRow> all) { return weights.code_vertex(vertex, all); },
      [&](const WeightRow& before, WeightRow& row) {
        copies.code(before, row);
        std::int64_t rest = sum;
        for (std::size_t slot = 0; slot + 1 < kInfluences; ++slot) {
          if (row[slot] < 0 || row[slot] > rest) {
            broken = "ATTR-63";
            return false;
          }
          rest -= row[slot];
        }
        row[kInfluences - 1] = static_cast<std::int32_t>(rest);
        return true;
      });
  return is_valid ? nullptr : broken;
}

}  // namespace deltamesh
