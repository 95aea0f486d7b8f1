// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "base/try.h"
#include "lattice/borders_of_links.h"
#include "part/view_cells.h"
#include "part/view_quality.h"
#include "send/viewer_state.h"
#include "send/wanted_parts.h"

namespace deltamesh {
namespace {

class Planner {
 public:
  Planner(const Viewer& viewer, const SeenCells& seen, double now, const SourceMap& map, Encodings& encodings,
          KnownVersions& known, bool keeps_good_enough, const std::function<bool()>& is_over)
      : viewer_(viewer),
        seen_(seen),
        now_(now),
        waiting_since_(viewer.waiting_since(now)),
        map_(map),
        encodings_(encodings),
        known_(known),
        keeps_good_enough_(keeps_good_enough),
        is_over_(is_over),
        encoded_(encodings.encoded()) {}

  Result<SendPlan> run() {
    WantedParts parts = wanted_parts(viewer_, map_, encodings_.codec().description(), seen_);
    const auto asked = check_view(viewer_.view, encodings_.codec().description());
    for (auto next = parts.wanted.begin(); next != parts.wanted.end();) {
      const PartKey key = *next++;
      const Error* fault = encodings_.fault(*map_.find(key), viewer_.view);
      const SentPart* refused = refused_of(key);
      const bool is_impossible = fault != nullptr && fault->code != ErrorCode::kUnmetRequest;
      if (is_impossible || (fault != nullptr && refused == nullptr)) {
        plan_.faults.push_back({key, fault->code, fault->message, fault->best_value});
      } else if (refused != nullptr) {
        plan_.faults.push_back({key, ErrorCode::kLimitExceeded, "the receiver did not keep it"});
      } else if (!asked && asked.error().code == ErrorCode::kInvalidArgument) {  // of all parts
        plan_.faults.push_back({key, ErrorCode::kUnmetRequest, asked.error().message});
      }
      if (is_impossible || (refused != nullptr && now_ < refused->again_at))
        parts.others.insert(parts.wanted.extract(key));
    }
    for (const PartKey& key : parts.wanted) {
      DELTAMESH_CHECK(look_at(key, *map_.find(key)));
      plan_.is_complete = encodings_.encoded() == encoded_ || !is_over_();
      if (!plan_.is_complete) return std::move(plan_);
    }
    for (const auto& [key, believed] : viewer_.has)
      if (!believed.is_gone && !will_be_made_anew(key) &&
          (map_.find(key) == nullptr || parts.others.contains(key)))
        plan_.removed.insert(key);
    plan_.wanted = std::move(parts.wanted);
    plan_.unwanted = std::move(parts.others);
    for (const auto& [key, believed] : viewer_.has)
      if (believed.is_gone && (map_.find(key) == nullptr || plan_.unwanted.contains(key)) &&
          waits_in_vain(believed))
        plan_.removed.insert(key);
    add_what_does_not_fit();
    for (const auto& [key, version] : kept_) plan_.staying.insert(key);
    for (const auto& [key, believed] : viewer_.has)
      if (is_newest(key, believed)) plan_.staying.insert(key);
    for (const auto& [key, version] : kept_)
      if (version->content_revision != map_.find(key)->content_revision) ++plan_.kept;
    return std::move(plan_);
  }

 private:
  /// Null where the receiver did not refuse the part's content.
  const SentPart* refused_of(const PartKey& key) const {
    const auto sent = viewer_.sent.find(key);
    const bool is_refused = sent != viewer_.sent.end() && sent->second.is_refused() &&
                            sent->second.content == map_.find(key)->content_revision;
    return is_refused ? &sent->second : nullptr;
  }

  /// Decides whether the receiver's version may stay.
  Result<void> look_at(const PartKey& key, const SourcePart& source) {
    const auto has = viewer_.has.find(key);
    if (has == viewer_.has.end() || has->second.is_gone) {
      plan_.needed.insert(key);
      return {};
    }
    const KnownVersion* version = find_version(known_, key, has->second.version);
    if (version == nullptr) {  // from before this sender was started: perhaps what it would send
      DELTAMESH_TRY(const auto newest, newest_version(source, viewer_.view, encodings_, known_));
      if (newest == has->second.version) version = find_version(known_, key, *newest);
    }
    const bool is_of_newest = version != nullptr && version->content_revision == source.content_revision;
    // What comes late must not be taken for what stays: that needs a later revision.
    const bool is_last = !viewer_.may_get_later(key, has->second);
    const bool may_stay = is_last && (is_of_newest || (version != nullptr && keeps_good_enough_));
    if (may_stay && !waits_too_long(key, has->second) && encodings_.fits(*version, source, viewer_.view)) {
      kept_.emplace(key, version);
    } else {
      plan_.needed.insert(key);
      if (is_last && is_of_newest && same_borders(version->links, source.links) && !has->second.is_waiting)
        plan_.refined.emplace(key, has->second.since);
    }
    return {};
  }

