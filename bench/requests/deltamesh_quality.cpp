// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Prints how well quality on request does: how near achieved figures come to those asked for, that a largest
// error is never exceeded, what effort, kept anchors, error diffusion and frugal symbols bring.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "deltamesh/io.h"
#include "requests/coder_study.h"
#include "requests/request_study.h"
#include "support/coding_order.h"

namespace {

using namespace deltamesh;
namespace fs = std::filesystem;

constexpr const char* kMeshes[] = {"paper/armadillo_18245", "paper/bunny_34834",  "paper/happy_buddha_49990",
                                   "paper/horse_4243",      "paper/laurana_6301", "models/armadillo_43k",
                                   "models/fandisk",        "models/laurana50k",  "models/nefertiti_50k",
                                   "models/rocker_arm"};
constexpr const char* kDiffused[] = {"models/nefertiti_50k", "paper/bunny_34834", "models/armadillo_43k"};
constexpr const char* kFrugal[] = {"paper/horse_4243", "paper/bunny_34834",      "models/nefertiti_50k",
                                   "models/fandisk",   "robot/building_sim_50k", "robot/kitchen_tsdf_20mm"};
constexpr const char* kMap = "robot/kitchen_tsdf_20mm";
constexpr double kStrength = 0.8;
constexpr double kRateWeight = 0.12;

bool fail(const std::string& what, const Error& error) {
  std::fprintf(stderr, "%s: %s\n", what.c_str(), describe(error).c_str());
  return false;
}

bool load(const std::string& path, Mesh& mesh) {
  auto imported = read_mesh_file(path);
  if (!imported) return fail(path, imported.error());
  mesh = std::move(imported->mesh);
  return true;
}

bool print_requests(const std::string& corpus) {
  std::printf("\n## Achieved over asked\n\n");
  std::printf("| mesh | request | VDE | LFE | largest | bytes | s |\n|---|---|---|---|---|---|---|\n");
  for (const char* name : kMeshes) {
    Mesh mesh;
    if (!load(corpus + "/" + name + ".ply", mesh)) return false;
    const double diagonal = bench::diagonal_of(mesh);
    const auto containers = std::make_shared<AnchorContainers>();
    for (const bench::NamedRequest& request : bench::usual_requests(mesh, diagonal)) {
      const auto figures = bench::measure_request(
          mesh, diagonal, {.quality = request.request, .anchor_containers = containers});
      if (!figures) return fail(name, figures.error());
      std::printf("| %s | %s | %.3f | %.3f | %.3f | %llu | %.2f |\n", name, request.name.c_str(),
                  figures->vde_load, figures->lfe_load, figures->max_load,
                  static_cast<unsigned long long>(figures->bytes), figures->seconds);
    }
  }
  return true;
}

std::vector<std::string> all_meshes(const std::string& corpus) {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(corpus, error))
    if (entry.is_regular_file() && format_of_path(entry.path().string()))
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool print_largest_errors(const std::string& corpus) {
  std::printf("\n## A largest error of 0.1 %% of the diagonal, every mesh of the corpus\n\n");
  std::printf("| mesh | achieved / asked | bytes | s |\n|---|---|---|---|\n");
  double worst = 0;
  for (const std::string& path : all_meshes(corpus)) {
    Mesh mesh;
    if (!load(path, mesh)) return false;
    const double diagonal = bench::diagonal_of(mesh);
    const auto figures =
        bench::measure_request(mesh, diagonal, {.quality = {.max_error = QualityBound{diagonal / 1000}}});
    if (!figures) return fail(path, figures.error());
    worst = std::max(worst, figures->max_load);
    std::printf("| %s | %.3f | %llu | %.2f |\n", fs::relative(path, corpus).c_str(), figures->max_load,
                static_cast<unsigned long long>(figures->bytes), figures->seconds);
  }
  std::printf("\nlargest of all: %.6f\n", worst);
  return true;
}

bool print_efforts(const std::string& corpus) {
  std::printf(
      "\n## Effort 0 and 5 on %s\n\n| request | s at 0 | s at 5 | times | bytes at 0 | bytes at 5 |\n", kMap);
  std::printf("|---|---|---|---|---|---|\n");
  Mesh mesh;
  if (!load(corpus + "/" + kMap + ".ply", mesh)) return false;
  const double diagonal = bench::diagonal_of(mesh);
  for (const bench::NamedRequest& request : bench::usual_requests(mesh, diagonal)) {
    const auto quick = bench::measure_request(mesh, diagonal, {.quality = request.request, .effort = 0});
    if (!quick) return fail(kMap, quick.error());
    const auto usual = bench::measure_request(mesh, diagonal, {.quality = request.request, .effort = 5});
    if (!usual) return fail(kMap, usual.error());
    std::printf("| %s | %.2f | %.2f | %.1f | %llu | %llu |\n", request.name.c_str(), quick->seconds,
                usual->seconds, usual->seconds / quick->seconds,
                static_cast<unsigned long long>(quick->bytes), static_cast<unsigned long long>(usual->bytes));
  }
  return true;
}

/// What a second request on the same mesh spends on anchors that are found already.
bool print_containers(const std::string& corpus) {
  std::printf("\n## Finding the anchors of v = 15 .. 5, then again from what is kept\n\n");
  std::printf("| mesh | first, ms | second, ms | share |\n|---|---|---|---|\n");
  for (const char* name : kDiffused) {
    const auto mesh = bench::load_in_coding_order(corpus + "/" + name + ".ply");
    if (!mesh) return fail(name, mesh.error());
    const bench::ContainerFigures figures = bench::time_containers(*mesh);
    std::printf("| %s | %.2f | %.4f | %.2f %% |\n", name, 1e3 * figures.first, 1e3 * figures.second,
                100 * figures.second / figures.first);
  }
  return true;
}

bool print_diffusion(const std::string& corpus) {
  std::printf("\n## Error diffusion (strength %g) at equal bytes, 0.2 %% anchors of 16 bits\n\n", kStrength);
  std::printf(
      "| mesh | bits | bytes plain | diffused | LFE falls | VDE rises |\n|---|---|---|---|---|---|\n");
  for (const char* name : kDiffused) {
    const auto mesh = bench::load_in_coding_order(corpus + "/" + name + ".ply");
    if (!mesh) return fail(name, mesh.error());
    for (const int bits : {5, 7}) {
      const auto both = bench::compare_diffusion(*mesh, bits, kStrength);
      if (!both) return fail(name, both.error());
      std::printf("| %s | %d | %llu | %llu | %.2f x | %.1f %% |\n", name, bits,
                  static_cast<unsigned long long>(both->plain.bytes),
                  static_cast<unsigned long long>(both->other.bytes),
                  both->plain.quality.lfe_rms / both->other.quality.lfe_rms,
                  100 * (both->other.quality.vde_rms / both->plain.quality.vde_rms - 1));
    }
  }
  return true;
}

bool print_frugal(const std::string& corpus) {
  std::printf("\n## Symbols by price (weight %g) at equal VDE: bytes of deltas and anchors\n\n", kRateWeight);
  std::printf("| mesh | 3 bits | 4 | 5 | 6 |\n|---|---|---|---|---|\n");
  for (const char* name : kFrugal) {
    const auto mesh = bench::load_in_coding_order(corpus + "/" + name + ".ply");
    if (!mesh) return fail(name, mesh.error());
    std::printf("| %s |", name);
    for (int bits = 3; bits <= 6; ++bits) {
      const auto both = bench::compare_frugal(*mesh, bits, kRateWeight);
      if (!both) return fail(name, both.error());
      std::printf(" %.3f |", static_cast<double>(both->other.bytes) / static_cast<double>(both->plain.bytes));
    }
    std::printf("\n");
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::string corpus;
  bool all = false;
  CLI::App app("Quality on request: how near, at what cost");
  app.add_option("--corpus", corpus, "folder with paper/, models/ and robot/")->required();
  app.add_flag("--all", all, "instead, keep a largest error on every mesh of the corpus");
  CLI11_PARSE(app, argc, argv);
  const bool done = all ? print_largest_errors(corpus)
                        : print_diffusion(corpus) && print_frugal(corpus) && print_efforts(corpus) &&
                              print_containers(corpus) && print_requests(corpus);
  return done ? 0 : 1;
}
