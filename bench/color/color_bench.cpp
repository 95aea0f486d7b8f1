// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Maps with colours at 8 bits a component, kept exactly, beside Draco at level 10: whole files at equal VDE,
// and the colours' part of them.
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "deltamesh/encode.h"
#include "deltamesh/io.h"
#include "peers/peer.h"
#include "run/bench_mesh.h"
#include "run/measure.h"

namespace deltamesh::bench {
namespace {

constexpr int kLevel = 10;

template <class R>
auto value_or_exit(R result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", describe(result.error()).c_str());
    std::exit(EXIT_FAILURE);
  }
  return *std::move(result);
}

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

void run_mesh(const std::string& name, Mesh mesh) {
  std::erase_if(mesh.attributes, [](const Attribute& a) {
    return a.kind != AttributeKind::kColor || a.type != ComponentType::kU8;
  });
  if (mesh.attributes.empty()) return;
  const Mesh geometry = welded_geometry(mesh);
  for (const int bits : {9, 10, 11, 12}) {
    const auto peer = make_draco_peer(kLevel, bits);
    const Measurement draco = value_or_exit(measure(*peer, name, geometry, {}));
    EncodeOptions options;
    options.quality.vde = QualityBound{.value = draco.quality.vde_rms, .unit = QualityUnit::kModel};
    const StreamInfo ours = value_or_exit(encode(mesh, options)).report.stream;
    const std::size_t whole = draco_bytes(mesh, bits, true);
    const std::size_t colors = whole - draco_bytes(mesh, bits, false);
    const auto ratio = [](std::uint64_t a, std::size_t b) {
      return static_cast<double>(a) / static_cast<double>(b);
    };
    std::printf("| %s | %d | %llu | %zu | %.3f | %llu | %zu | %.3f |\n", name.c_str(), bits,
                static_cast<unsigned long long>(ours.bytes), whole, ratio(ours.bytes, whole),
                static_cast<unsigned long long>(ours.attribute_bytes), colors,
                ratio(ours.attribute_bytes, colors));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace deltamesh::bench

int main(int argc, char** argv) {
  using namespace deltamesh;
  std::vector<std::string> files;
  CLI::App app("Compares coloured meshes with Draco at equal VDE, colours exact.");
  app.add_option("files", files, "Meshes with 8-bit colours")->required();
  CLI11_PARSE(app, argc, argv);
  std::printf(
      "| mesh | qp | bytes | Draco | ratio | colours | Draco's | ratio "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& file : files)
    bench::run_mesh(file, bench::value_or_exit(read_mesh_file(file)).mesh);
}
