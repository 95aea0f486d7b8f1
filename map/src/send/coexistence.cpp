// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/coexistence.h"

#include <algorithm>

#include "support/overlapping.h"

namespace deltamesh {
namespace {

/// By how much boxes are taken apart and still touch, of their size: what two versions of one border differ
/// by.
constexpr float kMargin = 0.0625F;

bool touch(const PartBox& a, const PartBox& b) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    const float margin = kMargin * std::max(a.high[k] - a.low[k], b.high[k] - b.low[k]);
    if (a.low[k] > b.high[k] + margin || b.low[k] > a.high[k] + margin) return false;
  }
  return true;
}

/// 0: whatever the receiver may get to see of the part goes with what it gets now.
std::uint64_t least_of(const PartKey& key, const SentPart& sent, const Viewer& viewer, const SendPlan& plan) {
  // Both versions have the same content.
  if (const auto refined = plan.refined.find(key); refined != plan.refined.end()) return refined->second;
  const auto has = viewer.has.find(key);
  const bool is_there =
      has != viewer.has.end() && has->second.stage == Believed::Stage::kTold && !has->second.is_gone;
  // While a version waits, an older one may be shown.
  if (is_there && plan.staying.contains(key)) return has->second.is_waiting ? has->second.since : 0;
  const bool goes = plan.removed.contains(key) && !plan.staying.contains(key);
  if (is_there || plan.needed.contains(key) || goes) return sent.revision + 1;
  // What has been sent is not the newest where the part is out of the view.
  if (has != viewer.has.end() && !viewer.may_get_later(key, has->second) &&
      (has->second.is_gone || plan.staying.contains(key)))
    return has->second.since;
  if (has != viewer.has.end()) return sent.revision + 1;
  return sent.is_removal ? sent.revision : sent.revision + 1;  // an older version may still be on its way
}

/// Around a new version and the versions that it may take the place of. Neighbours of these may still be
/// shown beside it, even where they are far from it.
PartBox box_with_earlier(const PartKey& key, const Mesh& mesh, const Viewer& viewer) {
  PartBox box = part_box(mesh);
  for (const PartKey& other : overlapping(viewer.sent, key)) {
    const SentPart& sent = viewer.sent.at(other);
    if (sent.extent && (other == key || viewer.has.contains(other))) box.add(*sent.extent);
  }
  return box;
}

}  // namespace

PartBox part_box(const Mesh& mesh) {
  PartBox extent;
  for (std::size_t k = 0; k < 3; ++k) extent.low[k] = extent.high[k] = mesh.positions[k];
  for (std::size_t i = 3; i < mesh.positions.size(); ++i) {
    extent.low[i % 3] = std::min(extent.low[i % 3], mesh.positions[i]);
    extent.high[i % 3] = std::max(extent.high[i % 3], mesh.positions[i]);
  }
  return extent;
}

std::vector<PartLink> links_for(const SourcePart& source, const Mesh& mesh, const Viewer& viewer,
                                const SendPlan& plan) {
  const PartBox extent = box_with_earlier(source.part.key, mesh, viewer);
  std::vector<PartLink> links;
  auto border = source.links.begin();
  for (const auto& [key, sent] : viewer.sent) {
    for (; border != source.links.end() && border->key < key; ++border) links.push_back(*border);
    const bool is_border = border != source.links.end() && border->key == key;
    const bool is_near = sent.is_everywhere || (sent.extent && touch(*sent.extent, extent));
    std::uint64_t least =
        key != source.part.key && (is_near || is_border) ? least_of(key, sent, viewer, plan) : 0;
    if (least <= sent.first) least = 0;  // there never was anything older
    if (!is_border && least == 0) continue;
    PartLink link = is_border ? *border++ : PartLink{.key = key};
    link.least = least;
    links.push_back(link);
  }
  links.insert(links.end(), border, source.links.end());
  // What the receiver is not to have is not waited for.
  const bool may_wait = viewer.may_have_before(source.part.key, source.revision);
  for (PartLink& link : links) link.together = link.together && may_wait && !plan.unwanted.contains(link.key);
  return links;
}

}  // namespace deltamesh
