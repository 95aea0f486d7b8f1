// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A sender's record of a receiver, and the plan of what to send to it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "deltamesh/map/messages.h"
#include "send/encodings.h"
#include "send/link/allowance.h"
#include "send/link/believed.h"
#include "send/link/delivery.h"
#include "send/source_map.h"

namespace deltamesh {

/// Around the vertices of a part.
struct PartBox {
  std::array<float, 3> low{};
  std::array<float, 3> high{};

  void add(const PartBox& other) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
};

/// The last message to a receiver about a part.
struct SentPart {
  std::uint64_t revision = 0;  ///< of the last message
  std::uint64_t first = 0;     ///< of the first one; 0: the receiver may have something older
  double time = -std::numeric_limits<double>::infinity();  ///< of the last message
  bool is_removal = false;
  bool is_everywhere = false;       ///< told of by the receiver, and unknown
  std::optional<PartBox> extent{};  ///< of all versions that were sent
  std::uint64_t content = 0;        ///< SourcePart::content_revision of the last version
  /// How often the receiver got that content and did not keep it, until it holds it.
  unsigned refusals = 0;
  double again_at = 0;  ///< seconds; until then it is not sent again after `refusals`

  void add(const PartBox& version) noexcept {
    if (!extent) extent = version;
    extent->add(version);
  }
  /// Refused once may be bad luck; from the second time on each wait is four times as long, 17 minutes at
  /// most.
  void refuse(double now) noexcept {
    ++refusals;
    again_at = now + (is_refused() ? std::ldexp(1.0, static_cast<int>(2 * std::min(refusals - 2, 5U))) : 0);
  }
  bool is_refused() const noexcept { return refusals > 1; }
};

/// Seconds for a first reply to the map's message.
inline constexpr double kDescribeWait = 0.2;

/// In place of a key, for messages about no part: poses, and a start after the last message.
inline constexpr PartKey kNoPart{kMostPartLevel + 1, 0, 0, 0};

struct Viewer {
  View view{};
  std::uint64_t number = 0;  ///< of its last view
  std::uint64_t said = 0;    ///< the highest number of its views and receipts
  std::uint64_t map = 0;     ///< hash of the description that it has
  std::uint64_t start = 0;   ///< of the messages that it takes
  std::uint64_t begin = 0;   ///< start of its messages: above that of an earlier record of it
  Delivery delivery{};
  std::map<PartKey, Believed> has{};
  std::map<PartKey, SentPart>
      sent{};  ///< all parts that it may have or that may be on their way; shrinks by hear()
  std::map<PartKey, std::uint64_t> due{};  ///< what it lacks, and the map's revision since when
  /// Parts whose last messages were lost, until something is sent in their place or none is needed: when the
  /// first of these messages was sent, seconds.
  std::map<PartKey, double> lost_since{};
  std::vector<PartFault> faults{};  ///< as the receiver was told last; ascending by key
  Allowance allowance{};
  std::optional<MapPose> pose{};             ///< as it was sent last
  bool waits_for_copies = false;             ///< that it is to see first, and that are still to be made
  std::optional<double> copies_due_since{};  ///< when the first of those that are to be made was missed
  double heard = 0;                          ///< when it spoke last, seconds
  double describe_next = 0;                  ///< when the map's message may be sent, seconds
  double describe_wait = kDescribeWait;      ///< from then to the next time; twice as long each time

  /// SentMessage::since of the next message about a part; empty where its last one was not lost.
  std::optional<double> take_lost_since(const PartKey& key) {
    const auto lost = lost_since.extract(key);
    return lost.empty() ? std::nullopt : std::optional(lost.mapped());
  }

  /// How often to send a message: once; on a slow link up to 4 times where it replaces lost ones, so that
  /// these are not lost, too. The later it is, the more often, and a small one more often than a large one.
  int copies_of(const SentMessage& message) const noexcept {
    constexpr double kLate = 0.25;        // seconds
    constexpr std::size_t kSmall = 1200;  // bytes
    const double late = message.time - message.since.value_or(message.time);
    if (late <= 0 || !delivery.is_slow()) return 1;
    const int least = message.bytes.size() <= kSmall ? 2 : 1;
    return std::clamp(least - 1 + static_cast<int>(late / kLate), least, 4);
  }
  /// Adds so many copies of a message, or fewer where the rate allows no more, but at least one.
  void post(const SentMessage& message, int copies, std::vector<std::vector<std::byte>>& messages) {
    for (int i = 0; i < copies && (i == 0 || allowance.may_spend()); ++i) {
      allowance.spend(message.bytes.size());
      messages.push_back(message.bytes);
    }
  }

