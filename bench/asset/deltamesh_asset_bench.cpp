// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole glTF assets beside Draco at equal errors of every attribute: bytes, where they go, and times.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "asset/asset_report.h"
#include "asset/asset_row.h"
#include "asset/asset_source.h"
#include "deltamesh/io.h"

namespace deltamesh::bench {
namespace {

constexpr DracoSetting kCoarse{.position_bits = 12, .normal_bits = 8, .uv_bits = 10};
constexpr DracoSetting kFine{.position_bits = 14, .normal_bits = 10, .uv_bits = 12};
constexpr std::uint64_t kGeneratedVertices = 4000;

struct Options {
  std::vector<std::string> files;
  std::string corpus;
  std::string assets = ".";
  std::string setting = "both";
  std::string out;
  int effort = 5;
  bool quick = false;
  bool with_times = true;
};

/// The files, else the corpus, else what we can make ourselves.
std::vector<AssetSource> chosen_assets(const Options& options) {
  std::vector<AssetSource> sources;
  for (const std::string& file : options.files) sources.push_back(asset_file(file));
  if (!sources.empty()) return sources;
  const std::regex wanted(options.assets);
  for (const AssetSource& source : corpus_assets(options.corpus))
    if (std::regex_search(source.name, wanted) && (!options.quick || is_quick_asset(source)))
      sources.push_back(source);
  if (sources.empty()) {
    std::fprintf(stderr, "no assets in %s: measuring a generated one\n", options.corpus.c_str());
    sources.push_back(generated_asset(kGeneratedVertices));
  }
  return sources;
}

std::vector<DracoSetting> chosen_settings(const Options& options) {
  if (options.setting == "12") return {kCoarse};
  if (options.setting == "14") return {kFine};
  return {kCoarse, kFine};
}

bool write_text(const std::filesystem::path& path, const std::string& text) {
  const auto written = write_file(path.string(), std::as_bytes(std::span(text)));
  if (!written) std::fprintf(stderr, "%s: %s\n", path.c_str(), describe(written.error()).c_str());
  return written.has_value();
}

bool write_reports(const std::string& folder, const std::vector<AssetRow>& rows) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return write_text(std::filesystem::path(folder) / "assets.csv", render_asset_csv(rows)) &&
         write_text(std::filesystem::path(folder) / "assets.md", render_asset_markdown(rows));
}

int run(const Options& options) {
  std::vector<AssetRow> rows;
  bool failed = false;
  for (const AssetSource& source : chosen_assets(options)) {
    const auto asset = source.load();
    if (!asset) {
      std::fprintf(stderr, "%s: %s\n", source.name.c_str(), describe(asset.error()).c_str());
      failed = true;
      continue;
    }
    for (const DracoSetting& setting : chosen_settings(options)) {
      auto row = measure_asset(*asset, setting, options.effort, options.with_times);
      if (!row) {
        std::fprintf(stderr, "%s: %s\n", source.name.c_str(), describe(row.error()).c_str());
        failed = true;
        continue;
      }
      std::fprintf(stderr, "%s %s: %.3f\n", source.name.c_str(), name_of(setting).c_str(), row->ratio(true));
      rows.push_back(*std::move(row));
    }
  }
  std::fputs(render_asset_markdown(rows).c_str(), stdout);
  if (!options.out.empty()) failed |= !write_reports(options.out, rows);
  return failed || rows.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  deltamesh::bench::Options options;
  const char* corpus = std::getenv("DELTAMESH_CORPUS");
  options.corpus = corpus != nullptr ? corpus : "../shared/corpus";
  CLI::App app("Compares whole glTF assets with Draco at equal errors of every attribute.");
  app.add_option("files", options.files, "GLB or glTF files; default: those of the corpus");
  app.add_option("--corpus", options.corpus, "Folder with gltf/ and formats/")->capture_default_str();
  app.add_option("--assets", options.assets, "Only assets whose name has a match of this regular expression");
  app.add_option("--setting", options.setting, "Draco's position bits: 12, 14 or both")
      ->check(CLI::IsMember({"12", "14", "both"}))
      ->capture_default_str();
  app.add_option("--effort", options.effort, "Of our encoder")->check(CLI::Range(0, 9));
  app.add_option("--out", options.out, "Folder for assets.csv and assets.md");
  app.add_flag("--quick", options.quick, "Three assets only");
  app.add_flag("!--no-times", options.with_times, "Leave out the times");
  CLI11_PARSE(app, argc, argv);
  return deltamesh::bench::run(options);
}
