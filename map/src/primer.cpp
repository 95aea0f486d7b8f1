// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/map_codec.h"
#include "part_primer.h"

namespace deltamesh {
namespace {

/// Everybody who wants any part gets the primers first, so that they stay small, whatever they would save.
constexpr std::size_t kUsualPrimerBytes = std::size_t{1} << 14;
constexpr double kWorthAnother = 0.998;  ///< of the bytes without

constexpr std::size_t kMostSampled = 12;

/// The number of bytes of a map with a primer, as far as a sample tells.
Result<double> price(const MapDescription& description, std::span<const MapPart> parts,
                     std::span<const std::size_t> sample, const PartQuality& quality) {
  DELTAMESH_TRY(const MapCodec codec, MapCodec::open(description));
  double bytes = 0;
  double triangles = 0;
  double all = 0;
  for (const MapPart& part : parts) all += static_cast<double>(part.mesh.triangle_count());
  for (const std::size_t i : sample) {
    DELTAMESH_TRY(const CodedPart coded, codec.encode(parts[i], quality));
    bytes += static_cast<double>(coded.bytes.size());
    triangles += static_cast<double>(parts[i].mesh.triangle_count());
  }
  return bytes / triangles * all;  // the primer's own part is next to nothing then
}

/// `description` with one more primer.
Result<MapDescription> with_another(MapDescription description, const MapPart& part,
                                    const PartQuality& quality) {
  DELTAMESH_TRY(const MapCodec codec, MapCodec::open(description));
  DELTAMESH_TRY(MapPrimer primer, make_primer(codec, part, quality));
  description.primers.push_back(std::move(primer));
  return description;
}

/// Evenly over `count` places.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> places;
  const std::size_t number = std::min(count, most);
  for (std::size_t i = 0; i < number; ++i) places.push_back((2 * i + 1) * count / (2 * number));
  return places;
}

}  // namespace

Result<MapDescription> with_primers(MapDescription description, std::span<const MapPart> parts,
                                    const PartQuality& quality) noexcept {
  return guarded([&]() -> Result<MapDescription> {
    description.primers.clear();

    if (parts.size() < 2) return description;
    std::vector<std::size_t> by_size(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) by_size[i] = i;
    std::ranges::stable_sort(by_size, std::greater<>(),
                             [&](std::size_t i) { return parts[i].mesh.triangle_count(); });
    const auto sample = spread(parts.size(), kMostSampled);
    MapDescription best = description;
    DELTAMESH_TRY(double least, price(description, parts, sample, quality));
    std::size_t bytes = 0;
    for (const std::size_t i : by_size) {
      DELTAMESH_TRY(MapDescription candidate, with_another(best, parts[i], quality));
      bytes += candidate.primers.back().stream.size() + candidate.primers.back().border.size();
      if (!validate(candidate) || (!best.primers.empty() && bytes > kUsualPrimerBytes)) break;
      DELTAMESH_TRY(const double now, price(candidate, parts, sample, quality));
      if (now > kWorthAnother * least) break;
      least = now;
      best = std::move(candidate);
    }
    return best;
  });
}

}  // namespace deltamesh
