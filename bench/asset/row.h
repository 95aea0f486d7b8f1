// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One asset at one setting.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "asset/part.h"
#include "asset/source.h"
#include "asset/times.h"
#include "deltamesh/result.h"
#include "peers/draco_mesh.h"

namespace deltamesh::bench {

struct AssetRow {
  std::string asset;
  DracoSetting setting;
  std::uint64_t vertices = 0;
  PartBytes ours{};
  PartBytes draco{};
  std::uint64_t meshopt = 0;  ///< without morph targets
  /// The error of the mesh that comes nearest to Draco's there, over Draco's; 0: exact. Geometry: of the rms.
  std::array<double, kParts> error_ratio{};
  bool is_kept = true;  ///< no error of any mesh is above Draco's
  AssetTimes times{};   ///< zeros where they were not asked for
  /// Likewise of streams without morph targets, so that both codecs do the same work; the same where the
  /// asset has none.
  AssetTimes times_without_morph{};

  /// With morph targets, or without.
  double ratio(bool morph) const;
};

/// The setting's name: "(12, 8, 10)".
std::string name_of(const DracoSetting& setting);

/// Codes all meshes of the asset: Draco first, then ours at its errors. Errors: of the codecs.
Result<AssetRow> measure_asset(const Asset& asset, const DracoSetting& setting, int effort, bool with_times);

}  // namespace deltamesh::bench
