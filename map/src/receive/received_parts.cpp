// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "receive/received_parts.h"

#include <algorithm>
#include <utility>

#include "support/limits.h"
#include "support/overlapping.h"

namespace deltamesh {
namespace {

constexpr std::size_t kMostReplaced = 32;

}  // namespace

PartLink link_to(const Version& version, const PartKey& other) noexcept {
  const auto found = std::ranges::lower_bound(version.links, other, {}, &PartLink::key);
  return found != version.links.end() && found->key == other ? *found : PartLink{.key = other};
}

bool fit(const PartKey& a, const Version& version_a, const PartKey& b, const Version& version_b) noexcept {
  const PartLink to_a = link_to(version_b, a);
  const PartLink to_b = link_to(version_a, b);
  return to_a.border == to_b.border && version_a.revision >= to_a.least && version_b.revision >= to_b.least;
}

const ReceivedPart* ReceivedParts::find(const PartKey& key) const noexcept {
  const auto found = parts_.find(key);
  return found == parts_.end() ? nullptr : &found->second;
}

std::shared_ptr<const PartContent> ReceivedParts::content(const PartKey& key, std::uint64_t hash) const {
  return content(key, [hash](std::uint64_t other) { return other == hash; });
}

std::shared_ptr<const PartContent> ReceivedParts::content(
    const PartKey& key, const std::function<bool(std::uint64_t)>& is_hash) const {
  const auto is_it = [&](const std::shared_ptr<const PartContent>& content) {
    return content && content->part.key == key && is_hash(content->hash);
  };
  if (const ReceivedPart* part = find(key); part != nullptr) {
    if (part->shown && is_it(part->shown->content)) return part->shown->content;
    for (const Version& version : part->waiting)
      if (is_it(version.content)) return version.content;
  }
  const auto found = std::ranges::find_if(replaced_, is_it);
  return found == replaced_.end() ? nullptr : *found;
}

void ReceivedParts::put(const PartKey& key, Version version) {
  ReceivedPart& part = parts_[key];
  if (part.waiting.size() == kMostWaiting) {
    Version oldest = std::move(part.waiting.front());
    part.waiting.erase(part.waiting.begin());
    drop(key, std::move(oldest));
  }
  for (const PartLink& link : version.links) linkers_[link.key].insert(key);
  part.newest = std::max(part.newest, version.revision);
  part.waiting.push_back(std::move(version));
  waiting_.insert(key);
}

/// Forgets a version that was the part's, with the links that no other has.
void ReceivedParts::drop(const PartKey& key, Version version) {
  const ReceivedPart& part = parts_.at(key);
  for (const PartLink& link : version.links) {
    const auto has_it = [&](const Version& other) {
      return std::ranges::binary_search(other.links, link.key, {}, &PartLink::key);
    };
    if ((part.shown && has_it(*part.shown)) || std::ranges::any_of(part.waiting, has_it)) continue;
    const auto linkers = linkers_.find(link.key);
    if (linkers == linkers_.end()) continue;
    linkers->second.erase(key);
    if (linkers->second.empty()) linkers_.erase(linkers);
  }
  if (version.content) remember(std::move(version.content));
}

void ReceivedParts::remember(std::shared_ptr<const PartContent> content) {
  replaced_.push_front(std::move(content));
  if (replaced_.size() > kMostReplaced) replaced_.pop_back();
}

void ReceivedParts::forget(const PartKey& key, std::uint64_t revision) {
  ReceivedPart& part = parts_[key];
  for (Version& version : std::exchange(part.waiting, {})) drop(key, std::move(version));
  waiting_.erase(key);
  part.newest = std::max(part.newest, revision);
}

/// What would be shown of a part if all accepted versions were; null: nothing.
const Version* ReceivedParts::effective(const PartKey& key) const noexcept {
  const ReceivedPart* part = find(key);
  if (part == nullptr || evicted_.contains(key)) return nullptr;
  const auto accepted = accepted_.find(key);
  if (accepted == accepted_.end()) return part->shown ? &*part->shown : nullptr;
  const Version& version = part->waiting[accepted->second];
  return version.content ? &version : nullptr;
}

/// A part that does not go with others is taken away if no view asks for it.
bool ReceivedParts::makes_room(const PartKey& other, const std::function<bool(const PartKey&)>& is_wanted) {
  if (is_wanted(other)) return false;
  if (accepted_.erase(other) != 0) is_stable_ = false;
  evicted_.insert(other);
  return true;
}

bool ReceivedParts::fits(const PartKey& key, const Version& version,
                         const std::function<bool(const PartKey&)>& is_wanted) {
  if (!version.content) return fits_gone(key, version, is_wanted);
  const bool is_asked_for = is_wanted(key);
  const auto gives_way = [&](const PartKey& other) { return is_asked_for && makes_room(other, is_wanted); };
  for (const PartLink& link : version.links) {
    const Version* other = effective(link.key);
    if (other == nullptr) {
      if (link.together && is_wanted(link.key)) return false;
    } else if (!fit(key, version, link.key, *other) && !gives_way(link.key)) {
      return false;
    }
  }
  if (const auto linkers = linkers_.find(key); linkers != linkers_.end()) {
    for (const PartKey& linker : linkers->second) {
      const Version* other = effective(linker);
      if (other != nullptr && !fit(key, version, linker, *other) && !gives_way(linker)) return false;
    }
  }
  return std::ranges::all_of(overlapping(parts_, key), [&](const PartKey& other) {
    return other == key || effective(other) == nullptr || gives_way(other);
  });
}

/// A part goes when what comes in its place is there, and no neighbour has a border with it, unless these are
/// copies, which have the same border [MAP-13].
bool ReceivedParts::fits_gone(const PartKey& key, const Version& version,
                              const std::function<bool(const PartKey&)>& is_wanted) {
  for (const PartLink& link : version.links)
    if (link.together && is_wanted(link.key) && effective(link.key) == nullptr) return false;
  const auto linkers = linkers_.find(key);
  if (linkers == linkers_.end() || (!version.links.empty() && version.links[0].border == kCopiesInPlace))
    return true;
  return std::ranges::all_of(linkers->second, [&](const PartKey& linker) {
    const Version* other = effective(linker);
    return other == nullptr || link_to(*other, key).border == 0 || makes_room(linker, is_wanted);
  });
}

/// Parts that this version has a link to, and those with a link to the part.
std::vector<PartKey> ReceivedParts::neighbours(const PartKey& key, std::size_t waiting) const {
  std::vector<PartKey> keys;
  for (const PartLink& link : parts_.at(key).waiting[waiting].links) keys.push_back(link.key);
  if (const auto linkers = linkers_.find(key); linkers != linkers_.end())
    keys.insert(keys.end(), linkers->second.begin(), linkers->second.end());
  return keys;
}

void ReceivedParts::settle(const std::function<bool(const PartKey&)>& is_wanted, std::set<PartKey>& touched) {
  evicted_.clear();
  for (const PartKey& key : waiting_) accepted_[key] = parts_.at(key).waiting.size() - 1;
  // Newest first: where two versions do not fit, the newer one knows of a change that the older one lacks.
  using Turn = std::pair<std::uint64_t, PartKey>;
  const auto turn_of = [&](const PartKey& key, std::size_t version) {
    return Turn{~parts_.at(key).waiting[version].revision, key};
  };
  for (is_stable_ = false; !is_stable_;) {
    is_stable_ = true;
    std::set<Turn> turns;
    for (const auto& [key, version] : accepted_) turns.insert(turn_of(key, version));
    while (!turns.empty()) {
      const PartKey key = turns.extract(turns.begin()).value().second;
      const auto accepted = accepted_.find(key);
      if (accepted == accepted_.end() || fits(key, parts_.at(key).waiting[accepted->second], is_wanted))
        continue;
      evicted_.clear();  // perhaps for this version alone
      is_stable_ = false;
      // Parts that fitted only because of this version are tested again now, not a round later.
      for (const PartKey& other : neighbours(key, accepted->second))
        if (const auto found = accepted_.find(other); found != accepted_.end())
          turns.insert(turn_of(other, found->second));
      if (accepted->second == 0) {
        accepted_.erase(accepted);
      } else {
        turns.insert(turn_of(key, --accepted->second));
      }
    }
  }
  evict(touched);
  show_accepted(touched);
}

void ReceivedParts::drop(const PartKey& key, std::set<PartKey>& touched) {
  if (find(key) == nullptr) return;
  forget(key, 0);
  evicted_.insert(key);
  evict(touched);
  parts_.erase(key);
}

void ReceivedParts::evict(std::set<PartKey>& touched) {
  for (const PartKey& key : evicted_) {
    ReceivedPart& part = parts_.at(key);
    if (!part.shown) continue;
    touched.insert(key);
    // It may come back.
    if (part.waiting.empty()) part.newest = std::max(part.shown->revision, std::uint64_t{1}) - 1;
    Version version = *std::exchange(part.shown, std::nullopt);
    drop(key, std::move(version));
  }
  evicted_.clear();
}

void ReceivedParts::show_accepted(std::set<PartKey>& touched) {
  for (const auto& [key, place] : accepted_) {
    ReceivedPart& part = parts_.at(key);
    const auto end = part.waiting.begin() + static_cast<std::ptrdiff_t>(place);
    std::vector<Version> gone(std::make_move_iterator(part.waiting.begin()), std::make_move_iterator(end));
    std::optional<Version> before = std::exchange(part.shown, std::move(*end));
    part.waiting.erase(part.waiting.begin(), end + 1);
    if (part.waiting.empty()) waiting_.erase(key);
    if (!before || before->content != part.shown->content) touched.insert(key);
    if (before) gone.push_back(*std::move(before));
    if (!part.shown->content) gone.push_back(*std::exchange(part.shown, std::nullopt));
    for (Version& version : gone) drop(key, std::move(version));
  }
  accepted_.clear();
}

void ReceivedParts::limit_removals(std::size_t most) {
  const auto is_removal = [](const auto& entry) {
    return !entry.second.shown && entry.second.waiting.empty();
  };
  if (static_cast<std::size_t>(std::ranges::count_if(parts_, is_removal)) > most)
    std::erase_if(parts_, is_removal);
}

}  // namespace deltamesh