  /// A copy of the view's level whose newer version is still to come.
  bool will_be_made_anew(const PartKey& key) const {
    return map_.outdated_since(key) > 0 && key.level == viewer_.view.level &&
           is_in_view(key, viewer_.view, encodings_.codec().description());
  }

  /// A removal that waits for what will not come any more.
  bool waits_in_vain(const Believed& removal) const {
    return std::ranges::any_of(removal.in_place, [&](const PartKey& other) {
      return map_.find(other) == nullptr || plan_.unwanted.contains(other);
    });
  }

  bool is_newest(const PartKey& key, const Believed& believed) const {
    const SourcePart* source = map_.find(key);
    const KnownVersion* version = find_version(known_, key, believed.version);
    return source != nullptr && version != nullptr && !viewer_.may_get_later(key, believed) &&
           version->content_revision == source->content_revision;
  }

  /// Parts in place of a copy wait for the last one of them.
  bool waits_too_long(const PartKey& key, const Believed& believed) const {
    if (!believed.is_waiting || viewer_.sent.at(key).time > waiting_since_) return false;
    for (int level = key.level + 1; level <= kMostPartLevel; ++level) {
      const PartKey around = ancestor(key, static_cast<std::uint8_t>(level));
      const auto has = viewer_.has.find(around);
      if (has == viewer_.has.end()) continue;
      if (has->second.is_gone) return false;  // until a view tells what became of it
      const auto is_inside = [&](const auto& entry) { return overlap(entry.first, around); };
      if (std::ranges::any_of(viewer_.due, is_inside)) return false;
      return std::ranges::none_of(viewer_.sent, [&](const auto& entry) {
        return is_inside(entry) && entry.second.time > waiting_since_;
      });
    }
    return true;
  }

  /// The links of a part as it will be with the receiver; null: nothing is there.
  const std::vector<PartLink>* links_of(const PartKey& key) const {
    const auto kept = kept_.find(key);
    if (kept != kept_.end()) return &kept->second->links;
    return plan_.needed.contains(key) ? &map_.find(key)->links : nullptr;
  }

  bool must_go(const PartKey& key) {
    const SourcePart* source = map_.find(key);
    const auto kept = kept_.find(key);
    if (source == nullptr || kept == kept_.end() || same_borders(kept->second->links, source->links))
      return false;
    kept_.erase(kept);
    plan_.needed.insert(key);
    return true;
  }

  /// Newest versions fit to each other, so that it ends at the latest when nothing is kept.
  void add_what_does_not_fit() {
    for (bool is_stable = false; !is_stable;) {
      is_stable = true;
      std::vector<PartKey> keys(plan_.needed.begin(), plan_.needed.end());
      for (const auto& [key, version] : kept_) keys.push_back(key);
      for (const PartKey& key : keys)
        if (!fits(key)) is_stable = false;
    }
  }

  bool fits(const PartKey& key) {
    bool all_fit = true;
    const std::vector<PartLink> links = *links_of(key);
    for (const PartLink& link : links) {
      const std::vector<PartLink>* other = links_of(link.key);
      if (other == nullptr) {
        // It has a border with what goes.
        if (plan_.removed.contains(link.key) && must_go(key)) all_fit = false;
      } else if (border_in(*other, key) != link.border) {
        if (must_go(key)) all_fit = false;
        if (must_go(link.key)) all_fit = false;
      }
    }
    return all_fit;
  }

  const Viewer& viewer_;
  const SeenCells& seen_;
  double now_;
  double waiting_since_;
  const SourceMap& map_;
  Encodings& encodings_;
  KnownVersions& known_;
  bool keeps_good_enough_;
  const std::function<bool()>& is_over_;
  std::uint64_t encoded_;  ///< when it began
  SendPlan plan_;
  std::map<PartKey, const KnownVersion*> kept_;
};

}  // namespace

const KnownVersion* find_version(const KnownVersions& known, const PartKey& key,
                                 std::uint32_t version) noexcept {
  const auto versions = known.find(key);
  if (versions == known.end()) return nullptr;
  const auto found = versions->second.find(version);
  return found == versions->second.end() ? nullptr : &found->second;
}

Result<std::optional<std::uint32_t>> newest_version(const SourcePart& source, const View& view,
                                                    Encodings& encodings, KnownVersions& known) {
  DELTAMESH_TRY(const auto encoding, encodings.get(source, view));
  if (encoding == nullptr) return std::optional<std::uint32_t>();
  const std::uint32_t version = version_hash(encoding->hash, source.links);
  known[source.part.key][version] = {source.content_revision, source.links, encoding};
  return std::optional(version);
}

Result<SendPlan> plan_for(const Viewer& viewer, const SeenCells& seen, double now, const SourceMap& map,
                          Encodings& encodings, KnownVersions& known, bool keeps_good_enough,
                          const std::function<bool()>& is_over) {
  return Planner(viewer, seen, now, map, encodings, known, keeps_good_enough, is_over).run();
}

}  // namespace deltamesh
