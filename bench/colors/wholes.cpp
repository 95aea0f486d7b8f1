// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "colors/wholes.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include "colors/colors_alone.h"
#include "deltamesh/decode.h"
#include "deltamesh/encode.h"
#include "peers/draco_mesh.h"
#include "report/geometric_mean.h"
#include "report/table.h"
#include "report/text.h"
#include "support/corpus.h"
#include "support/errors.h"
#include "support/timing.h"

namespace deltamesh::bench {
namespace {

constexpr double kNear = 4;        ///< the bound beside the default, 255ths
constexpr int kPositionBits = 14;  ///< of Draco's positions
constexpr int kEncodeLevel = 10;   ///< of Draco whose time to encode counts
constexpr int kDecodeLevel = 7;    ///< of Draco whose time to decode counts
constexpr TimingEffort kWholeRuns = {.rounds = 9, .seconds = 20, .least_seconds = 0.2};

struct WholeMesh {
  std::uint64_t chosen = 0;  ///< bytes of the whole stream by default
  std::uint64_t near = 0;    ///< with colours within kNear
  std::uint64_t exact = 0;
  double encode_over_exact = 0;
  double encode_over_draco = 0;
  double decode_over_draco = 0;
  double exact_decode_over_draco = 0;
};

EncodeOptions within(std::optional<double> color_error) {
  EncodeOptions options;
  options.attributes.color_error = color_error;
  return options;
}

/// The times of `works` in turn.
template <class... Work>
auto times_of(Work&&... works) {
  return value_or_exit(time_in_turn(kWholeRuns, std::forward<Work>(works)...));
}

WholeMesh measure_mesh(const Mesh& mesh) {
  const auto chosen = value_or_exit(encode(mesh, within(std::nullopt)));
  const auto exact = value_or_exit(encode(mesh, within(0)));
  WholeMesh whole{.chosen = chosen.bytes.size(),
                  .near = value_or_exit(encode(mesh, within(kNear))).bytes.size(),
                  .exact = exact.bytes.size()};
  const auto draco_mesh = to_draco(mesh);
  const auto encoding = [&](std::optional<double> bound) {
    return [&, bound] { return encode(mesh, within(bound)); };
  };
  const auto encodes = times_of(encoding(std::nullopt), encoding(0), [&] {
    return encode_draco(*draco_mesh, {.position_bits = kPositionBits}, kEncodeLevel);
  });
  whole.encode_over_exact = median_ratio(encodes[0], encodes[1]);
  whole.encode_over_draco = median_ratio(encodes[0], encodes[2]);
  const auto draco = value_or_exit(encode_draco(*draco_mesh, {.position_bits = kPositionBits}, kDecodeLevel));
  const auto decoding = [](std::span<const std::byte> bytes) { return [bytes] { return decode(bytes); }; };
  const auto decodes =
      times_of(decoding(chosen.bytes), decoding(exact.bytes), [&] { return decode_draco(draco); });
  whole.decode_over_draco = median_ratio(decodes[0], decodes[2]);
  whole.exact_decode_over_draco = median_ratio(decodes[1], decodes[2]);
  return whole;
}

}  // namespace

int compare_whole_meshes(const std::vector<std::string>& files) {
  print(
      join({"Whole meshes with their colours by default, processor time of one thread; Draco with exact "
            "colours,\n",
            "level ", number(kEncodeLevel), " encoded, level ", number(kDecodeLevel), " decoded:\n\n"}));
  print(table_head({"mesh", "bytes", "over within " + fixed(kNear, 0), "over exact", "encode over exact",
                    "over Draco", "decode over Draco", "exact over Draco"}));
  GeometricMean encode_mean;
  GeometricMean decode_mean;
  for (const std::string& file : files) {
    const auto mesh = colors_alone(value_or_exit(load_mesh(file)));
    if (!mesh) continue;
    const WholeMesh whole = measure_mesh(*mesh);
    encode_mean.add(whole.encode_over_exact);
    decode_mean.add(whole.decode_over_draco);
    print(table_row({std::filesystem::path(file).stem().string(), number(whole.chosen),
                     fixed(ratio(whole.chosen, whole.near), 2), fixed(ratio(whole.chosen, whole.exact), 2),
                     fixed(whole.encode_over_exact, 2), fixed(whole.encode_over_draco, 2),
                     fixed(whole.decode_over_draco, 2), fixed(whole.exact_decode_over_draco, 2)}));
  }
  print(join({"\nGeometric means: encode over exact ", fixed(encode_mean.value().value_or(0), 2),
              ", decode over Draco ", fixed(decode_mean.value().value_or(0), 2), ".\n"}));
  return 0;
}

}  // namespace deltamesh::bench
