// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The compact coder's time and bytes, chunk by chunk, beside the whole of Draco at level 7 in the same run.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "connectivity/faces/faces.h"
#include "deltamesh/io.h"
#include "highpass/anchor_list.h"
#include "highpass/delta_symbols.h"
#include "highpass/highpass.h"
#include "peers/peer.h"
#include "run/bench_mesh.h"
#include "scenes.h"
#include "support/or_exit.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {
namespace {

constexpr double kAnchorShare = 0.005;
constexpr int kDracoLevel = 7;
constexpr int kDracoBits = 11;

struct Settings {
  std::vector<std::string> files;
  std::string scene = "rooms";
  std::uint64_t vertices = 1'000'000;
  int bits = 8;
  int repeats = 5;
  bool draco = true;
};

/// Least processor seconds of `repeats` runs: what the work takes where nothing disturbs it.
template <class Work>
double least_seconds(int repeats, Work work) {
  double least = 1e30;
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t start = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

struct Row {
  const char* what;
  std::size_t bytes = 0;
  double encode = 0;  ///< seconds
  double decode = 0;
};

void print(const Row& row, std::size_t vertices) {
  const double n = static_cast<double>(vertices);
  std::printf("| %s | %zu | %.3f | %.0f | %.0f | %.2f | %.2f |\n", row.what, row.bytes,
              8 * static_cast<double>(row.bytes) / n, 1e9 * row.encode / n, 1e9 * row.decode / n,
              1e-6 * n / row.encode, 1e-6 * n / row.decode);
}

Row time_connectivity(const WeldedMesh& welded, const CodedConnectivity& coded, int repeats) {
  const auto vertices = static_cast<std::uint32_t>(welded.positions.size());
  const auto faces = static_cast<std::uint32_t>(welded.triangles.size() / 3);
  return {.what = "CONN",
          .bytes = coded.compact.size(),
          .encode = least_seconds(repeats, [&] { write_connectivity(welded.triangles, vertices); }),
          .decode = least_seconds(repeats, [&] {
            value_or_exit(read_connectivity(Payload::compact(coded.compact), vertices, faces));
          })};
}

Row time_deltas(std::span<const std::byte> bytes, const Adjacency& graph, int repeats) {
  const auto deltas = value_or_exit(read_compact_deltas(bytes, graph));
  return {.what = "DELT",
          .bytes = bytes.size(),
          .encode = least_seconds(repeats, [&] { write_compact_deltas(deltas, graph); }),
          .decode = least_seconds(repeats, [&] { value_or_exit(read_compact_deltas(bytes, graph)); })};
}

Row time_anchors(std::span<const std::byte> bytes, std::uint32_t count, int repeats) {
  const Payload payload = Payload::compact(bytes);
  const AnchorList list = value_or_exit(read_anchors(payload, count));
  return {.what = "ANCH",
          .bytes = bytes.size(),
          .encode = least_seconds(repeats, [&] { write_compact_anchors(list); }),
          .decode = least_seconds(repeats, [&] { value_or_exit(read_anchors(payload, count)); })};
}

Row time_draco(const Mesh& mesh, int repeats) {
  const auto peer = make_draco_peer(kDracoLevel, kDracoBits);
  check_or_exit(peer->load(mesh));
  std::vector<std::byte> bytes;
  Row row{.what = "all of Draco cl 7, qp 11"};
  row.encode = least_seconds(repeats, [&] { bytes = value_or_exit(peer->encode()); });
  row.decode = least_seconds(repeats, [&] { check_or_exit(peer->decode(bytes)); });
  row.bytes = bytes.size();
  return row;
}

void add(Row& sum, const Row& row) {
  sum.bytes += row.bytes;
  sum.encode += row.encode;
  sum.decode += row.decode;
}

void run_mesh(const std::string& name, const Mesh& loaded, const Settings& settings) {
  const Mesh mesh = welded_geometry(loaded);
  const WeldedMesh welded = weld(mesh);
  const auto vertices = static_cast<std::uint32_t>(welded.positions.size());
  const CodedConnectivity coded = write_connectivity(welded.triangles, vertices);
  const Adjacency graph = build_adjacency(coded.triangles, vertices);
  const Components components = find_components(graph);
  std::vector<Vec3> positions;
  for (const std::uint32_t v : coded.vertex_order) positions.push_back(welded.positions[v]);
  AnchorSequence anchors(graph, components);
  HighpassCoder coder(graph, components, anchors, positions, welded.box);
  const CodedHighpass geometry = value_or_exit(coder.code_only(
      {.step = coder.step_for_bits(settings.bits),
       .anchors = static_cast<std::uint32_t>(kAnchorShare * static_cast<double>(vertices)) + 1}));
  const SolvedPart part = extract_solved_part(graph, components);

  std::printf("%s, %u vertices, %d bits:\n\n", name.c_str(), vertices, settings.bits);
  std::printf(
      "| chunk | bytes | bits/vertex | encode ns/vertex | decode ns/vertex | encode M/s | decode M/s |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  Row all{.what = "all three"};
  for (const Row& row :
       {time_connectivity(welded, coded, settings.repeats),
        time_deltas(geometry.compact_deltas, part.graph, settings.repeats),
        time_anchors(geometry.compact_anchors, geometry.parameters.anchors, settings.repeats)}) {
    print(row, vertices);
    add(all, row);
  }
  print(all, vertices);
  if (settings.draco) print(time_draco(mesh, settings.repeats), vertices);
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh;
  bench::Settings settings;
  CLI::App app("Times the compact coder's chunks beside Draco.");
  app.add_option("files", settings.files, "Meshes; without any a generated scene");
  app.add_option("--scene", settings.scene, "Which scene")->capture_default_str();
  app.add_option("--vertices", settings.vertices, "How large a scene")
      ->check(CLI::Range(kMinSceneVertices, kMaxSceneVertices));
  app.add_option("--bits", settings.bits, "Of the delta quantiser")->check(CLI::Range(3, 16));
  app.add_option("--repeat", settings.repeats, "Runs per time; the least counts")->check(CLI::Range(1, 1000));
  app.add_flag("!--no-draco", settings.draco, "Ours only");
  CLI11_PARSE(app, argc, argv);
  if (settings.files.empty()) {
    const auto scene = scene_of_name(settings.scene);
    if (!scene) return std::fprintf(stderr, "no scene %s\n", settings.scene.c_str()), 2;
    bench::run_mesh(settings.scene, bench::value_or_exit(generate_scene(*scene, settings.vertices, 1)),
                    settings);
  }
  for (const std::string& file : settings.files)
    bench::run_mesh(file, bench::value_or_exit(read_mesh_file(file)).mesh, settings);
}
