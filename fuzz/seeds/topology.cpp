// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Seeds of faces, seams, groups and order, and of the coder alone.
#include "connectivity/plain/topology.h"

#include <algorithm>
#include <cstdint>

#include "connectivity/faces/faces.h"
#include "connectivity/groups/groups.h"
#include "connectivity/order/order.h"
#include "connectivity/seams/seams.h"
#include "seeds.h"
#include "targets/chunks/coder_run.h"
#include "targets/chunks/meshes.h"

namespace deltamesh::fuzz {
namespace {

void make_coder(const Corpora& corpora) {
  // What a reader makes of random bytes has every symbol in its range.
  test::Random random(1);
  Bytes noise(std::size_t{4} * kMostRun);
  for (std::byte& byte : noise) byte = static_cast<std::byte>(random.below(256));
  CompactReader reader(noise);
  std::vector<std::uint32_t> values;
  run_coder(reader, values, [](std::size_t i) { return i < kMostRun; });
  CompactWriter writer;
  run_coder(writer, values, [](std::size_t i) { return i < kMostRun; });
  corpora.add("compact", "coder", bytes_of({0, 0}) + writer.finish());
}

void make_connectivity(const Corpora& corpora) {
  std::vector<test::Soup> soups = {test::grid(7, 7, false, false, 4, 1),
                                   test::grid(5, 4, true, true, 0, 2),
                                   test::two_sided(test::grid(4, 3, true, false, 6, 3)),
                                   test::shuffled(test::moebius_strip(15), 4, 3),
                                   test::fan(20, true),
                                   test::random_soup(5, 12, 40)};
  for (test::Soup& soup : test::awkward_soups())
    if (soup.triangles.size() <= 36) soups.push_back(std::move(soup));
  for (const test::Soup& soup : soups) {
    const Bytes payload = write_connectivity(soup.triangles, soup.vertex_count).payload;
    const std::size_t faces = soup.triangles.size() / 3;
    corpora.add("connectivity", soup.name,
                payload + bytes_of({soup.vertex_count, 2 * faces % 256, 2 * faces / 256}));
  }
  // The coder's target has so many vertices whatever the faces are.
  constexpr std::uint32_t kVertices = 60;
  for (const test::Soup& soup : {soups[1], soups[3], soups[5]})
    corpora.add(
        "compact", "conn_" + soup.name,
        bytes_of({1, soup.triangles.size() / 3}) + write_connectivity(soup.triangles, kVertices).payload);
}

void make_seams(const Corpora& corpora) {
  for (unsigned choice = 0; choice < 4; ++choice) {
    const test::Soup soup = choose_soup(choice);
    const CodedConnectivity coded = write_connectivity(soup.triangles, soup.vertex_count);
    for (const std::uint32_t copies : {1U, 3U}) {
      // The copies of a vertex take turns.
      std::vector<std::uint32_t> corners;
      for (std::uint32_t c = 0; c < coded.triangles.size(); ++c)
        corners.push_back(coded.triangles[c] + soup.vertex_count * (c / 5 % copies));
      std::vector<std::uint32_t> lone;
      for (std::uint32_t v = 0; v < soup.vertex_count; ++v)
        if (std::find(coded.triangles.begin(), coded.triangles.end(), v) == coded.triangles.end())
          lone.push_back(v);
      const CodedSeams seams = write_seams(coded.triangles, soup.vertex_count, corners, lone);
      const std::size_t more = seams.split.geometric.size() - soup.vertex_count;
      const std::string name = std::to_string(choice) + "_" + std::to_string(copies);
      corpora.add("seams", "compact_" + name, seams.payload + bytes_of({0x80 | choice, more}));
      std::vector<std::uint32_t> geometric;  // none where each vertex is its own
      for (std::uint32_t v = 0; more > 0 && v < soup.vertex_count; ++v) geometric.push_back(v);
      for (std::uint32_t v = 0; v < more; ++v) geometric.push_back(v * 7 % soup.vertex_count);
      corpora.add("seams", "plain_" + name, write_plain_seams(geometric) + bytes_of({choice, more}));
    }
  }
}

void make_groups(const Corpora& corpora) {
  const SpreadFaces spread(40, 90);
  for (const std::uint32_t count : {1U, 3U, 20U}) {
    std::vector<std::uint32_t> groups;
    for (std::uint32_t f = 0; f < spread.faces; ++f) groups.push_back(f / 4 % count * 100);
    const std::string name = std::to_string(count);
    corpora.add("face_groups", "plain_" + name, write_plain_groups(groups) + bytes_of({40, 90}));
    corpora.add("face_groups", "compact_" + name,
                write_face_groups(groups, spread.triangles, spread.vertices) + bytes_of({0x80 | 40, 90}));
  }
}

void make_order(const Corpora& corpora) {
  const SpreadFaces spread(40, 90);
  for (const bool is_scattered : {false, true}) {
    MeshOrder order{.vertices = std::vector<std::uint32_t>(spread.vertices),
                    .faces = std::vector<std::uint32_t>(spread.faces),
                    .rotation = std::vector<std::uint8_t>(spread.faces)};
    // 7 has no factor in common with either number.
    const std::uint32_t stride = is_scattered ? 7 : 1;
    for (std::uint32_t v = 0; v < spread.vertices; ++v) order.vertices[v] = v * stride % spread.vertices;
    for (std::uint32_t f = 0; f < spread.faces; ++f) {
      order.faces[f] = f * stride % spread.faces;
      order.rotation[f] = static_cast<std::uint8_t>(is_scattered ? f % 3 : 0);
    }
    corpora.add("order", is_scattered ? "scattered" : "rows",
                write_order(order, spread.triangles) + bytes_of({40, 90}));
  }
}

}  // namespace

void make_topology(const Corpora& corpora) {
  make_coder(corpora);
  make_connectivity(corpora);
  make_seams(corpora);
  make_groups(corpora);
  make_order(corpora);
}

}  // namespace deltamesh::fuzz
