// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Pose messages [MAP-23].
#include <cmath>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "message/frame.h"

namespace deltamesh {
namespace {

/// The reason why not, or null.
const char* what_is_wrong(const MapPose& pose) noexcept {
  constexpr double kMostOff = 1e-6;
  double square = 0;
  for (const double x : pose.rotation) square += x * x;
  if (!(std::abs(std::sqrt(square) - 1) <= kMostOff)) return "a rotation that is no unit quaternion";
  for (const double x : pose.translation)
    if (!std::isfinite(x)) return "a translation that is not finite";
  return nullptr;
}

}  // namespace

Result<std::vector<std::byte>> write_pose(const PoseMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    if (const char* wrong = what_is_wrong(message.pose))
      return Error{.code = ErrorCode::kInvalidArgument, .message = wrong, .rule = "MAP-23"};
    ByteWriter out = begin_message(MessageKind::kPose);
    out.write(message.map);
    out.write_varint(message.start);
    out.write_varint(message.number);
    out.write(message.pose.stamp);
    for (const double x : message.pose.rotation) out.write(x);
    for (const double x : message.pose.translation) out.write(x);
    return end_message(std::move(out));
  });
}

Result<PoseMessage> read_pose(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<PoseMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kPose));
    ByteReader in(body);
    PoseMessage told;
    DELTAMESH_TRY(told.map, in.read<std::uint64_t>());
    DELTAMESH_TRY(told.start, in.read_varint());
    DELTAMESH_TRY(told.number, in.read_varint());
    DELTAMESH_TRY(told.pose.stamp, in.read<std::uint64_t>());
    for (double& x : told.pose.rotation) {
      DELTAMESH_TRY(x, in.read<double>());
    }
    for (double& x : told.pose.translation) {
      DELTAMESH_TRY(x, in.read<double>());
    }
    if (const char* wrong = what_is_wrong(told.pose))
      return in.error(ErrorCode::kInvalidStream, wrong, "MAP-23");
    DELTAMESH_CHECK(in.finish());
    return told;
  });
}

}  // namespace deltamesh
