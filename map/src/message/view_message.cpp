// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// View messages [MAP-15].
#include <algorithm>
#include <cmath>

#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "message/entry_fields.h"
#include "message/frame.h"
#include "message/receipt.h"

namespace deltamesh {
namespace {

/// What a view asks of colours.
enum class ColorBound : std::uint8_t { kNone, kLargest, kMean };

bool is_bound(const std::optional<float>& bound) noexcept {
  return !bound || (std::isfinite(*bound) && *bound > 0);
}

bool is_box(const ViewBox& box) noexcept {
  for (std::size_t k = 0; k < 3; ++k)
    if (!std::isfinite(box.low[k]) || !std::isfinite(box.high[k]) || box.low[k] > box.high[k]) return false;
  return true;
}

/// The reason why not, or null.
const char* what_is_wrong(const ViewMessage& message) noexcept {
  const View& view = message.view;
  if (const char* wrong = what_is_wrong(message.receipt)) return wrong;
  if (view.boxes.size() > kMostViewBoxes) return "a view of more than 64 boxes";
  if (!std::ranges::all_of(view.boxes, is_box)) return "a box that is none";
  if (view.level > kMostPartLevel) return "a level of parts above 24";
  if (!is_bound(view.vde) || !is_bound(view.lfe) || !is_bound(view.max_error))
    return "an error asked for is negative or not finite";
  if (view.color_error && view.color_rms) return "a largest and a mean error of colours";
  if (!is_bound(view.color_rms) ||
      (view.color_error && (!std::isfinite(*view.color_error) || *view.color_error < 0)))
    return "an error asked for is negative or not finite";
  if (view.attribute_errors.size() > kMostViewErrors) return "errors of more than 255 attributes";
  if (std::ranges::any_of(view.attribute_errors, [](float e) { return !std::isfinite(e) || e < 0; }))
    return "an error asked for is negative or not finite";
  const auto out_of_order = [](const HeldVersion& a, const HeldVersion& b) { return a.key >= b.key; };
  if (std::ranges::adjacent_find(message.held, out_of_order) != message.held.end())
    return "parts that do not ascend";
  if (std::ranges::any_of(message.held, [](const HeldVersion& h) { return h.key.level > kMostPartLevel; }))
    return "a level of parts above 24";
  return nullptr;
}

void write_view_fields(ByteWriter& out, const View& view) {
  out.write(static_cast<std::uint8_t>(view.boxes.size()));
  for (const ViewBox& box : view.boxes) {
    for (const float x : box.low) out.write(x);
    for (const float x : box.high) out.write(x);
  }
  out.write(view.level);
  for (const auto& bound : {view.vde, view.lfe, view.max_error}) out.write(bound.value_or(0.0F));
  const auto colors = view.color_rms     ? ColorBound::kMean
                      : view.color_error ? ColorBound::kLargest
                                         : ColorBound::kNone;
  out.write(static_cast<std::uint8_t>(colors));
  if (colors != ColorBound::kNone) out.write(view.color_rms ? *view.color_rms : *view.color_error);
  out.write(static_cast<std::uint8_t>(view.attribute_errors.size()));
  for (const float error : view.attribute_errors) out.write(error);
  out.write_varint(view.bytes_per_second);
}

Result<View> read_view_fields(ByteReader& in) {
  View view;
  DELTAMESH_TRY(const auto boxes, in.read<std::uint8_t>());
  for (unsigned i = 0; i < boxes; ++i) {
    ViewBox& box = view.boxes.emplace_back();
    for (auto* corner : {&box.low, &box.high})
      for (float& x : *corner) {
        DELTAMESH_TRY(x, in.read<float>());
      }
  }
  DELTAMESH_TRY(view.level, in.read<std::uint8_t>());
  for (auto* bound : {&view.vde, &view.lfe, &view.max_error}) {
    DELTAMESH_TRY(const auto value, in.read<float>());
    if (value != 0) *bound = value;
  }
  DELTAMESH_TRY(const auto colors, in.read<std::uint8_t>());
  if (colors > static_cast<std::uint8_t>(ColorBound::kMean))
    return in.error(ErrorCode::kInvalidStream, "a bound on colours that is unknown", "MAP-15");
  if (colors == static_cast<std::uint8_t>(ColorBound::kLargest)) {
    DELTAMESH_TRY(view.color_error, in.read<float>());
  } else if (colors == static_cast<std::uint8_t>(ColorBound::kMean)) {
    DELTAMESH_TRY(view.color_rms, in.read<float>());
  }
  DELTAMESH_TRY(const auto errors, in.read<std::uint8_t>());
  for (unsigned i = 0; i < errors; ++i) {
    DELTAMESH_TRY(view.attribute_errors.emplace_back(), in.read<float>());
  }
  DELTAMESH_TRY(const auto rate, in.read_varint(0xffffffffU));
  view.bytes_per_second = static_cast<std::uint32_t>(rate);
  return view;
}

Result<ViewMessage> read_view_body(ByteReader in) {
  ViewMessage message;
  DELTAMESH_TRY(message.viewer, in.read<std::uint64_t>());
  DELTAMESH_TRY(message.number, in.read_varint());
  DELTAMESH_TRY(message.map_id, in.read<std::uint64_t>());
  DELTAMESH_TRY(message.map, in.read<std::uint64_t>());
  DELTAMESH_TRY(message.epoch, in.read<std::uint32_t>());
  DELTAMESH_TRY(message.start, in.read_varint());
  DELTAMESH_TRY(message.receipt, read_receipt_fields(in));
  DELTAMESH_TRY(message.view, read_view_fields(in));
  while (in.remaining() != 0) {
    HeldVersion held;
    DELTAMESH_TRY(const auto waiting, in.read<std::uint8_t>());
    if (waiting > 1) return in.error(ErrorCode::kInvalidStream, "a flag that is not 0 or 1", "MAP-15");
    held.is_waiting = waiting == 1;
    DELTAMESH_TRY(held.key, read_key(in));
    DELTAMESH_TRY(held.revision, in.read_varint());
    DELTAMESH_TRY(held.version, in.read<std::uint32_t>());
    message.held.push_back(held);
  }
  if (const char* wrong = what_is_wrong(message)) return in.error(ErrorCode::kInvalidStream, wrong, "MAP-15");
  return message;
}

}  // namespace

Result<std::vector<std::byte>> write_view(const ViewMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    if (const char* wrong = what_is_wrong(message))
      return Error{.code = ErrorCode::kInvalidArgument, .message = wrong, .rule = "MAP-15"};
    ByteWriter out = begin_message(MessageKind::kView);
    out.write(message.viewer);
    out.write_varint(message.number);
    out.write(message.map_id);
    out.write(message.map);
    out.write(message.epoch);
    out.write_varint(message.start);
    write_receipt_fields(out, message.receipt);
    write_view_fields(out, message.view);
    for (const HeldVersion& held : message.held) {
      out.write(static_cast<std::uint8_t>(held.is_waiting ? 1 : 0));
      write_key(out, held.key);
      out.write_varint(held.revision);
      out.write(held.version);
    }
    return end_message(std::move(out));
  });
}

Result<ViewMessage> read_view(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<ViewMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kView));
    return read_view_body(ByteReader(body));
  });
}

}  // namespace deltamesh
