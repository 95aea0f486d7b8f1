// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <utility>
#include <vector>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/map_codec.h"
#include "part/as_primer.h"

namespace deltamesh {
namespace {

/// Every receiver gets the primers before any part, so that they stay small, whatever they would save.
constexpr std::size_t kUsualPrimerBytes = std::size_t{1} << 14;
constexpr double kWorthAnother = 0.998;  ///< of the bytes without
constexpr std::size_t kMostSampled = 12;
constexpr std::size_t kMostTried = 8;

/// A part that the others are measured by.
struct SampledPart {
  std::size_t part;
  double bytes;  ///< with the primers so far
};

/// Chooses primers among parts, the largest first.
class PrimerSearch {
 public:
  /// `parts`: at least one.
  PrimerSearch(MapDescription description, std::span<const MapPart> parts, const PartQuality& quality)
      : description_(std::move(description)), parts_(parts), quality_(quality) {}

  Result<MapDescription> run() {
    DELTAMESH_CHECK(take_sample());
    for (const std::size_t part : candidates()) DELTAMESH_CHECK(try_part(part));
    return std::move(description_);
  }

 private:
  /// Parts evenly over all.
  Result<void> take_sample() {
    DELTAMESH_TRY(const MapCodec codec, MapCodec::open(description_));
    const std::size_t count = std::min(parts_.size(), kMostSampled);
    double bytes = 0;
    double triangles = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t part = (2 * i + 1) * parts_.size() / (2 * count);
      DELTAMESH_TRY(const double size, size_of(codec, part));
      sample_.push_back({part, size});
      bytes += size;
      triangles += triangles_of(part);
    }
    double all = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) all += triangles_of(i);
    rest_ = bytes / triangles * all;
    return {};
  }

  std::vector<std::size_t> candidates() const {
    std::vector<std::size_t> by_size(parts_.size());
    for (std::size_t i = 0; i < by_size.size(); ++i) by_size[i] = i;
    std::ranges::stable_sort(by_size, std::greater<>(), [&](std::size_t i) { return triangles_of(i); });
    by_size.resize(std::min(by_size.size(), kMostTried));
    return by_size;
  }

  /// Takes the part if it pays: as a primer it has as many bytes as before, and the others have fewer. A
  /// single part costs nothing, and later ones learn from it.
  Result<void> try_part(std::size_t part) {
    DELTAMESH_TRY(const MapCodec before, MapCodec::open(description_));
    MapDescription candidate = description_;
    DELTAMESH_TRY(candidate.primers.emplace_back(), make_primer(before, parts_[part], quality_));
    const std::size_t own = candidate.primers.back().stream.size() + candidate.primers.back().border.size();
    if (primer_bytes_ > 0 && primer_bytes_ + own > kUsualPrimerBytes) return {};
    if (!validate(candidate)) return {};
    DELTAMESH_TRY(const MapCodec after, MapCodec::open(candidate));
    std::vector<SampledPart> sample;
    double bytes_before = 0;
    double bytes_after = 0;
    for (const SampledPart& sampled : sample_) {
      if (sampled.part == part) continue;
      DELTAMESH_TRY(const double size, size_of(after, sampled.part));
      sample.push_back({sampled.part, size});
      bytes_before += sampled.bytes;
      bytes_after += size;
    }
    if (parts_.size() > 1) {
      if (sample.empty()) return {};
      const double others = std::max(rest_ - static_cast<double>(own), 0.0);
      const double saved = others * (1 - bytes_after / bytes_before);
      if (saved < (1 - kWorthAnother) * (static_cast<double>(primer_bytes_) + rest_)) return {};
      rest_ = others - saved;
    }
    description_ = std::move(candidate);
    sample_ = std::move(sample);
    primer_bytes_ += own;
    return {};
  }

  Result<double> size_of(const MapCodec& codec, std::size_t part) const {
    DELTAMESH_TRY(const CodedPart coded, codec.encode(parts_[part], quality_));
    return static_cast<double>(coded.bytes.size());
  }

  double triangles_of(std::size_t part) const noexcept {
    return static_cast<double>(parts_[part].mesh.triangle_count());
  }

  MapDescription description_;  ///< with the primers so far
  std::span<const MapPart> parts_;
  const PartQuality& quality_;
  std::vector<SampledPart> sample_;  ///< without primers
  std::size_t primer_bytes_ = 0;
  double rest_ = 0;  ///< bytes of the parts that are no primers, as far as the sample tells
};

}  // namespace

Result<MapDescription> with_primers(MapDescription description, std::span<const MapPart> parts,
                                    const PartQuality& quality) noexcept {
  return guarded([&]() -> Result<MapDescription> {
    description.primers.clear();
    if (parts.empty()) return description;
    return PrimerSearch(std::move(description), parts, quality).run();
  });
}

}  // namespace deltamesh
