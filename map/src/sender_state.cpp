// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "sender_state.h"

#include <set>

#include "base/try.h"
#include "coexistence.h"
#include "deltamesh/map/messages.h"

namespace deltamesh {

/// Versions that no receiver has and that are not the newest.
void MapSender::State::forget_versions() {
  std::set<std::pair<PartKey, std::uint32_t>> used;
  for (const auto& [number, viewer] : viewers)
    for (const auto& [key, believed] : viewer.has) used.emplace(key, believed.version);
  for (auto& [key, versions] : known)
    std::erase_if(versions, [&, &k = key](const auto& entry) { return !used.contains({k, entry.first}); });
  std::erase_if(known, [](const auto& entry) { return entry.second.empty(); });
  encodings.prune(map);
}

Result<std::vector<std::byte>> MapSender::State::newest_message(const PartKey& key, const SendPlan& plan,
                                                                Viewer& viewer, double now) {
  const SourcePart& source = *map.find(key);
  DELTAMESH_TRY(const std::uint32_t version, newest_version(source, viewer.view, encodings, known));
  const Encoding& encoding = *find_version(known, key, version)->encoding;
  const Believed* before = believed_octets(viewer, key, encoding.hash);
  const bool has_octets = before != nullptr && before->is_confirmed();
  const std::uint64_t revision = viewer.next_revision(key, source.revision, now);
  std::vector<PartLink> links = links_for(source, encoding.decoded.mesh, viewer, plan);
  viewer.sent[key].add(extent_of(encoding.decoded.mesh));
  const std::uint64_t since = before == nullptr ? revision : before->since;
  viewer.has[key] = {.revision = revision, .since = since, .version = version, .sent = now};
  if (has_octets) {
    ++counts.entries_sent;
    return write_entry({.map = description_hash,
                        .start = start,
                        .entry = entry_of(source, encoding, revision, std::move(links))});
  }
  ++counts.parts_sent;
  return write_part({.map = description_hash,
                     .start = start,
                     .key = key,
                     .revision = revision,
                     .group = source.group,
                     .links = std::move(links),
                     .octets = encoding.octets});
}

/// What is believed of the part if it is these octets; else null.
const Believed* MapSender::State::believed_octets(const Viewer& viewer, const PartKey& key,
                                                  std::uint64_t hash) const {
  const auto has = viewer.has.find(key);
  if (has == viewer.has.end() || has->second.is_gone) return nullptr;
  const KnownVersion* version = find_version(known, key, has->second.version);
  return version != nullptr && version->encoding->hash == hash ? &has->second : nullptr;
}

Result<std::vector<std::byte>> MapSender::State::removal_message(const PartKey& key, Viewer& viewer,
                                                                 double now) {
  const std::uint64_t revision = viewer.next_revision(key, map.revision(), now);
  viewer.sent[key].is_removal = true;
  viewer.has[key] = {.revision = revision, .since = revision, .is_gone = true, .sent = now};
  ++counts.entries_sent;
  return write_entry({.map = description_hash,
                      .start = start,
                      .entry = {.key = key, .revision = revision, .links = map.replacements_of(key)}});
}

Result<void> MapSender::State::send(const SendUnit& unit, SendPlan& plan, Viewer& viewer, double now,
                                    std::vector<std::vector<std::byte>>& messages) {
  for (const PartKey& key : unit.removed) {
    DELTAMESH_TRY(messages.emplace_back(), removal_message(key, viewer, now));
    plan.removed.erase(key);
    viewer.allowance -= static_cast<double>(messages.back().size());
  }
  for (const PartKey& key : unit.needed) {
    DELTAMESH_TRY(messages.emplace_back(), newest_message(key, plan, viewer, now));
    plan.needed.erase(key);
    viewer.allowance -= static_cast<double>(messages.back().size());
    viewer.due.erase(key);
  }
  return {};
}

}  // namespace deltamesh
