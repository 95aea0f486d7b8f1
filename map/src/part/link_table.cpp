// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "part/link_table.h"

#include <xxhash.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/byte_writer.h"

namespace deltamesh {
namespace {

std::uint32_t hash_of(std::span<const SharedPoint> points) {
  ByteWriter out;
  for (const SharedPoint& shared : points) {
    for (const std::int32_t x : shared.point) out.write(x);
    out.write(shared.twin);
  }
  return static_cast<std::uint32_t>(XXH3_64bits(out.bytes().data(), out.size()));
}

}  // namespace

void LinkTable::put(const MapPart& part) {
  std::vector<SharedPoint> points;
  for (const BorderVertex& vertex : part.border) points.push_back({vertex.point, vertex.twin});
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  set(part.key, points);
  borders_[part.key] = std::move(points);
}

void LinkTable::remove(const PartKey& key) {
  set(key, {});
  borders_.erase(key);
}

/// Only parts that have a point which comes or goes are touched.
void LinkTable::set(const PartKey& key, const std::vector<SharedPoint>& points) {
  touched_.insert(key);
  const auto known = borders_.find(key);
  const std::vector<SharedPoint> before =
      known == borders_.end() ? std::vector<SharedPoint>() : known->second;
  std::vector<SharedPoint> different;
  std::ranges::set_difference(before, points, std::back_inserter(different));
  for (const SharedPoint& shared : different) {
    const auto users = users_.find(shared);
    std::erase(users->second, key);
    touched_.insert(users->second.begin(), users->second.end());
    if (users->second.empty()) users_.erase(users);
  }
  different.clear();
  std::ranges::set_difference(points, before, std::back_inserter(different));
  for (const SharedPoint& shared : different) {
    std::vector<PartKey>& users = users_[shared];
    touched_.insert(users.begin(), users.end());
    users.push_back(key);
  }
}

std::vector<PartLink> LinkTable::links_of(const PartKey& key) const {
  std::map<PartKey, std::vector<SharedPoint>> common;
  const auto known = borders_.find(key);
  if (known == borders_.end()) return {};
  for (const SharedPoint& shared : known->second)
    for (const PartKey& user : users_.at(shared))
      if (!overlap(user, key)) common[user].push_back(shared);
  std::vector<PartLink> links;
  links.reserve(common.size());
  for (const auto& [other, points] : common)
    links.push_back({.key = other, .border = std::max(hash_of(points), 1U)});
  return links;
}

std::size_t LinkTable::count_between_cells(std::uint8_t level, const std::set<PartKey>& without) const {
  std::size_t count = 0;
  for (const auto& [point, users] : users_) {
    std::set<PartKey> cells;
    for (const PartKey& user : users)
      if (user.level <= level && !without.contains(user)) cells.insert(ancestor(user, level));
    if (cells.size() > 1) count += cells.size();
  }
  return count;
}

std::set<PartKey> LinkTable::take_touched() { return std::exchange(touched_, {}); }

}  // namespace deltamesh
