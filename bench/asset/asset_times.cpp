// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/asset_times.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "base/try.h"
#include "deltamesh/decode.h"
#include "support/processor_seconds.h"

namespace deltamesh::bench {
namespace {

constexpr std::size_t kRounds = 7;
constexpr int kTimedLevel = 7;
constexpr double kLeastSeconds = 0.01;  ///< of one figure: as often as that takes
constexpr int kMostRuns = 50;

using Rounds = std::array<double, kRounds>;

double median(Rounds values) {
  std::nth_element(values.begin(), values.begin() + kRounds / 2, values.end());
  return values[kRounds / 2];
}

double median_ratio(const Rounds& ours, const Rounds& theirs) {
  Rounds ratios{};
  for (std::size_t r = 0; r < kRounds; ++r) ratios[r] = ours[r] / theirs[r];
  return median(ratios);
}

/// Mean seconds of `work`, over as many runs as take kLeastSeconds. Errors: of the runs.
template <class Work>
Result<double> seconds_of(Work&& work) {
  const double start = processor_seconds();
  for (int runs = 1;; ++runs) {
    DELTAMESH_CHECK(work());
    const double passed = processor_seconds() - start;
    if (passed >= kLeastSeconds || runs == kMostRuns) return std::max(passed, 1e-7) / runs;
  }
}

/// The whole of one asset, each step as one call.
class Racers {
 public:
  Racers(const Asset& asset, const std::vector<OurMesh>& ours, const DracoSetting& setting)
      : asset_(&asset), ours_(&ours), setting_(setting) {}

  Result<void> decode() {
    for (const OurMesh& mesh : *ours_)
      for (const auto& stream : mesh.coded.streams) DELTAMESH_CHECK(deltamesh::decode(stream));
    return {};
  }
  Result<void> encode() const {
    for (const OurMesh& mesh : *ours_) {
      EncodeOptions options = mesh.options;
      options.effort = 0;
      for (const StreamSource& source : mesh.sources) DELTAMESH_CHECK(encode_stream(source, options));
    }
    return {};
  }
  Result<void> draco_build() {
    built_.clear();
    for (const AssetMesh& mesh : asset_->meshes)
      for (const Primitive& primitive : mesh.primitives) built_.push_back(to_draco(primitive));
    return {};
  }
  Result<void> draco_encode() {
    draco_streams_.clear();
    auto built = built_.begin();
    for (const AssetMesh& mesh : asset_->meshes) {
      for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
        DELTAMESH_TRY(auto stream, encode_draco(**built++, setting_, kTimedLevel));
        draco_streams_.push_back(std::move(stream));
      }
    }
    return {};
  }
  Result<void> draco_decode() const {
    for (const auto& stream : draco_streams_) DELTAMESH_CHECK(decode_draco(stream));
    return {};
  }

 private:
  const Asset* asset_;
  const std::vector<OurMesh>* ours_;
  DracoSetting setting_;
  std::vector<std::unique_ptr<draco::Mesh>> built_;
  std::vector<std::vector<std::byte>> draco_streams_;
};

}  // namespace

Result<AssetTimes> measure_times(const Asset& asset, const std::vector<OurMesh>& ours,
                                 const DracoSetting& setting) {
  Racers racers(asset, ours, setting);
  DELTAMESH_CHECK(racers.draco_build());
  DELTAMESH_CHECK(racers.draco_encode());
  DELTAMESH_CHECK(racers.decode());
  Rounds decode{}, draco_decode{}, encode{}, draco_encode{}, draco_build{}, draco_both{};
  for (std::size_t r = 0; r < kRounds; ++r) {
    DELTAMESH_TRY(draco_decode[r], seconds_of([&] { return racers.draco_decode(); }));
    DELTAMESH_TRY(decode[r], seconds_of([&] { return racers.decode(); }));
    DELTAMESH_TRY(draco_build[r], seconds_of([&] { return racers.draco_build(); }));
    DELTAMESH_TRY(draco_encode[r], seconds_of([&] { return racers.draco_encode(); }));
    DELTAMESH_TRY(encode[r], seconds_of([&] { return racers.encode(); }));
    draco_both[r] = draco_build[r] + draco_encode[r];
  }
  return AssetTimes{.decode = median(decode),
                    .draco_decode = median(draco_decode),
                    .decode_ratio = median_ratio(decode, draco_decode),
                    .encode = median(encode),
                    .draco_encode = median(draco_encode),
                    .draco_build = median(draco_build),
                    .encode_ratio = median_ratio(encode, draco_both),
                    .encode_alone_ratio = median_ratio(encode, draco_encode)};
}

}  // namespace deltamesh::bench
