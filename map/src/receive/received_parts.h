// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The versions of parts that a receiver holds, and which of them are shown.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "deltamesh/map/part.h"
#include "deltamesh/map/part_entry.h"

namespace deltamesh {

struct PartContent {
  std::vector<std::byte> octets;
  std::uint64_t hash = 0;
  MapPart part;
};

/// A version of a part, or its removal.
struct Version {
  std::uint64_t revision = 0;
  std::uint64_t group = 0;
  std::vector<PartLink> links{};
  std::shared_ptr<const PartContent> content{};  ///< null: the part is gone
};

/// The link of a version to another part; an empty link if it has none.
PartLink link_to(const Version& version, const PartKey& other) noexcept;

/// Whether versions of parts with these keys may be shown side by side [MAP-12].
bool fit(const PartKey& a, const Version& version_a, const PartKey& b, const Version& version_b) noexcept;

struct ReceivedPart {
  std::optional<Version> shown{};
  std::vector<Version> waiting{};  ///< newer than what is shown; ascending by revision, at most kMostWaiting
  std::uint64_t newest = 0;        ///< no message of an older revision is of interest
};
inline constexpr std::size_t kMostWaiting = 8;

/// Versions come in by put(); settle() shows what can be shown.
class ReceivedParts {
 public:
  const std::map<PartKey, ReceivedPart>& all() const noexcept { return parts_; }
  const ReceivedPart* find(const PartKey& key) const noexcept;

  /// Content of a part with these octets: shown, waiting, or replaced not long ago; null if there is none.
  std::shared_ptr<const PartContent> content(const PartKey& key, std::uint64_t hash) const;
  /// The same, for octets whose xxh3-64 `is_hash` accepts.
  std::shared_ptr<const PartContent> content(const PartKey& key,
                                             const std::function<bool(std::uint64_t)>& is_hash) const;

  /// Keeps content for a while.
  void remember(std::shared_ptr<const PartContent> content);
  /// Takes a version that is newer than what is there. To be followed by settle().
  void put(const PartKey& key, Version version);
  /// Shows the newest waiting versions that fit to each other and to what stays [MAP-12]. `is_wanted`:
  /// whether a key is in the view; parts that are not make room for those that are. Keys of what is shown
  /// otherwise than before go into `touched`.
  void settle(const std::function<bool(const PartKey&)>& is_wanted, std::set<PartKey>& touched);
  /// Drops the waiting versions; nothing of an older revision is taken from now on. Precondition: nothing of
  /// the part is shown.
  void forget(const PartKey& key, std::uint64_t revision);
  /// Drops all versions of a part, which may come again.
  void drop(const PartKey& key, std::set<PartKey>& touched);
  /// Forgets removals beyond `most`, all of them.
  void limit_removals(std::size_t most);
  const std::deque<std::shared_ptr<const PartContent>>& replaced() const noexcept { return replaced_; }
  void forget_replaced() { replaced_.clear(); }

 private:
  const Version* effective(const PartKey& key) const noexcept;
  bool fits(const PartKey& key, const Version& version, const std::function<bool(const PartKey&)>& is_wanted);
  bool fits_gone(const PartKey& key, const Version& version,
                 const std::function<bool(const PartKey&)>& is_wanted);
  std::vector<PartKey> neighbours(const PartKey& key, std::size_t waiting) const;
  bool makes_room(const PartKey& other, const std::function<bool(const PartKey&)>& is_wanted);
  void drop(const PartKey& key, Version version);
  void show_accepted(std::set<PartKey>& touched);
  void evict(std::set<PartKey>& touched);

  std::map<PartKey, ReceivedPart> parts_;
  std::map<PartKey, std::set<PartKey>> linkers_;  ///< parts with a version that has a link to the key
  std::set<PartKey> waiting_;                     ///< those with waiting versions
  std::deque<std::shared_ptr<const PartContent>> replaced_;  ///< latest first: patches may be of these
  // While settle() runs:
  std::map<PartKey, std::size_t> accepted_;  ///< by key, which of the waiting versions
  std::set<PartKey> evicted_;
  bool is_stable_ = false;
};

}  // namespace deltamesh
