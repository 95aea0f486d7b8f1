// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Whole glTF assets beside Draco at equal errors of every attribute: bytes, where they go, and times.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "asset/report.h"
#include "asset/row.h"
#include "asset/source.h"
#include "report/files.h"
#include "report/table.h"
#include "support/command_line.h"

namespace deltamesh::bench {
namespace {

constexpr DracoSetting kCoarse{.position_bits = 12, .normal_bits = 8, .uv_bits = 10};
constexpr DracoSetting kFine{.position_bits = 14, .normal_bits = 10, .uv_bits = 12};
constexpr std::uint64_t kGeneratedVertices = 4000;

struct Options {
  Choice choice;
  std::vector<std::string> files;
  std::string setting = "both";
  std::string out;
  int effort = 1;
  bool with_times = true;
};

/// The files, else the corpus, else what we can make ourselves.
std::vector<AssetSource> chosen_assets(const Options& options) {
  std::vector<AssetSource> sources;
  for (const std::string& file : options.files) sources.push_back(asset_file(file));
  if (!sources.empty()) return sources;
  sources = corpus_assets(options.choice.corpus);
  keep_chosen(sources, options.choice, is_quick_asset);
  if (sources.empty()) {
    std::fprintf(stderr, "no assets in %s: measuring a generated one\n", options.choice.corpus.c_str());
    sources.push_back(generated_asset(kGeneratedVertices));
  }
  return sources;
}

std::vector<DracoSetting> chosen_settings(const Options& options) {
  if (options.setting == "12") return {kCoarse};
  if (options.setting == "14") return {kFine};
  return {kCoarse, kFine};
}

int run(const Options& options) {
  std::vector<AssetRow> rows;
  bool failed = false;
  const auto fail = [&](const std::string& name, const Error& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), describe(error).c_str());
    failed = true;
  };
  for (const AssetSource& source : chosen_assets(options)) {
    const auto asset = source.load();
    if (!asset) fail(source.name, asset.error());
    if (!asset) continue;
    for (const DracoSetting& setting : chosen_settings(options)) {
      auto row = measure_asset(*asset, setting, options.effort, options.with_times);
      if (!row) fail(source.name, row.error());
      if (!row) continue;
      std::fprintf(stderr, "%s %s: %.3f\n", source.name.c_str(), name_of(setting).c_str(), row->ratio(true));
      rows.push_back(*std::move(row));
    }
  }
  const std::string report = render_asset_markdown(rows);
  print(report);
  if (!options.out.empty())
    failed |= !write_text(options.out, "assets.csv", render_asset_csv(rows)) ||
              !write_text(options.out, "assets.md", report);
  return failed || rows.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh::bench;
  Options options;
  CLI::App app("Compares whole glTF assets with Draco at equal errors of every attribute.");
  add_choice(app, options.choice, "--assets", "Three assets only");
  app.add_option("files", options.files, "GLB or glTF files; default: those of the corpus");
  app.add_option("--setting", options.setting, "Draco's position bits: 12, 14 or both")
      ->check(CLI::IsMember({"12", "14", "both"}))
      ->capture_default_str();
  app.add_option("--effort", options.effort, "Of our encoder")->check(CLI::Range(0, 2));
  app.add_option("--out", options.out, "Folder for assets.csv and assets.md");
  app.add_flag("!--no-times", options.with_times, "Leave out the times");
  return parse_and_run(app, argc, argv, [&] { return run(options); });
}
