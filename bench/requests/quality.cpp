// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "requests/quality.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "base/try.h"
#include "deltamesh/encode.h"
#include "deltamesh/io.h"
#include "report/table.h"
#include "report/text.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

constexpr std::string_view kMeshes[] = {
    "models/armadillo_43k", "models/fandisk",    "models/laurana50k",        "models/nefertiti_50k",
    "models/rocker_arm",    "paper/bunny_34834", "paper/happy_buddha_49990", "paper/armadillo_18245",
    "paper/horse_4243",     "paper/laurana_6301"};
constexpr std::string_view kMap = "robot/kitchen_tsdf_20mm";

struct NamedRequest {
  std::string name;
  QualityRequest request;
};

/// What was achieved over what was asked; 0 where nothing was.
struct Loads {
  double vde = 0;
  double lfe = 0;
  double largest = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;  ///< processor time of the encoder
};

std::vector<NamedRequest> usual_requests() {
  std::vector<NamedRequest> requests;
  const auto bound = [](double percent) {
    return QualityBound{.value = percent, .unit = QualityUnit::kDiagonal};
  };
  const auto name = [](const char* what, double percent) {
    return join({what, " ", significant(percent, 6), " % of diagonal"});
  };
  for (const double percent : {0.2, 0.05, 0.01})
    requests.push_back({name("VDE", percent), {.vde = bound(percent)}});
  for (const double percent : {0.5, 0.1, 0.02}) {
    requests.push_back({name("LFE", percent), {.lfe = bound(percent)}});
    requests.push_back({name("VDE 0.02 %, LFE", percent), {.vde = bound(0.02), .lfe = bound(percent)}});
  }
  for (const double percent : {0.5, 0.05})
    requests.push_back({name("largest error", percent), {.max_error = bound(percent)}});
  return requests;
}

/// `options`: bounds in percent of the diagonal.
Result<Loads> measure_request(const Mesh& mesh, const EncodeOptions& options) {
  const double start = processor_seconds();
  DELTAMESH_TRY(const Encoded encoded, encode(mesh, options));
  Loads loads{.bytes = encoded.bytes.size(), .seconds = processor_seconds() - start};
  const Quality& quality = encoded.report.stream.quality;
  const QualityRequest& asked = options.quality;
  const double percent = 0.01 * encoded.report.stream.diagonal;
  if (asked.vde) loads.vde = quality.vde_rms / (percent * asked.vde->value);
  if (asked.lfe) loads.lfe = quality.lfe_rms / (percent * asked.lfe->value);
  if (asked.max_error) loads.largest = quality.max_error / (percent * asked.max_error->value);
  return loads;
}

Result<void> print_requests(const MeshSource& source) {
  DELTAMESH_TRY(const Mesh mesh, source.load());
  const auto containers = std::make_shared<AnchorContainers>();
  for (const auto& [name, request] : usual_requests()) {
    DELTAMESH_TRY(const Loads loads,
                  measure_request(mesh, {.quality = request, .anchor_containers = containers}));
    print(table_row({source.name, name, fixed(loads.vde, 3), fixed(loads.lfe, 3), fixed(loads.largest, 3),
                     number(loads.bytes), fixed(loads.seconds, 2)}));
  }
  return {};
}

Result<void> print_efforts(const MeshSource& source) {
  print(join({"\n## Effort 0 and 1 on ", source.name, "\n\n"}) +
        table_head({"request", "s at 0", "s at 1", "times", "bytes at 0", "bytes at 1"}));
  DELTAMESH_TRY(const Mesh mesh, source.load());
  for (const auto& [name, request] : usual_requests()) {
    DELTAMESH_TRY(const Loads quick, measure_request(mesh, {.quality = request, .effort = 0}));
    DELTAMESH_TRY(const Loads usual, measure_request(mesh, {.quality = request, .effort = 1}));
    print(table_row({name, fixed(quick.seconds, 2), fixed(usual.seconds, 2),
                     fixed(usual.seconds / quick.seconds, 1), number(quick.bytes), number(usual.bytes)}));
  }
  return {};
}

/// Everything that can be read, sequences included.
Result<void> print_largest_errors(const std::string& corpus) {
  namespace fs = std::filesystem;
  print("\n## A largest error of 0.1 % of the diagonal, every mesh of the corpus\n\n" +
        table_head({"mesh", "achieved / asked", "bytes", "s"}));
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(corpus, error))
    if (entry.is_regular_file() && format_of_path(entry.path().string())) paths.push_back(entry.path());
  std::ranges::sort(paths);
  double worst = 0;
  for (const fs::path& path : paths) {
    DELTAMESH_TRY(const Mesh mesh, load_mesh(path.string()));
    DELTAMESH_TRY(
        const Loads loads,
        measure_request(
            mesh, {.quality = {.max_error = QualityBound{.value = 0.1, .unit = QualityUnit::kDiagonal}}}));
    worst = std::max(worst, loads.largest);
    print(table_row({fs::relative(path, corpus).string(), fixed(loads.largest, 3), number(loads.bytes),
                     fixed(loads.seconds, 2)}));
  }
  print(join({"\nlargest of all: ", fixed(worst, 6), "\n"}));
  return {};
}

}  // namespace

Result<void> print_quality(const Choice& choice, bool all) {
  if (all) return print_largest_errors(choice.corpus);
  print("\n## Achieved over asked\n\n" +
        table_head({"mesh", "request", "VDE", "LFE", "largest", "bytes", "s"}, 2));
  const auto is_quick = [](const std::string& name) { return is_quick_mesh(name); };
  const std::vector<MeshSource> sources = chosen_meshes(choice, is_quick);
  for (const MeshSource& source : sources)
    if (std::ranges::count(kMeshes, source.name) != 0) DELTAMESH_CHECK(print_requests(source));
  for (const MeshSource& source : sources)
    if (source.name == kMap) DELTAMESH_CHECK(print_efforts(source));
  return {};
}

}  // namespace deltamesh::bench
