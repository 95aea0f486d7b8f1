// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What every mesh of the corpus loses without options: no more than its owner could tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include "corpus_files.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "deltamesh/io.h"

namespace deltamesh {
namespace {

using testing_corpus::corpus;
using testing_corpus::mesh_files;
using testing_corpus::test_name;

/// Component c of row i of an attribute of floats.
double number(const Attribute& attribute, std::size_t i, std::size_t c) {
  float value = 0;
  std::memcpy(&value, attribute.values.data() + 4 * (i * attribute.components + c), 4);
  return static_cast<double>(value);
}

double degrees_apart(const Attribute& a, std::size_t i, const Attribute& b, std::size_t j) {
  double cosine = 0;
  double size_a = 0;
  double size_b = 0;
  double apart = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double x = number(a, i, c);
    const double y = number(b, j, c);
    cosine += x * y;
    size_a += x * x;
    size_b += y * y;
    apart += (x - y) * (x - y);
  }
  if (size_a == 0 || size_b == 0) return size_a == size_b ? 0 : 90;
  const double sine = std::sqrt(std::max(0.0, size_a * size_b - cosine * cosine));
  return apart == 0 ? 0 : std::atan2(sine, cosine) * 180 / 3.14159265358979;
}

double largest_difference(const Attribute& a, std::size_t i, const Attribute& b, std::size_t j) {
  double largest = 0;
  for (std::size_t c = 0; c < a.components; ++c)
    largest = std::max(largest, std::abs(number(a, i, c) - number(b, j, c)));
  return largest;
}

/// Of red, green and blue of 8 bits, over all rows.
double rms_of_colors(const Attribute& before, const Attribute& after,
                     const std::vector<std::uint32_t>& order) {
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto level = [c](const Attribute& colors, std::size_t row) {
        return std::to_integer<int>(colors.values[row * colors.components + c]);
      };
      sum += std::pow(level(before, order[i]) - level(after, i), 2);
    }
  return order.empty() ? 0 : std::sqrt(sum / (3 * static_cast<double>(order.size())));
}

/// Directions may have any length, here in the files that MeshLab wrote: within the angle, whatever the
/// lengths. `order`: the row of `before` for every row of `after`.
void expect_default_bounds(const Attribute& before, const Attribute& after,
                           const std::vector<std::uint32_t>& order) {
  const bool is_direction = before.kind == AttributeKind::kNormal || before.kind == AttributeKind::kTangent;
  const bool is_uv = before.kind == AttributeKind::kUv;
  const bool is_color = before.kind == AttributeKind::kColor && before.type == ComponentType::kU8;
  if (is_color && before.components >= 3) {
    EXPECT_LE(rms_of_colors(before, after, order), kPhotographicRms) << before.name;
    return;
  }
  const bool floats = before.type == ComponentType::kF32;
  const std::size_t row = before.components * component_size(before.type);
  double worst = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (floats && is_direction) {
      worst = std::max(worst, degrees_apart(before, order[i], after, i) / 0.5);
    } else if (floats && (is_uv || before.kind == AttributeKind::kWeights)) {
      worst = std::max(worst, largest_difference(before, order[i], after, i) * (is_uv ? 4096 : 1024));
    } else {
      ASSERT_EQ(std::memcmp(before.values.data() + row * order[i], after.values.data() + row * i, row), 0)
          << before.name;
    }
  }
  EXPECT_LE(worst, 1.001) << before.name;
}

class DefaultsCorpus : public testing::TestWithParam<std::string> {};

TEST_P(DefaultsCorpus, LoseWhatNobodyCanTell) {
  if (GetParam().empty()) GTEST_SKIP() << "skipped: no corpus";
  const auto imported = read_mesh_file((corpus() / GetParam()).string());
  ASSERT_TRUE(imported) << describe(imported.error());
  const Mesh& mesh = imported->mesh;
  const auto encoded = encode(mesh);
  ASSERT_TRUE(encoded) << describe(encoded.error());
  const auto decoded = decode(encoded->bytes);
  ASSERT_TRUE(decoded) << describe(decoded.error());

  double largest = 0;
  for (std::size_t i = 0; i < decoded->vertex_count(); ++i) {
    double squares = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double apart = static_cast<double>(decoded->positions[3 * i + c]) -
                           static_cast<double>(mesh.positions[3 * encoded->order[i] + c]);
      squares += apart * apart;
    }
    largest = std::max(largest, std::sqrt(squares));
  }
  EXPECT_LE(largest, 0.00021 * encoded->report.stream.diagonal);
  ASSERT_EQ(decoded->attributes.size(), mesh.attributes.size());
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a)
    expect_default_bounds(mesh.attributes[a], decoded->attributes[a], encoded->order);
}

INSTANTIATE_TEST_SUITE_P(Meshes, DefaultsCorpus, testing::ValuesIn(mesh_files()), test_name);

}  // namespace
}  // namespace deltamesh