  /// Whether the receiver may have an older version of the part. If not, a new one takes the place of nothing
  /// that is shown, and need not wait for other parts [MAP-12].
  bool may_have_before(const PartKey& key, std::uint64_t revision) const {
    const auto found = sent.find(key);
    return found != sent.end() && found->second.first < revision;
  }

  /// Whether a later message about the part was taken for lost, and may come all the same.
  bool may_get_later(const PartKey& key, const Believed& than) const {
    const auto found = sent.find(key);
    return found != sent.end() && found->second.revision > than.revision;
  }

  /// Sends of what is made as much as may be sent now.
  void send_made(double now, std::vector<std::vector<std::byte>>& messages) {
    while (delivery.has_unsent() && allowance.may_spend()) {
      const SentMessage& message = delivery.send_next(now);
      post(message, copies_of(message), messages);
    }
  }

  /// What was sent by then and still waits is not waited for any longer.
  double waiting_since(double now) const { return now - std::max(1.0, 4 * delivery.timeout()); }

  /// The receiver may have room now: what it refused is sent again within a second.
  void retry_refused(double now) noexcept {
    for (auto& [key, part] : sent) part.again_at = std::min(part.again_at, now + 1);
  }

  std::optional<Believed> believed(const PartKey& key) const {
    const auto found = has.find(key);
    return found == has.end() ? std::nullopt : std::optional(found->second);
  }

  /// For a message about a version of `least` or later: above all that came before it.
  std::uint64_t next_revision(const PartKey& key, std::uint64_t least, double now) {
    const auto [place, is_first] = sent.try_emplace(key);
    SentPart& part = place->second;
    part.time = now;
    part.is_removal = false;
    part.revision = std::max({part.revision + 1, least, begin});
    if (is_first) part.first = part.revision;
    return part.revision;
  }
};

/// Takes what a receiver tells of its messages.
void take_receipt(Viewer& viewer, const Receipt& receipt, double now);
/// Takes what it tells of its parts, with the receipt. Removals that were sent before waiting_since(), and
/// that still wait, are taken for not sent.
void take_held(Viewer& viewer, const std::vector<HeldVersion>& held, double now);

/// Sends again what later messages of a part are made from, and takes back what was believed of all others
/// that were lost, so that the next plan sends something newer.
void recover(Viewer& viewer, double now, std::vector<std::vector<std::byte>>& messages);

using KnownVersions = std::map<PartKey, std::map<std::uint32_t, KnownVersion>>;

/// The parts to send to a receiver and to remove.
struct SendPlan {
  std::set<PartKey> wanted;    ///< parts that the receiver is to have
  std::set<PartKey> unwanted;  ///< other parts in its view: coarser or finer copies of these
  std::set<PartKey> needed;    ///< parts of which a newer version is to be sent
  /// Of these, what is needed for its quality alone: the first revision of what the receiver has.
  std::map<PartKey, std::uint64_t> refined;
  std::set<PartKey> removed;  ///< parts that are to go
  /// Parts that go with all newest ones as the receiver has them: copies too that are to go [MAP-19].
  std::set<PartKey> staying;
  std::vector<PartFault>
      faults{};             ///< parts that do not come as the view asks; those without any are unwanted
  std::uint64_t kept = 0;   ///< parts with a newer source whose old version will do
  bool is_complete = true;  ///< false: time was over before all was known that it needs
};

class SeenCells;

/// Plans for all parts in the view: those that are missing or break the view's bounds, and those that would
/// not fit to these any more [MAP-12]. Adds the newest versions that it compares to `known`. Parts that the
/// receiver does not show, and about which no message was sent since waiting_since(), are sent again.
/// `is_over`: whether time is over; then it encodes one part more at the most, and another call goes on.
/// Errors: as Encodings::get().
Result<SendPlan> plan_for(const Viewer& viewer, const SeenCells& seen, double now, const SourceMap& map,
                          Encodings& encodings, KnownVersions& known, bool keeps_good_enough,
                          const std::function<bool()>& is_over);

/// The newest version for a view, which `known` gains; null: there is none. Errors: as Encodings::get().
Result<std::optional<std::uint32_t>> newest_version(const SourcePart& source, const View& view,
                                                    Encodings& encodings, KnownVersions& known);

const KnownVersion* find_version(const KnownVersions& known, const PartKey& key,
                                 std::uint32_t version) noexcept;

}  // namespace deltamesh
