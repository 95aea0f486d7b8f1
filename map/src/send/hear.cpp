// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a sender hears: views and receipts.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "message/frame.h"
#include "part/view_quality.h"
#include "send/state.h"
#include "support/errors.h"

namespace deltamesh {
namespace {

constexpr double kLongestOnTheWay = 60;  // seconds: what a link holds for longer is taken to be lost
constexpr double kMakesRoom = 5;         // seconds; after which a viewer makes room for another
constexpr double kDescribeAgain = 0.4;   // seconds; who speaks gets the map's message soon
constexpr double kReuse = 0.5;  // seconds; in which a number's earlier receiver is not heard any more
constexpr std::uint64_t kMostTold = std::uint64_t{1} << 62;
constexpr std::uint64_t kBetweenRecords = 1 << 10;  // revisions that a receiver may have and not tell of

/// Drops the records of parts that the map and the receiver no longer have, once no message about them can be
/// on its way. A later part of the same key has a higher revision, so that it needs no record; nor does what
/// only the receiver told of.
void forget_gone_parts(Viewer& viewer, const SourceMap& map, double now) {
  std::erase_if(viewer.sent, [&](const auto& entry) {
    const auto& [key, sent] = entry;
    const bool is_old = sent.revision < map.revision() || std::isinf(sent.time);
    return map.find(key) == nullptr && !viewer.has.contains(key) && is_old &&
           now - sent.time > kLongestOnTheWay;
  });
}

}  // namespace

Result<void> MapSender::State::hear(std::span<const std::byte> bytes, double now) {
  DELTAMESH_TRY(const MessageKind kind, kind_of_message(bytes));
  if (kind == MessageKind::kReceipt) return hear_receipt(bytes, now);
  if (kind != MessageKind::kFragment) return hear_view(bytes, now);
  DELTAMESH_TRY(const auto whole, fragments.add(bytes));
  if (!whole) return {};
  return hear_view(*whole, now);
}

Result<void> MapSender::State::hear_view(std::span<const std::byte> bytes, double now) {
  DELTAMESH_TRY(const ViewMessage told, read_view(bytes));
  const MapDescription& of = encodings.codec().description();
  if (told.map_id != of.id) return invalid_argument("a view of another map");
  const Result<void> asked =
      check_view(told.view, of);  // a bad bound does not stop the view from being served
  if (told.map != 0 && told.map != description_hash && told.epoch >= of.epoch)
    DELTAMESH_CHECK(begin_epoch(told.epoch));
  DELTAMESH_TRY(Viewer* const found, viewer_of(told, now));
  if (found == nullptr) return {};
  Viewer& viewer = *found;
  viewer.number = told.number;
  if (std::exchange(viewer.view, told.view) != told.view) viewer.retry_refused(now);
  std::vector<View> views;
  for (const auto& [number, other] : viewers) views.push_back(other.view);
  encodings.set_views(std::move(views));
  if (told.number < viewer.said) return asked;  // a later receipt tells better what it has
  if (viewer.said == 0 || viewer.start != told.start) {
    viewer.delivery = Delivery(told.receipt.highest);
    viewer.pose.reset();
  }
  viewer.heard = now;
  viewer.said = told.number;
  viewer.map = told.map;
  viewer.start = told.start;
  viewer.describe_next = std::min(viewer.describe_next, now + kDescribeAgain);
  take_receipt(viewer, told.receipt, now);
  take_held(viewer, told.held, now);
  forget_gone_parts(viewer, map, now);
  return asked;
}

/// The record of the receiver that sent a view; null: the view is old. Errors: kLimitExceeded.
Result<Viewer*> MapSender::State::viewer_of(const ViewMessage& message, double now) {
  std::uint64_t told = std::max(message.start, map.revision());
  for (const HeldVersion& held : message.held) told = std::max(told, held.revision);
  if (told >= kMostTold) return invalid_argument("a view of a start or a revision that no sender has");
  std::erase_if(viewers, [&](const auto& v) { return now - v.second.heard > options.viewer_seconds; });
  bool is_known = message.start >= start;
  if (const auto found = viewers.find(message.viewer); found != viewers.end()) {
    Viewer& viewer = found->second;
    const bool is_of_its_start = message.start == viewer.start;
    if (message.number > (is_of_its_start ? viewer.number : viewer.said)) return &viewer;
    // Another receiver with its number, which has not heard of this sender yet.
    const bool begins_anew = message.start == 0 && viewer.start != 0 && now - viewer.heard > kReuse;
    if (!begins_anew) return nullptr;
    viewers.erase(found);
    is_known = true;
  }
  if (viewers.size() >= options.most_viewers) {
    const auto longest = std::ranges::min_element(viewers, {}, [](const auto& v) { return v.second.heard; });
    if (longest == viewers.end() || now - longest->second.heard <= kMakesRoom)
      return Error{.code = ErrorCode::kLimitExceeded, .message = "too many viewers"};
    viewers.erase(longest);
  }
  Viewer& viewer = viewers[message.viewer];
  // What was sent to it before it was forgotten may still be on its way.
  viewer.begin = is_known ? told + kBetweenRecords : start;
  return &viewer;
}

Result<void> MapSender::State::hear_receipt(std::span<const std::byte> bytes, double now) {
  DELTAMESH_TRY(const ReceiptMessage message, read_receipt(bytes));
  if (message.map_id != encodings.codec().description().id)
    return invalid_argument("a receipt of another map");
  const auto found = viewers.find(message.viewer);
  if (found == viewers.end() || message.number <= found->second.said || message.start != found->second.start)
    return {};
  found->second.said = message.number;
  found->second.heard = now;
  take_receipt(found->second, message.receipt, now);
  return {};
}

}  // namespace deltamesh
