// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/row.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "asset/coders/deltamesh.h"
#include "asset/coders/draco.h"
#include "asset/coders/meshopt.h"
#include "base/try.h"
#include "report/text.h"

namespace deltamesh::bench {
namespace {

void add_errors(const MeshError& ours, const MeshError& draco, AssetRow& row) {
  const auto add = [](double& ratio, double a, double b) {
    if (b > 0) ratio = std::max(ratio, a / b);
  };
  add(row.error_ratio[index_of(Part::kGeometry)], ours.rms, draco.rms);
  for (std::size_t part = index_of(Part::kNormals); part < kParts; ++part)
    add(row.error_ratio[part], ours.largest[part], draco.largest[part]);
  row.is_kept &= is_within(ours, draco);
}

/// Counts the mesh into `row`.
Result<OurMesh> measure_mesh(const AssetMesh& mesh, const DracoSetting& setting, int effort, AssetRow& row) {
  DELTAMESH_TRY(const CodedMesh draco, code_with_draco(mesh, setting));
  DELTAMESH_TRY(const std::uint64_t meshopt, meshopt_bytes(mesh, setting));
  OurMesh ours;
  ours.options = options_for(draco.error, effort);
  DELTAMESH_TRY(ours.sources, stream_sources(mesh));
  DELTAMESH_TRY(ours.coded, code_with_deltamesh(mesh, ours.sources, ours.options));
  for (std::size_t part = 0; part < kParts; ++part) {
    row.draco[part] += draco.bytes[part];
    row.ours[part] += ours.coded.bytes[part];
  }
  row.meshopt += meshopt;
  add_errors(ours.coded.error, draco.error, row);
  return ours;
}

/// Leaves out the displacements of morph targets; whether there were any.
bool leave_out_morph(Mesh& mesh) {
  return std::erase_if(mesh.attributes, [](const Attribute& attribute) {
           return part_of(attribute.kind, attribute.name) == Part::kMorph;
         }) > 0;
}

/// Codes the streams again without morph targets; false where none has any.
Result<bool> leave_out_morph(std::vector<OurMesh>& meshes) {
  bool had_any = false;
  for (OurMesh& mesh : meshes) {
    for (std::size_t s = 0; s < mesh.sources.size(); ++s) {
      if (!leave_out_morph(mesh.sources[s].merged.mesh)) continue;
      had_any = true;
      DELTAMESH_TRY(auto encoded, encode_stream(mesh.sources[s], mesh.options));
      mesh.coded.streams[s] = std::move(encoded.bytes);
    }
  }
  return had_any;
}

std::uint64_t total(const PartBytes& bytes, bool morph) {
  return sum(bytes) - (morph ? 0 : bytes[index_of(Part::kMorph)]);
}

}  // namespace

double AssetRow::ratio(bool morph) const {
  return static_cast<double>(total(ours, morph)) / static_cast<double>(total(draco, morph));
}

std::string name_of(const DracoSetting& setting) {
  return join({"(", std::to_string(setting.position_bits), ", ", std::to_string(setting.normal_bits), ", ",
               std::to_string(setting.uv_bits), ")"});
}

Result<AssetRow> measure_asset(const Asset& asset, const DracoSetting& setting, int effort, bool with_times) {
  AssetRow row{.asset = asset.name, .setting = setting, .vertices = asset.vertices};
  std::vector<OurMesh> ours;
  for (const AssetMesh& mesh : asset.meshes) {
    DELTAMESH_TRY(auto coded, measure_mesh(mesh, setting, effort, row));
    ours.push_back(std::move(coded));
  }
  if (with_times) {
    DELTAMESH_TRY(row.times, measure_times(asset, ours, setting));
    row.times_without_morph = row.times;
    DELTAMESH_TRY(const bool had_morph, leave_out_morph(ours));
    if (had_morph) {
      DELTAMESH_TRY(row.times_without_morph, measure_times(asset, ours, setting));
    }
  }
  return row;
}

}  // namespace deltamesh::bench
