// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/state.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "send/coexistence.h"
#include "send/seen_cells.h"
#include "support/overlapping.h"

namespace deltamesh {

/// Forgets versions that no receiver has, and that none will have again if messages on the way are lost.
/// Looks at some parts only, so that an update does not take longer the larger the map is.
void MapSender::State::forget_versions(std::size_t parts) {
  if (parts == 0) return;
  std::set<std::pair<PartKey, std::uint32_t>> may_come_back;
  for (const auto& [name, viewer] : viewers)
    for (const auto& [number, message] : viewer.delivery.on_the_way())
      if (message.before) may_come_back.emplace(message.key, message.before->version);
  auto next = known.lower_bound(look_at_next);
  for (std::size_t count = std::min(parts, known.size()); count > 0; --count) {
    if (next == known.end()) next = known.begin();
    const PartKey key = next->first;
    std::erase_if(next->second, [&](const auto& entry) {
      return !has_viewer(key, entry.first) && !may_come_back.contains({key, entry.first});
    });
    next = next->second.empty() ? known.erase(next) : std::next(next);
  }
  if (next == known.end()) next = known.begin();
  look_at_next = next == known.end() ? PartKey{} : next->first;
}

bool MapSender::State::has_viewer(const PartKey& key, std::uint32_t version) const {
  return std::ranges::any_of(viewers, [&](const auto& viewer) {
    const auto has = viewer.second.has.find(key);
    return has != viewer.second.has.end() && has->second.version == version;
  });
}

/// What the receiver has, or that with a patch, or else the newest source as a whole.
Result<ChosenVersion> MapSender::State::choose_version(const SourcePart& source, const Viewer& viewer) {
  const KnownVersion* before = believed_version(viewer, source.part.key);
  if (before != nullptr &&
      (options.keeps_good_enough || before->content_revision == source.content_revision) &&
      encodings.fits(*before, source, viewer.view))
    return ChosenVersion{{before->content_revision, source.links, before->encoding}};
  if (const KnownVersion* base = base_for(viewer, source.part.key); base != nullptr) {
    DELTAMESH_TRY(auto patched, encodings.patch(source, viewer.view, *base));
    if (patched != nullptr)
      return ChosenVersion{{source.content_revision, source.links, std::move(patched)}, true};
  }
  DELTAMESH_TRY(auto whole, encodings.get(source, viewer.view));
  return ChosenVersion{{source.content_revision, source.links, std::move(whole)}};
}

Result<void> MapSender::State::make_version(const PartKey& key, ChosenVersion chosen, const SendPlan& plan,
                                            Viewer& viewer, double now) {
  const SourcePart& source = *map.find(key);
  const auto encoding = chosen.version.encoding;
  const KnownVersion* had = believed_version(viewer, key);
  const bool is_the_same = had != nullptr && had->encoding->hash == encoding->hash;
  const std::optional<Believed> before = viewer.believed(key);
  const std::uint32_t told = version_hash(encoding->hash, chosen.version.links);
  known[key][told] = std::move(chosen.version);
  const std::uint64_t revision = viewer.next_revision(key, source.revision, now);
  std::vector<PartLink> links = links_for(source, encoding->decoded.mesh, viewer, plan);
  links_made += links.size();
  SentPart& sent = viewer.sent[key];
  sent.add(part_box(encoding->decoded.mesh));
  if (std::exchange(sent.content, source.content_revision) != source.content_revision)
    sent.refusals = std::min(sent.refusals, 1U);  // other content, which may fit

  const std::uint64_t number = viewer.delivery.next_number();
  viewer.has[key] = {.revision = revision,
                     .since = is_the_same ? before->since : revision,
                     .version = told,
                     .stage = Believed::Stage::kSent,
                     .number = number,
                     .base = chosen.is_patch ? encoding->base_key : key};
  const bool is_whole = !is_the_same && !chosen.is_patch;
  const std::optional<double> since = viewer.take_lost_since(key);
  const auto add = [&](Result<std::vector<std::byte>> message) -> Result<void> {
    if (!message) return message.error();
    viewer.delivery.add({key, *std::move(message), before, is_whole, since});
    return {};
  };
  if (is_the_same) {
    ++counts.entries_sent;
    return add(write_entry({.map = description_hash,
                            .start = viewer.begin,
                            .number = number,
                            .entry = entry_of(source, *encoding, revision, std::move(links))}));
  }
  ++counts.parts_sent;
  PartMessage message{.map = description_hash,
                      .start = viewer.begin,
                      .number = number,
                      .key = key,
                      .revision = revision,
                      .group = source.group,
                      .links = std::move(links)};
  if (chosen.is_patch) {
    ++counts.patches_sent;
    return add(write_patch({std::move(message), encoding->base_key, encoding->patch}));
  }
  message.octets = encoding->octets;
  return add(write_part(message));
}

/// What the receiver is believed to have of a part; null: nothing, or it is not known what.
const KnownVersion* MapSender::State::believed_version(const Viewer& viewer, const PartKey& key) const {
  const auto has = viewer.has.find(key);
  if (has == viewer.has.end() || has->second.is_gone) return nullptr;
  return find_version(known, key, has->second.version);
}

/// What a patch may be of: the version that the receiver has of the part, or else the largest of those in
/// whose place it comes. Null: nothing.
const KnownVersion* MapSender::State::base_for(const Viewer& viewer, const PartKey& key) const {
  if (!options.keeps_good_enough) return nullptr;
  const KnownVersion* largest = believed_version(viewer, key);
  if (largest != nullptr) return largest;
  const auto size = [](const KnownVersion& v) { return v.encoding->decoded.mesh.triangle_count(); };
  for (const PartKey& other : overlapping(viewer.has, key)) {
    if (map.is_copy(key) || map.is_copy(other) || map.outdated_since(other) > 0)
      continue;  // copies have hardly a face in common with what they are of
    const KnownVersion* version = believed_version(viewer, other);
    if (version != nullptr && (largest == nullptr || size(*version) > size(*largest))) largest = version;
  }
  return largest;
}

Result<void> MapSender::State::make_removal(const PartKey& key, const SendPlan& plan, Viewer& viewer,
                                            double now) {
  const std::uint64_t revision = viewer.next_revision(key, map.revision(), now);
  viewer.sent[key].is_removal = true;
  const std::optional<Believed> before = viewer.believed(key);
  const std::uint64_t number = viewer.delivery.next_number();
  viewer.has[key] = {.revision = revision,
                     .since = revision,
                     .stage = Believed::Stage::kSent,
                     .is_gone = true,
                     .number = number,
                     .base = key};
  ++counts.entries_sent;
  std::vector<PartLink> links =
      map.find(key) == nullptr ? map.replacements_of(key) : map.copies_in_place_of(key, plan.wanted);
  // What the receiver is not to have is not waited for.
  std::erase_if(links,
                [&](const PartLink& link) { return link.together && plan.unwanted.contains(link.key); });
  for (const PartLink& link : links)
    if (link.together) viewer.has[key].in_place.push_back(link.key);
  DELTAMESH_TRY(auto message,
                write_entry({.map = description_hash,
                             .start = viewer.begin,
                             .number = number,
                             .entry = {.key = key, .revision = revision, .links = std::move(links)}}));
  viewer.delivery.add({key, std::move(message), before, false, viewer.take_lost_since(key)});
  return {};
}

Result<void> MapSender::State::send_what_is_due(Viewer& viewer, double now,
                                                std::vector<std::vector<std::byte>>& messages) {
  for (bool is_complete = false; !is_complete;) {
    is_complete = true;
    const SeenCells seen(viewer, map, encodings.codec().description());
    DELTAMESH_CHECK(make_copies(viewer, seen, now));
    DELTAMESH_TRY(SendPlan plan, plan_for(viewer, seen, now, map, encodings, known, options.keeps_good_enough,
                                          [&] { return is_call_over(true); }));
    if (!plan.is_complete) return {};
    for (const PartKey& key : plan.needed) viewer.due.try_emplace(key, map.revision());
    std::erase_if(viewer.due, [&](const auto& entry) { return !plan.needed.contains(entry.first); });
    std::erase_if(viewer.lost_since, [&](const auto& entry) {
      return !plan.needed.contains(entry.first) && !plan.removed.contains(entry.first);
    });
    for (const SendUnit& unit : units_of(plan, viewer, map, known, encodings.codec().description())) {
      // What is shown together is made at once, so that it comes together whatever changes until it is sent.
      if (!viewer.allowance.may_spend() || is_call_over(!messages.empty())) break;
      DELTAMESH_TRY(is_complete, send(unit, plan, viewer, now, messages));
      if (!is_complete) break;
    }
    if (!is_complete) continue;
    counts.kept += plan.kept;
    DELTAMESH_CHECK(tell_faults(plan.faults, viewer, now, messages));
  }
  return {};
}

/// Tells the receiver what is new of faults, some at a time: parts do not wait for all of them.
Result<void> MapSender::State::tell_faults(const std::vector<PartFault>& faults, Viewer& viewer, double now,
                                           std::vector<std::vector<std::byte>>& messages) {
  constexpr int kMostAtOnce = 64;
  struct News {
    const PartFault* before = nullptr;
    const PartFault* after = nullptr;
  };
  std::map<PartKey, News> all;
  for (const PartFault& fault : viewer.faults) all[fault.key].before = &fault;
  for (const PartFault& fault : faults) all[fault.key].after = &fault;
  const auto code_of = [](const PartFault* fault) {
    return fault != nullptr ? static_cast<std::uint16_t>(fault->code) : std::uint16_t{0};
  };
  std::vector<PartFault> told;
  int left = kMostAtOnce;
  for (const auto& [key, news] : all) {
    const bool is_new = code_of(news.before) != code_of(news.after);
    if (is_new && left > 0) {
      const std::uint64_t number = viewer.delivery.next_number();
      DELTAMESH_TRY(auto message,
                    write_fault({description_hash, viewer.begin, number, key, code_of(news.after)}));
      viewer.delivery.add({key, std::move(message), viewer.believed(key)});
    }
    const PartFault* const said = is_new && left == 0 ? news.before : news.after;
    if (said != nullptr) told.push_back(*said);
    left -= is_new && left > 0 ? 1 : 0;
  }
  viewer.send_made(now, messages);
  viewer.faults = std::move(told);
  return {};
}

Result<bool> MapSender::State::send(const SendUnit& unit, SendPlan& plan, Viewer& viewer, double now,
                                    std::vector<std::vector<std::byte>>& messages) {
  std::vector<ChosenVersion> chosen;  // all before any links to what cannot be had
  for (const PartKey& key : unit.needed) {
    if (is_call_over(!chosen.empty() || !messages.empty())) break;
    DELTAMESH_TRY(chosen.emplace_back(), choose_version(*map.find(key), viewer));
    if (chosen.back().version.encoding == nullptr) return false;
  }
  const bool is_whole = chosen.size() == unit.needed.size();
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const PartKey& key = unit.needed[i];
    DELTAMESH_CHECK(make_version(key, std::move(chosen[i]), plan, viewer, now));
    plan.needed.erase(key);
    plan.staying.insert(key);
    viewer.due.erase(key);
  }
  // Last, as the parts in their place may be patches of them.
  for (const PartKey& key : is_whole ? unit.removed : std::vector<PartKey>()) {
    DELTAMESH_CHECK(make_removal(key, plan, viewer, now));
    plan.removed.erase(key);
  }
  viewer.send_made(now, messages);
  return true;
}

}  // namespace deltamesh
