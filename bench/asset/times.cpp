// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/times.h"

#include <memory>
#include <utility>

#include "asset/coders/draco.h"
#include "base/try.h"
#include "deltamesh/decode.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

constexpr int kTimedLevel = 7;

/// Draco's side for all primitives of an asset.
class DracoAsset {
 public:
  DracoAsset(const Asset& asset, const DracoSetting& setting) : asset_(asset), setting_(setting) {}

  Result<void> build() {
    built_.clear();
    for (const AssetMesh& mesh : asset_.meshes)
      for (const Primitive& primitive : mesh.primitives) built_.push_back(merged_draco(primitive));
    return {};
  }
  Result<void> encode() {
    streams_.clear();
    for (const auto& mesh : built_) {
      DELTAMESH_TRY(auto stream, encode_draco(*mesh, setting_, kTimedLevel));
      streams_.push_back(std::move(stream));
    }
    return {};
  }
  Result<void> decode() const {
    for (const auto& stream : streams_) DELTAMESH_CHECK(decode_draco(stream));
    return {};
  }

 private:
  const Asset& asset_;
  DracoSetting setting_;
  std::vector<std::unique_ptr<draco::Mesh>> built_;
  std::vector<std::vector<std::byte>> streams_;
};

}  // namespace

Result<AssetTimes> measure_times(const Asset& asset, const std::vector<OurMesh>& ours,
                                 const DracoSetting& setting) {
  DracoAsset draco(asset, setting);
  const auto decode_ours = [&]() -> Result<void> {
    for (const OurMesh& mesh : ours)
      for (const auto& stream : mesh.coded.streams) DELTAMESH_CHECK(decode(stream));
    return {};
  };
  const auto encode_ours = [&]() -> Result<void> {
    for (const OurMesh& mesh : ours) {
      EncodeOptions options = mesh.options;
      options.effort = 0;
      for (const StreamSource& source : mesh.sources) DELTAMESH_CHECK(encode_stream(source, options));
    }
    return {};
  };
  DELTAMESH_CHECK(draco.build());
  DELTAMESH_CHECK(draco.encode());
  DELTAMESH_CHECK(decode_ours());
  DELTAMESH_TRY(const auto times,
                time_in_turn(
                    {.rounds = 7, .least_seconds = 0.01}, [&] { return draco.decode(); }, decode_ours,
                    [&] { return draco.build(); }, [&] { return draco.encode(); }, encode_ours));
  const auto& [draco_decode, our_decode, build, draco_encode, our_encode] = times;
  std::vector<double> both = build;
  for (std::size_t r = 0; r < both.size(); ++r) both[r] += draco_encode[r];
  return AssetTimes{.decode = median(our_decode),
                    .draco_decode = median(draco_decode),
                    .decode_ratio = median_ratio(our_decode, draco_decode),
                    .encode = median(our_encode),
                    .draco_encode = median(draco_encode),
                    .draco_build = median(build),
                    .encode_ratio = median_ratio(our_encode, both),
                    .encode_alone_ratio = median_ratio(our_encode, draco_encode)};
}

}  // namespace deltamesh::bench
