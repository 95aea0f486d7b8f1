// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Maps with colours at 8 bits a component beside Draco at level 10: whole files at equal VDE, colours exact,
// and the colours' part of them; colours alone, exact and within bounds.
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "deltamesh/encode.h"
#include "deltamesh/io.h"
#include "peers/peer.h"
#include "report/geometric_mean.h"
#include "run/bench_mesh.h"
#include "run/measure.h"
#include "support/or_exit.h"

namespace deltamesh::bench {
namespace {

constexpr int kLevel = 10;
constexpr std::array<double, 3> kBounds = {2, 4, 8};  ///< 255ths
constexpr int kBoundBits = 11;                        ///< Draco's position bits where bounds are tried

draco::GeometryAttribute layout(draco::GeometryAttribute::Type type, std::uint8_t components,
                                draco::DataType data_type, std::int64_t size, bool normalized) {
  draco::GeometryAttribute layout;
  layout.Init(type, nullptr, static_cast<std::int8_t>(components), data_type, normalized, size, 0);
  return layout;
}

void add_values(draco::Mesh& mesh, const draco::GeometryAttribute& layout,
                std::span<const std::byte> values) {
  const std::size_t size = values.size() / mesh.num_points();
  draco::PointAttribute& attribute = *mesh.attribute(mesh.AddAttribute(layout, true, mesh.num_points()));
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i)
    attribute.SetAttributeValue(draco::AttributeValueIndex(i), values.data() + i * size);
}

/// Bytes of `mesh` coded by Draco, with its first attribute if `colors`.
std::size_t draco_bytes(const Mesh& mesh, int position_bits, bool colors) {
  draco::Mesh input;
  input.set_num_points(static_cast<std::uint32_t>(mesh.vertex_count()));
  input.SetNumFaces(mesh.triangle_count());
  for (std::uint32_t f = 0; f < mesh.triangle_count(); ++f) {
    const std::uint32_t* corners = mesh.triangles.data() + std::size_t{3} * f;
    input.SetFace(draco::FaceIndex(f), {draco::PointIndex(corners[0]), draco::PointIndex(corners[1]),
                                        draco::PointIndex(corners[2])});
  }
  add_values(input, layout(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32, 12, false),
             std::as_bytes(std::span(mesh.positions)));
  if (colors) {
    const Attribute& color = mesh.attributes.front();
    add_values(
        input,
        layout(draco::GeometryAttribute::COLOR, color.components, draco::DT_UINT8, color.components, true),
        color.values);
  }
  draco::Encoder encoder;
  encoder.SetSpeedOptions(10 - kLevel, 10 - kLevel);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, position_bits);
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(input, &buffer).ok()) std::exit(EXIT_FAILURE);
  return buffer.size();
}

double ratio(std::uint64_t a, std::uint64_t b) { return static_cast<double>(a) / static_cast<double>(b); }

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

/// Prints the rows of whole files; nothing for a mesh without 8-bit colours.
std::optional<ColorRow> run_mesh(const std::string& name, Mesh mesh, bool whole_files) {
  std::erase_if(mesh.attributes, [](const Attribute& a) {
    return a.kind != AttributeKind::kColor || a.type != ComponentType::kU8;
  });
  if (mesh.attributes.empty()) return std::nullopt;
  mesh.attributes.resize(1);
  const Mesh geometry = welded_geometry(mesh);
  ColorRow row{.mesh = name, .draco = 0, .exact = 0, .bounded = {}};
  for (const int bits : {9, 10, 11, 12}) {
    if (!whole_files && bits != kBoundBits) continue;
    const auto peer = make_draco_peer(kLevel, bits);
    const Measurement draco = value_or_exit(measure(*peer, name, geometry, {.repeats = 1, .seconds = 0}));
    EncodeOptions options;
    options.quality.vde = QualityBound{.value = draco.quality.vde_rms, .unit = QualityUnit::kModel};
    const std::size_t whole = draco_bytes(mesh, bits, true);
    const std::size_t colors = whole - draco_bytes(mesh, bits, false);
    if (bits == kBoundBits) {
      row.draco = colors;
      row.exact = coded_colors(mesh, options, 0).coded_bytes;
      for (std::size_t i = 0; i < kBounds.size(); ++i)
        row.bounded[i] = coded_colors(mesh, options, kBounds[i]);
    }
    if (!whole_files) continue;
    const StreamInfo ours = value_or_exit(encode(mesh, options)).report.stream;
    std::printf("| %s | %d | %llu | %zu | %.3f | %llu | %zu | %.3f |\n", name.c_str(), bits,
                static_cast<unsigned long long>(ours.bytes), whole, ratio(ours.bytes, whole),
                static_cast<unsigned long long>(ours.attribute_bytes), colors,
                ratio(ours.attribute_bytes, colors));
    std::fflush(stdout);
  }
  return row;
}

/// Bytes of colours, exact over Draco's and bounded over exact, with their geometric means.
void print_colors(const std::vector<ColorRow>& rows) {
  std::printf("\nColours alone, positions as Draco's at %d bits:\n\n| mesh | Draco | exact | ratio |",
              kBoundBits);
  for (const double bound : kBounds) std::printf(" within %.0f | reached | of exact |", bound);
  std::printf("\n|---|---|---|---|");
  for (std::size_t i = 0; i < kBounds.size(); ++i) std::printf("---|---|---|");
  std::array<GeometricMean, 1 + kBounds.size()> means;
  for (const ColorRow& row : rows) {
    std::printf("\n| %s | %llu | %llu | %.3f |", row.mesh.c_str(), static_cast<unsigned long long>(row.draco),
                static_cast<unsigned long long>(row.exact), ratio(row.exact, row.draco));
    means[0].add(ratio(row.exact, row.draco));
    for (std::size_t i = 0; i < kBounds.size(); ++i) {
      const AttributeInfo& colors = row.bounded[i];
      means[1 + i].add(ratio(colors.coded_bytes, row.exact));
      std::printf(" %llu | %.0f | %.3f |", static_cast<unsigned long long>(colors.coded_bytes), colors.error,
                  ratio(colors.coded_bytes, row.exact));
    }
  }
  std::printf("\n\nGeometric means: exact over Draco's %.3f", means[0].value().value_or(0));
  for (std::size_t i = 0; i < kBounds.size(); ++i)
    std::printf("; within %.0f of exact %.3f", kBounds[i], means[1 + i].value().value_or(0));
  std::printf(".\n");
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh;
  std::vector<std::string> files;
  bool colors_alone = false;
  CLI::App app("Compares coloured meshes with Draco at equal VDE, colours exact and within bounds.");
  app.add_option("files", files, "Meshes with 8-bit colours")->required();
  app.add_flag("--colors", colors_alone, "Colours alone");
  CLI11_PARSE(app, argc, argv);
  if (!colors_alone)
    std::printf(
        "| mesh | qp | bytes | Draco | ratio | colours | Draco's | ratio "
        "|\n|---|---|---|---|---|---|---|---|\n");
  std::vector<bench::ColorRow> rows;
  for (const std::string& file : files)
    if (const auto row = bench::run_mesh(std::filesystem::path(file).stem().string(),
                                         bench::value_or_exit(read_mesh_file(file)).mesh, !colors_alone))
      rows.push_back(*row);
  bench::print_colors(rows);
}
