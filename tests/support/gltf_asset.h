// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Builds small glTF assets for tests, and takes them apart again.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/grid_triangles.h"

namespace deltamesh::test {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::byte>;

template <class T>
Bytes bytes_of(const std::vector<T>& values) {
  const auto bytes = std::as_bytes(std::span(values));
  return {bytes.begin(), bytes.end()};
}

inline Bytes bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// A bumpy sheet of n x n vertices over the unit square, with unit normals and texture coordinates.
struct Sheet {
  std::vector<float> positions;
  std::vector<float> normals;
  std::vector<float> uvs;
  std::vector<std::uint32_t> triangles;
};

inline Sheet make_sheet(std::uint32_t n) {
  Sheet sheet;
  const float scale = 1.0F / static_cast<float>(n - 1);
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const float x = static_cast<float>(i) * scale;
      const float y = static_cast<float>(j) * scale;
      const float slope_x = 0.6F * std::cos(6 * x);
      const float slope_y = -0.4F * std::sin(4 * y);
      const float length = std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
      sheet.positions.insert(sheet.positions.end(), {x, y, 0.1F * (std::sin(6 * x) + std::cos(4 * y))});
      sheet.normals.insert(sheet.normals.end(), {-slope_x / length, -slope_y / length, 1 / length});
      sheet.uvs.insert(sheet.uvs.end(), {x, 1 - y});
    }
  }
  sheet.triangles = grid_triangles(n, n);
  return sheet;
}

/// Collects JSON and one binary buffer.
class GltfBuilder {
 public:
  Json json{{"asset", {{"version", "2.0"}}},
            {"buffers", Json::array()},
            {"bufferViews", Json::array()},
            {"accessors", Json::array()}};
  Bytes bin;

  std::size_t view(const Bytes& bytes, int target = 0) {
    bin.resize((bin.size() + 3) / 4 * 4);
    Json item{{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", bytes.size()}};
    if (target != 0) item["target"] = target;
    bin.insert(bin.end(), bytes.begin(), bytes.end());
    return push("bufferViews", std::move(item));
  }

  std::size_t push(const char* list, Json item) {
    if (!json.contains(list)) json[list] = Json::array();
    json[list].push_back(std::move(item));
    return json[list].size() - 1;
  }

  /// `components` per row; min and max where asked.
  std::size_t floats(const std::vector<float>& values, std::size_t components, bool bounds = false,
                     int target = 34962) {
    constexpr std::array<const char*, 4> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    Json item{{"bufferView", view(bytes_of(values), target)},
              {"componentType", 5126},
              {"count", values.size() / components},
              {"type", kTypes[components - 1]}};
    if (bounds) {
      std::vector<float> low(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(components));
      std::vector<float> high = low;
      for (std::size_t i = 0; i < values.size(); ++i) {
        low[i % components] = std::min(low[i % components], values[i]);
        high[i % components] = std::max(high[i % components], values[i]);
      }
      item["min"] = low;
      item["max"] = high;
    }
    return push("accessors", std::move(item));
  }

  std::size_t indices(const std::vector<std::uint32_t>& values) {
    return push("accessors", {{"bufferView", view(bytes_of(values), 34963)},
                              {"componentType", 5125},
                              {"count", values.size()},
                              {"type", "SCALAR"}});
  }

  /// Adds a mesh of one primitive that shows `sheet`, and a node for it; returns the mesh's number.
  std::size_t sheet_mesh(const Sheet& sheet) {
    Json primitive{{"attributes",
                    {{"POSITION", floats(sheet.positions, 3, true)},
                     {"NORMAL", floats(sheet.normals, 3)},
                     {"TEXCOORD_0", floats(sheet.uvs, 2)}}},
                   {"indices", indices(sheet.triangles)}};
    const std::size_t mesh = push("meshes", {{"primitives", Json::array({primitive})}});
    push("nodes", {{"mesh", mesh}});
    return mesh;
  }

  /// JSON text; buffer 0 is at `uri`, or in the GLB where that is empty.
  std::string text(const std::string& uri) const {
    Json complete = json;
    Json nodes = Json::array();
    for (std::size_t i = 0; complete.contains("nodes") && i < complete["nodes"].size(); ++i)
      nodes.push_back(i);
    if (!nodes.empty() && !complete.contains("scenes")) {
      complete["scene"] = 0;
      complete["scenes"] = Json::array({Json{{"nodes", nodes}}});
    }
    Json buffer{{"byteLength", bin.size()}};
    if (!uri.empty()) buffer["uri"] = uri;
    complete["buffers"].insert(complete["buffers"].begin(), buffer);
    return complete.dump();
  }

  Bytes gltf(const std::string& uri) const { return bytes_of(text(uri)); }
  Bytes glb() const { return glb_of(text(""), bin); }

  static Bytes glb_of(std::string text, Bytes binary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4);
    Bytes file = bytes_of(std::vector<std::uint32_t>{
        0x46546c67, 2,
        static_cast<std::uint32_t>(12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size())),
        static_cast<std::uint32_t>(text.size()), 0x4e4f534a});
    const Bytes json_bytes = bytes_of(text);
    file.insert(file.end(), json_bytes.begin(), json_bytes.end());
    if (binary.empty()) return file;
    const Bytes header =
        bytes_of(std::vector<std::uint32_t>{static_cast<std::uint32_t>(binary.size()), 0x004e4942});
    file.insert(file.end(), header.begin(), header.end());
    file.insert(file.end(), binary.begin(), binary.end());
    return file;
  }
};

/// A GLB taken apart, with plain access to its accessors. Test failures where it is malformed.
struct OpenedGlb {
  Json json;
  Bytes bin;

  explicit OpenedGlb(const Bytes& file) {
    std::array<std::uint32_t, 5> head{};
    std::memcpy(head.data(), file.data(), sizeof head);
    EXPECT_EQ(head[2], file.size());
    const auto* text = reinterpret_cast<const char*>(file.data()) + 20;
    json = Json::parse(text, text + head[3]);
    const std::size_t bin_start = 20 + head[3] + 8;
    if (bin_start <= file.size())
      bin.assign(file.begin() + static_cast<std::ptrdiff_t>(bin_start), file.end());
  }

  Bytes view(std::size_t number) const {
    const Json& item = json["bufferViews"][number];
    EXPECT_EQ(item["buffer"], 0);
    const auto begin = bin.begin() + item.value("byteOffset", std::ptrdiff_t{0});
    return {begin, begin + item["byteLength"].get<std::ptrdiff_t>()};
  }

  /// Rows of an accessor, packed.
  template <class T>
  std::vector<T> values(std::size_t accessor) const {
    const Json& item = json["accessors"][accessor];
    const std::string type = item["type"];
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
    const Json& view_json = json["bufferViews"][item["bufferView"].get<std::size_t>()];
    const Bytes bytes = view(item["bufferView"].get<std::size_t>());
    const std::size_t stride = view_json.value("byteStride", components * sizeof(T));
    std::vector<T> result(item["count"].get<std::size_t>() * components);
    for (std::size_t row = 0; row < result.size() / components; ++row)
      std::memcpy(result.data() + row * components,
                  bytes.data() + item.value("byteOffset", std::size_t{0}) + row * stride,
                  components * sizeof(T));
    return result;
  }

  const Json& primitive(std::size_t mesh = 0, std::size_t number = 0) const {
    return json["meshes"][mesh]["primitives"][number];
  }
};

}  // namespace deltamesh::test
