// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/units.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "lattice/borders_of_links.h"
#include "part/view_cells.h"
#include "send/coexistence.h"
#include "support/overlapping.h"

namespace deltamesh {
namespace {

/// Sets of keys that become one.
class KeySets {
 public:
  void add(const PartKey& key) { parent_.try_emplace(key, key); }
  bool contains(const PartKey& key) const { return parent_.contains(key); }
  PartKey root(PartKey key) {
    while (parent_.at(key) != key) key = parent_[key] = parent_.at(parent_.at(key));
    return key;
  }
  void unite(const PartKey& a, const PartKey& b) {
    if (!contains(a) || !contains(b)) return;
    const PartKey x = root(a);
    const PartKey y = root(b);
    parent_[std::max(x, y)] = std::min(x, y);
  }

 private:
  std::map<PartKey, PartKey> parent_;
};

const std::vector<PartLink>* held_links(const PartKey& key, const Viewer& viewer,
                                        const KnownVersions& known) {
  const auto has = viewer.has.find(key);
  if (has == viewer.has.end()) return nullptr;
  const KnownVersion* version = find_version(known, key, has->second.version);
  return version == nullptr ? nullptr : &version->links;
}

}  // namespace

std::vector<SendUnit> units_of(const SendPlan& plan, const Viewer& viewer, const SourceMap& map,
                               const KnownVersions& known, const MapDescription& description) {
  KeySets sets;
  for (const PartKey& key : plan.needed) sets.add(key);
  for (const PartKey& key : plan.removed) sets.add(key);
  for (const PartKey& key : plan.needed) {
    const std::vector<PartLink>* before = held_links(key, viewer, known);
    const SourcePart& source = *map.find(key);
    const bool may_wait = viewer.may_have_before(key, source.revision);
    for (const PartLink& link : source.links)
      if ((link.together && may_wait) || (before != nullptr && border_in(*before, link.key) != link.border))
        sets.unite(key, link.key);
    if (before == nullptr || plan.refined.contains(key)) continue;
    for (const PartLink& link : *before) sets.unite(key, link.key);
  }
  for (const PartKey& key : plan.removed)
    for (const PartKey& other : overlapping(plan.needed, key)) sets.unite(key, other);

  // A unit is as urgent as its most urgent part.
  using Urgency = std::tuple<int, std::uint64_t, double, PartKey>;
  std::map<PartKey, std::pair<Urgency, SendUnit>> units;
  const auto unit_of = [&](const PartKey& key) -> auto& {
    const PartKey root = sets.root(key);
    const Urgency last{1, 0, 0, root};
    return units.try_emplace(root, last, SendUnit{}).first->second;
  };
  for (const PartKey& key : plan.needed) {
    auto& [urgency, unit] = unit_of(key);
    const Urgency own{-int{key.level}, viewer.due.at(key), way_to(key, viewer.view, description),
                      std::get<3>(urgency)};
    urgency = unit.needed.empty() ? own : std::min(urgency, own);
    unit.needed.push_back(key);
  }
  for (const PartKey& key : plan.removed) {
    auto& [urgency, unit] = unit_of(key);
    if (unit.needed.empty()) std::get<0>(urgency) = std::numeric_limits<int>::min();
    unit.removed.push_back(key);
  }
  std::vector<std::pair<Urgency, SendUnit>> order;
  order.reserve(units.size());
  for (auto& [root, unit] : units) order.push_back(std::move(unit));
  std::ranges::sort(order, {}, [](const auto& unit) { return unit.first; });
  std::vector<SendUnit> sorted;
  sorted.reserve(order.size());
  for (auto& [urgency, unit] : order) sorted.push_back(std::move(unit));
  return sorted;
}

PartEntry entry_of(const SourcePart& source, const Encoding& encoding, std::uint64_t revision,
                   std::vector<PartLink> links) {
  const Mesh& mesh = encoding.decoded.mesh;
  PartEntry entry{.key = source.part.key, .revision = revision, .group = source.group};
  entry.bytes = static_cast<std::uint32_t>(encoding.octets.size());
  entry.links = std::move(links);
  entry.hash = encoding.hash;
  entry.vertices = static_cast<std::uint32_t>(mesh.vertex_count());
  entry.triangles = static_cast<std::uint32_t>(mesh.triangle_count());
  const PartBox extent = part_box(mesh);
  entry.box_min = extent.low;
  entry.box_max = extent.high;
  entry.quality = encoding.quality;
  for (const double error : encoding.attribute_errors)
    entry.attribute_errors.push_back(static_cast<float>(error));
  return entry;
}

}  // namespace deltamesh
