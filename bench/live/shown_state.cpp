// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "live/shown_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deltamesh::bench {
namespace {

/// Of the distances of `points` to the nearest of `others`, at most `most` each.
double sum_of_squares(const std::vector<float>& points, const std::vector<float>& others, double most) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    double nearest = most * most;
    for (std::size_t j = 0; j < others.size(); j += 3) {
      double way = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = double{points[i + k]} - double{others[j + k]};
        way += d * d;
      }
      nearest = std::min(nearest, way);
    }
    sum += nearest;
  }
  return sum;
}

}  // namespace

ShownAges::Age ShownAges::at(double now, const MapSender& sender, const MapReceiver& receiver) {
  std::map<PartKey, std::uint64_t> newest;
  for (const PartEntry& entry : sender.entries_of(1)) newest[entry.key] = entry.hash;
  std::map<PartKey, std::uint64_t> shown;
  for (const HeldPart& part : receiver.held()) shown[part.entry.key] = part.entry.hash;
  for (const auto& [key, hash] : newest) sent_.try_emplace(key);
  for (const auto& [key, hash] : shown) sent_.try_emplace(key);
  const auto hash_in = [](const auto& hashes, const PartKey& key) {
    const auto found = hashes.find(key);
    return found == hashes.end() ? 0 : found->second;
  };
  Age age;
  for (auto& [key, versions] : sent_) {
    const std::uint64_t last = hash_in(newest, key);
    if (versions.empty() || versions.back().second != last) versions.emplace_back(now, last);
    const auto is_shown = [&, hash = hash_in(shown, key)](const auto& version) {
      return version.second == hash;
    };
    const auto at = std::find_if(versions.rbegin(), versions.rend(), is_shown);
    if (at != versions.rend()) versions.erase(versions.begin(), at.base() - 1);
    const std::size_t next = at == versions.rend() ? 0 : 1;
    if (next >= versions.size()) continue;
    ++age.behind;
    age.oldest = std::max(age.oldest, now - versions[next].first);
  }
  std::erase_if(sent_, [](const auto& e) { return e.second.size() == 1 && e.second[0].second == 0; });
  return age;
}

double ShownError::of(const MapSender& sender, const MapReceiver& receiver) {
  static const std::vector<float> kNothing;
  std::map<PartKey, Part> parts;
  double sum = 0;
  std::size_t count = 0;
  for (const PartKey& key : sender.keys()) {
    Part& part = parts[key] = std::move(parts_[key]);
    const std::vector<float>& source = sender.source(key)->mesh.positions;
    const MapPart* found = receiver.find(key);
    const std::vector<float>& shown = found == nullptr ? kNothing : found->mesh.positions;
    if (part.source != source || part.shown != shown) {
      part = {source, shown, sum_of_squares(source, shown, most_)};
    }
    sum += part.sum;
    count += source.size() / 3;
  }
  parts_ = std::move(parts);
  return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
}

}  // namespace deltamesh::bench
