// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Compares assets before packing and after unpacking, whatever the order of their vertices and triangles.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "support/gltf_asset.h"

namespace deltamesh::test {

/// Rows of any accessor with a view, packed.
inline std::vector<Bytes> rows_of(const OpenedGlb& glb, const Json& accessor) {
  const Json& item = glb.json["accessors"][accessor.get<std::size_t>()];
  const std::map<int, std::size_t> sizes{{5120, 1}, {5121, 1}, {5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
  const std::string type = item["type"];
  const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
  const std::size_t size = components * sizes.at(item["componentType"]);
  const Json& view_json = glb.json["bufferViews"][item["bufferView"].get<std::size_t>()];
  const Bytes bytes = glb.view(item["bufferView"].get<std::size_t>());
  const std::size_t stride = view_json.value("byteStride", size);
  std::vector<Bytes> rows;
  for (std::size_t i = 0; i < item["count"].get<std::size_t>(); ++i) {
    const auto first =
        bytes.begin() + static_cast<std::ptrdiff_t>(item.value("byteOffset", std::size_t{0}) + i * stride);
    rows.emplace_back(first, first + static_cast<std::ptrdiff_t>(size));
  }
  return rows;
}

inline std::vector<std::uint32_t> corners_of(const OpenedGlb& glb, const Json& primitive) {
  std::vector<std::uint32_t> corners;
  if (!primitive.contains("indices")) {
    corners.resize(rows_of(glb, primitive["attributes"]["POSITION"]).size());
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
    return corners;
  }
  for (const Bytes& row : rows_of(glb, primitive["indices"])) {
    std::uint32_t corner = 0;
    std::memcpy(&corner, row.data(), row.size());
    corners.push_back(corner);
  }
  return corners;
}

/// Name and accessor of every attribute, those of morph targets too, by name.
inline std::map<std::string, Json> attributes_of(const Json& primitive) {
  std::map<std::string, Json> attributes;
  for (const auto& item : primitive["attributes"].items()) attributes[item.key()] = item.value();
  if (primitive.contains("targets"))
    for (std::size_t i = 0; i < primitive["targets"].size(); ++i)
      for (const auto& item : primitive["targets"][i].items())
        attributes[std::to_string(i) + " " + item.key()] = item.value();
  return attributes;
}

/// The triangles of a primitive with the bytes of all that their corners have, sorted.
inline std::vector<std::array<Bytes, 3>> soup_of(const OpenedGlb& glb, const Json& primitive) {
  std::vector<std::vector<Bytes>> columns;
  for (const auto& [name, accessor] : attributes_of(primitive)) columns.push_back(rows_of(glb, accessor));
  const auto corners = corners_of(glb, primitive);
  std::vector<std::array<Bytes, 3>> soup(corners.size() / 3);
  for (std::size_t i = 0; i < soup.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      for (const auto& column : columns)
        soup[i][k].insert(soup[i][k].end(), column[corners[3 * i + k]].begin(),
                          column[corners[3 * i + k]].end());
    std::rotate(soup[i].begin(), std::min_element(soup[i].begin(), soup[i].end()), soup[i].end());
  }
  std::sort(soup.begin(), soup.end());
  return soup;
}

/// Every primitive has the same triangles in both, to the last bit.
inline void expect_same_soups(const OpenedGlb& before, const OpenedGlb& after) {
  ASSERT_EQ(before.json["meshes"].size(), after.json["meshes"].size());
  for (std::size_t m = 0; m < before.json["meshes"].size(); ++m) {
    const Json& primitives = before.json["meshes"][m]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p)
      EXPECT_TRUE(soup_of(before, primitives[p]) == soup_of(after, after.primitive(m, p))) << m << ' ' << p;
  }
}

inline std::vector<float> floats_of(const Bytes& row) {
  std::vector<float> values(row.size() / sizeof(float));
  std::memcpy(values.data(), row.data(), values.size() * sizeof(float));
  return values;
}

/// The asset with an attribute _ID in every primitive: the number of each vertex.
inline Bytes with_ids(OpenedGlb glb) {
  for (Json& mesh : glb.json["meshes"]) {
    for (Json& primitive : mesh["primitives"]) {
      const std::size_t count = rows_of(glb, primitive["attributes"]["POSITION"]).size();
      std::vector<float> ids(count);
      for (std::size_t i = 0; i < count; ++i) ids[i] = static_cast<float>(i);
      glb.bin.resize((glb.bin.size() + 3) / 4 * 4);
      glb.json["bufferViews"].push_back(
          {{"buffer", 0}, {"byteOffset", glb.bin.size()}, {"byteLength", 4 * count}});
      const Bytes bytes = bytes_of(ids);
      glb.bin.insert(glb.bin.end(), bytes.begin(), bytes.end());
      glb.json["accessors"].push_back({{"bufferView", glb.json["bufferViews"].size() - 1},
                                       {"componentType", 5126},
                                       {"count", count},
                                       {"type", "SCALAR"}});
      primitive["attributes"]["_ID"] = glb.json["accessors"].size() - 1;
    }
  }
  glb.json["buffers"][0]["byteLength"] = glb.bin.size();
  return GltfBuilder::glb_of(glb.json.dump(), glb.bin);
}

/// Calls `visit(name, before, after)` with the bytes of every attribute of every vertex that triangles of the
/// primitive use. Both assets are those of with_ids().
template <class Visit>
void for_each_vertex(const OpenedGlb& before, const Json& source, const OpenedGlb& after, const Json& result,
                     Visit&& visit) {
  const auto sources = attributes_of(source);
  const auto results = attributes_of(result);
  ASSERT_EQ(sources.size(), results.size());
  const auto ids = rows_of(after, result["attributes"]["_ID"]);
  const auto corners = corners_of(after, result);
  ASSERT_LE(corners.size(), corners_of(before, source).size());  // some may draw nothing
  ASSERT_FALSE(corners.empty());
  for (const auto& [name, accessor] : sources) {
    const auto from = rows_of(before, accessor);
    const auto to = rows_of(after, results.at(name));
    for (const std::uint32_t corner : corners)
      visit(name, from[static_cast<std::size_t>(floats_of(ids[corner])[0])], to[corner]);
  }
}

/// Largest distance of the first three floats.
inline double distance(const Bytes& a, const Bytes& b) {
  const auto x = floats_of(a);
  const auto y = floats_of(b);
  double sum = 0;
  for (std::size_t k = 0; k < x.size() && k < 3; ++k) sum += (double(x[k]) - y[k]) * (double(x[k]) - y[k]);
  return std::sqrt(sum);
}

/// Equal positions of a mesh before are equal after, in all its primitives. Both assets are those of
/// with_ids().
inline void expect_no_cracks(const OpenedGlb& before, const OpenedGlb& after) {
  for (std::size_t m = 0; m < before.json["meshes"].size(); ++m) {
    std::map<std::vector<float>, Bytes> decoded;  // -0 equals 0
    std::size_t cracks = 0;
    for (std::size_t p = 0; p < before.json["meshes"][m]["primitives"].size(); ++p)
      for_each_vertex(before, before.primitive(m, p), after, after.primitive(m, p),
                      [&](const std::string& name, const Bytes& from, const Bytes& to) {
                        if (name == "POSITION")
                          cracks += decoded.try_emplace(floats_of(from), to).first->second != to;
                      });
    EXPECT_EQ(cracks, 0U) << "mesh " << m;
  }
}

}  // namespace deltamesh::test
