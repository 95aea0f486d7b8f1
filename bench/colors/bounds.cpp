// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "colors/bounds.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "colors/colors_alone.h"
#include "deltamesh/encode.h"
#include "peers/draco_mesh.h"
#include "peers/measure.h"
#include "report/geometric_mean.h"
#include "report/table.h"
#include "report/text.h"
#include "support/corpus.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr int kLevel = 10;
constexpr std::array<double, 3> kBounds = {2, 4, 8};  ///< 255ths
constexpr int kBits = 11;                             ///< of Draco's positions

/// Colours of one map alone.
struct ColorRow {
  std::string mesh;
  std::uint64_t draco = 0;
  std::uint64_t exact = 0;
  std::array<AttributeInfo, kBounds.size()> bounded;
};

/// The only attribute of `mesh`, coded within `bound`.
AttributeInfo coded_colors(const Mesh& mesh, EncodeOptions options, double bound) {
  options.attributes.color_error = bound;
  return value_or_exit(encode(mesh, options)).report.stream.attributes.front();
}

/// Nothing for a mesh without 8-bit colours.
std::optional<ColorRow> compare_mesh(const std::string& name, Mesh loaded) {
  const auto colored = colors_alone(std::move(loaded));
  if (!colored) return std::nullopt;
  const Mesh& mesh = *colored;
  const auto draco = value_or_exit(measure(*make_draco_peer(kLevel, kBits), name, welded_geometry(mesh)));
  EncodeOptions options;
  options.quality.vde = QualityBound{.value = draco.quality.vde_rms};
  const auto draco_bytes = [&](std::optional<std::size_t> left_out) {
    return value_or_exit(encode_draco(*to_draco(mesh, left_out), {.position_bits = kBits}, kLevel)).size();
  };
  ColorRow row{.mesh = name,
               .draco = draco_bytes(std::nullopt) - draco_bytes(0),
               .exact = coded_colors(mesh, options, 0).coded_bytes,
               .bounded = {}};
  for (std::size_t i = 0; i < kBounds.size(); ++i) row.bounded[i] = coded_colors(mesh, options, kBounds[i]);
  return row;
}

/// Bytes of colours, exact over Draco's and bounded over exact, with their geometric means.
void print_colors(const std::vector<ColorRow>& rows) {
  print(join({"Colours alone, positions as Draco's at ", number(kBits), " bits:\n\n"}));
  Cells names{"mesh", "Draco", "exact", "ratio"};
  for (const double bound : kBounds)
    names.insert(names.end(), {"within " + fixed(bound, 0), "reached", "of exact"});
  print(table_head(names));
  std::array<GeometricMean, 1 + kBounds.size()> means;
  for (const ColorRow& row : rows) {
    const double exact = ratio(row.exact, row.draco);
    means[0].add(exact);
    Cells cells{row.mesh, number(row.draco), number(row.exact), fixed(exact, 3)};
    for (std::size_t i = 0; i < kBounds.size(); ++i) {
      const AttributeInfo& colors = row.bounded[i];
      means[1 + i].add(ratio(colors.coded_bytes, row.exact));
      cells.insert(cells.end(), {number(colors.coded_bytes), fixed(colors.error, 0),
                                 fixed(ratio(colors.coded_bytes, row.exact), 3)});
    }
    print(table_row(cells));
  }
  std::string text = "\nGeometric means: exact over Draco's " + fixed(means[0].value().value_or(0), 3);
  for (std::size_t i = 0; i < kBounds.size(); ++i)
    text +=
        join({"; within ", fixed(kBounds[i], 0), " of exact ", fixed(means[1 + i].value().value_or(0), 3)});
  print(text + ".\n");
}

}  // namespace

int compare_colors(const std::vector<std::string>& files) {
  std::vector<ColorRow> rows;
  for (const std::string& file : files) {
    auto mesh = value_or_exit(load_mesh(file));
    if (const auto row = compare_mesh(std::filesystem::path(file).stem().string(), std::move(mesh)))
      rows.push_back(*row);
  }
  print_colors(rows);
  return 0;
}

}  // namespace deltamesh::bench
