// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How long an asset takes to decode and to encode, beside Draco.
#pragma once

#include <vector>

#include "asset/coders/deltamesh.h"
#include "asset/mesh_error.h"
#include "asset/source.h"
#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "peers/draco_mesh.h"

namespace deltamesh::bench {

/// A mesh of an asset as it was coded by deltamesh.
struct OurMesh {
  std::vector<StreamSource> sources;
  EncodeOptions options;
  CodedMesh coded;
};

/// Processor times of one thread for all meshes of an asset, seconds, medians of runs in turn, and medians
/// of the ratios of each turn.
struct AssetTimes {
  double decode = 0;
  double draco_decode = 0;
  double decode_ratio = 0;
  double encode = 0;              ///< at effort 0, from arrays
  double draco_encode = 0;        ///< from a draco::Mesh without equal values
  double draco_build = 0;         ///< from arrays to that mesh
  double encode_ratio = 0;        ///< to Draco's encode and build
  double encode_alone_ratio = 0;  ///< to Draco's encode
};

/// `ours`: one for each mesh of the asset. Draco at level 7, for its streams too. Errors: of the runs.
Result<AssetTimes> measure_times(const Asset& asset, const std::vector<OurMesh>& ours,
                                 const DracoSetting& setting);

}  // namespace deltamesh::bench
