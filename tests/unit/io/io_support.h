// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the tests of the importers and exporters share: small meshes, bytes from text, truncation.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/io.h"
#include "support/attribute_of.h"

namespace deltamesh::test {

inline std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

inline std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class T>
Attribute attribute(AttributeKind kind, ComponentType type, std::uint8_t components, std::string name,
                    const std::vector<T>& values) {
  const bool normalized = kind == AttributeKind::kColor && type != ComponentType::kF32;
  return attribute_of(kind, type, components, std::move(name), values, normalized);
}

/// All that a report lists of a kind; of one name where one is given.
inline std::uint64_t left_out(const LossReport& report, LeftOutKind kind, std::string_view name = {}) {
  std::uint64_t count = 0;
  for (const LeftOut& entry : report.left_out)
    if (entry.kind == kind && (name.empty() || entry.name == name)) count += entry.count;
  return count;
}

inline const Attribute* find(const Mesh& mesh, AttributeKind kind) {
  for (const Attribute& candidate : mesh.attributes)
    if (candidate.kind == kind) return &candidate;
  return nullptr;
}

/// A tetrahedron without one side: 4 vertices, 3 triangles, awkward digits.
inline Mesh small_mesh() {
  Mesh mesh;
  mesh.positions = {0.1F, 0, 0, 1.0F / 3, -2.5e-7F, 1, 0, 1e-3F, 16777216.0F, -0.3F, 7, 8.125F};
  mesh.triangles = {0, 1, 2, 0, 2, 3, 3, 1, 0};
  return mesh;
}

/// The same with normals, colours (u8 x 4), texture coordinates.
inline Mesh dressed_mesh() {
  Mesh mesh = small_mesh();
  mesh.attributes.push_back(attribute<float>(AttributeKind::kNormal, ComponentType::kF32, 3, "nx",
                                             {0, 0, 1, 1, 0, 0, 0, -1, 0, 0.6F, 0, 0.8F}));
  mesh.attributes.push_back(
      attribute<float>(AttributeKind::kUv, ComponentType::kF32, 2, "s", {0, 0, 1, 0.25F, 0.1F, 1, -3, 2}));
  mesh.attributes.push_back(
      attribute<std::uint8_t>(AttributeKind::kColor, ComponentType::kU8, 4, "red",
                              {255, 0, 0, 255, 0, 128, 7, 1, 3, 4, 5, 0, 250, 251, 252, 253}));
  return mesh;
}

/// Reads `bytes` from an allocation of exactly their size, so that a sanitizer sees a read past the end.
inline Result<Imported> read_exact(std::span<const std::byte> bytes, FileFormat format) {
  const auto copy = std::make_unique<std::byte[]>(bytes.size());
  std::copy(bytes.begin(), bytes.end(), copy.get());
  return read_mesh({copy.get(), bytes.size()}, format);
}

inline Result<Imported> read_text(std::string_view text, FileFormat format) {
  return read_exact(std::as_bytes(std::span(text)), format);
}

/// What every importer promises on success.
inline void expect_valid(const Mesh& mesh) {
  ASSERT_EQ(mesh.positions.size() % 3, 0U);
  ASSERT_EQ(mesh.triangles.size() % 3, 0U);
  for (const std::uint32_t index : mesh.triangles) ASSERT_LT(index, mesh.vertex_count());
  for (const Attribute& a : mesh.attributes) {
    ASSERT_GE(a.components, 1);
    ASSERT_LE(a.components, 16);
    ASSERT_FALSE(a.name.empty());
    ASSERT_LE(a.name.size(), 255U);
    ASSERT_EQ(a.values.size(), mesh.vertex_count() * a.components * component_size(a.type));
  }
}

/// Every prefix of a file is a clean error or a valid mesh; so is every file with one byte changed.
inline void expect_robust(std::span<const std::byte> bytes, FileFormat format) {
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    SCOPED_TRACE(size);
    const auto imported = read_exact(bytes.first(size), format);
    if (imported)
      expect_valid(imported->mesh);
    else
      ASSERT_EQ(imported.error().code, ErrorCode::kInvalidFile) << describe(imported.error());
  }
  std::vector<std::byte> changed(bytes.begin(), bytes.end());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    for (const int flip : {0x01, 0x10, 0x80, 0xff}) {
      SCOPED_TRACE(i);
      changed[i] ^= static_cast<std::byte>(flip);
      if (const auto imported = read_exact(changed, format)) expect_valid(imported->mesh);
      changed[i] ^= static_cast<std::byte>(flip);
    }
  }
}

inline void expect_error(std::string_view text, FileFormat format, WhereKind kind = WhereKind::kNone,
                         std::uint64_t where = 0) {
  SCOPED_TRACE(std::string(text.substr(0, 200)));
  const auto imported = read_text(text, format);
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.error().code, ErrorCode::kInvalidFile);
  if (kind == WhereKind::kNone) return;
  EXPECT_EQ(imported.error().where_kind, kind) << describe(imported.error());
  EXPECT_EQ(imported.error().where, where) << describe(imported.error());
}

}  // namespace deltamesh::test
