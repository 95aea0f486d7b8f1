// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From what receivers tell of their messages to what they are believed to have.
#include <algorithm>
#include <map>
#include <span>

#include "send/viewer_state.h"

namespace deltamesh {
namespace {

using Stage = Believed::Stage;
using Numbers = std::span<const std::uint64_t>;

/// Whether something is still on the way that was sent before a version and that it may be made from.
bool waits_for_earlier(const Believed& believed, const PartKey& key, const Delivery& delivery) {
  return std::ranges::any_of(delivery.on_the_way(), [&](const auto& entry) {
    return entry.first < believed.number && (entry.second.key == key || entry.second.key == believed.base);
  });
}

/// Takes back messages about a part, the last ones: as if they had not been sent.
void take_back(Viewer& viewer, const PartKey& key, Numbers numbers) {
  const std::optional<Believed> before = viewer.delivery.at(numbers.front()).before;
  viewer.lost_since.try_emplace(key, *viewer.delivery.at(numbers.front()).since);
  for (const std::uint64_t number : numbers) viewer.delivery.forget(number);
  if (!before) {
    viewer.has.erase(key);
    return;
  }
  Believed& has = viewer.has[key] = *before;
  if (has.stage == Stage::kSent && !viewer.delivery.is_on_the_way(has.number)) has.stage = Stage::kArrived;
}

/// How many of the last messages about a part are lost, with none between them that has arrived. `sent`: all
/// about the part that are on the way, ascending.
std::size_t lost_at_the_end(const Viewer& viewer, const PartKey& key, Numbers sent,
                            const std::vector<std::uint64_t>& lost) {
  const auto has = viewer.has.find(key);
  std::uint64_t last = has == viewer.has.end() ? 0 : has->second.number;
  std::size_t count = 0;
  for (; count < sent.size(); ++count) {
    const std::uint64_t number = sent[sent.size() - 1 - count];
    if (number != last || !std::ranges::binary_search(lost, number)) break;
    const auto& before = viewer.delivery.at(number).before;
    last = before ? before->number : 0;
  }
  return count;
}

/// Finds what arrived and the receiver did not keep. `before`: what it was believed to have before it told.
void note_refused(Viewer& viewer, const std::map<PartKey, Believed>& before, double now) {
  for (const auto& [key, believed] : before) {
    if (believed.stage != Stage::kArrived) continue;
    const auto has = viewer.has.find(key);
    if (has != viewer.has.end() && has->second.revision >= believed.revision) continue;
    if (believed.is_gone) {
      viewer.retry_refused(now);
    } else {
      viewer.sent[key].refuse(now);
    }
  }
}

}  // namespace

void take_receipt(Viewer& viewer, const Receipt& receipt, double now) {
  viewer.delivery.hear(receipt, now);
  for (auto& [key, believed] : viewer.has)
    if (believed.stage == Stage::kSent && !viewer.delivery.is_on_the_way(believed.number))
      believed.stage = Stage::kArrived;
}

void take_held(Viewer& viewer, const std::vector<HeldVersion>& held, double now) {
  const std::map<PartKey, Believed> before = viewer.has;
  // What has come and is not there was refused, or is gone.
  std::erase_if(viewer.has, [&](const auto& entry) {
    const auto& [key, believed] = entry;
    return believed.stage == Stage::kTold ||
           (believed.stage == Stage::kArrived && !waits_for_earlier(believed, key, viewer.delivery));
  });
  for (const HeldVersion& version : held) {
    SentPart& sent = viewer.sent[version.key];
    if (version.revision < sent.first) sent.first = 0;
    // Of an earlier sender, or record of this viewer.
    if (sent.revision < version.revision) {
      sent.revision = version.revision;
      sent.is_everywhere = true;
    }
    if (const auto newer = viewer.has.find(version.key);
        newer != viewer.has.end() &&
        newer->second.revision + (newer->second.is_gone ? 1 : 0) > version.revision)
      continue;
    const auto known = before.find(version.key);
    if (known != before.end() && known->second.is_gone && version.is_waiting &&
        sent.time > viewer.waiting_since(now)) {
      viewer.has[version.key] = known->second;  // until what comes in its place is there
      continue;
    }
    if (version.revision >= sent.revision) sent.refusals = 0;
    const bool is_the_same = known != before.end() && !known->second.is_gone &&
                             known->second.version == version.version &&
                             known->second.since <= version.revision;
    viewer.has[version.key] = {.revision = version.revision,
                               .since = is_the_same ? known->second.since : version.revision,
                               .version = version.version,
                               .is_waiting = version.is_waiting};
  }
  note_refused(viewer, before, now);
}

void recover(Viewer& viewer, double now, std::vector<std::vector<std::byte>>& messages) {
  const std::vector<std::uint64_t> lost = viewer.delivery.take_lost(now);
  if (const auto probe = viewer.delivery.probe(now); lost.empty() && probe && viewer.allowance.may_spend())
    viewer.post(viewer.delivery.send_again(*probe, now), 1, messages);
  if (lost.empty()) return;
  std::map<PartKey, std::vector<std::uint64_t>> sent;
  for (const auto& [number, message] : viewer.delivery.on_the_way()) sent[message.key].push_back(number);
  std::vector<std::uint64_t> again;
  for (const auto& [key, numbers] : sent) {
    const std::size_t end = lost_at_the_end(viewer, key, numbers, lost);
    if (end > 0) take_back(viewer, key, Numbers(numbers).last(end));
    for (const std::uint64_t number : Numbers(numbers).first(numbers.size() - end)) {
      if (!std::ranges::binary_search(lost, number)) continue;
      if (viewer.delivery.at(number).is_superseded || !viewer.delivery.is_told_of(number)) {
        if (key == kNoPart && !viewer.delivery.at(number).is_superseded) viewer.pose.reset();
        viewer.delivery.skip(number);
      } else {
        again.push_back(number);
      }
    }
  }
  std::ranges::sort(again);
  for (const std::uint64_t number : again) {
    if (!viewer.allowance.may_spend()) break;
    const SentMessage& message = viewer.delivery.send_again(number, now);
    if (message.key != kNoPart) viewer.sent[message.key].time = now;
    viewer.post(message, viewer.copies_of(message), messages);
  }
}

}  // namespace deltamesh
