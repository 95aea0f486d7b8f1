// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/write_reports.h"

#include <algorithm>
#include <filesystem>
#include <span>

#include "deltamesh/io.h"
#include "report/csv.h"
#include "report/markdown.h"
#include "report/rate_distortion.h"

namespace deltamesh::bench {
namespace {

namespace fs = std::filesystem;

Result<void> write_text(const fs::path& path, const std::string& text) {
  return write_file(path.string(), std::as_bytes(std::span(text)));
}

}  // namespace

Result<void> write_reports(const Run& run, const std::string& folder) {
  const fs::path plots = fs::path(folder) / "plots";
  std::error_code error;
  fs::create_directories(plots, error);
  if (error) return Error{.code = ErrorCode::kFileWrite, .message = "cannot make the output folder"};
  if (auto written = write_text(fs::path(folder) / "results.csv", render_csv(run)); !written) return written;
  if (auto written = write_text(fs::path(folder) / "results.md", render_markdown(run)); !written)
    return written;
  for (const std::string& mesh : mesh_names(run)) {
    std::string stem = mesh;
    std::replace(stem.begin(), stem.end(), '/', '-');
    for (const ErrorKind& kind : kErrorKinds) {
      const auto plot = rate_distortion_plot(run, mesh, kind);
      if (!plot) continue;
      if (auto written = write_text(plots / (stem + "." + kind.slug + ".svg"), render_svg(*plot)); !written)
        return written;
    }
  }
  return {};
}

}  // namespace deltamesh::bench
