// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Messages between the sender and the receivers of a map, as plain bytes for any transport. The map's own
// message is in description.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deltamesh/map/part_entry.h"
#include "deltamesh/map/pose.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Says that a sender was started [MAP-16]. From then on its receivers take no messages of earlier ones.
struct StartMessage {
  std::uint64_t map = 0;     ///< hash_of() the map's description
  std::uint64_t start = 0;   ///< the map's revision at that time
  std::uint64_t number = 0;  ///< 0, or as EntryMessage::number after the last message
};

/// Tells that there is a version of a part, or that a part is gone [MAP-13].
struct EntryMessage {
  std::uint64_t map = 0;     ///< hash_of() the map's description
  std::uint64_t start = 0;   ///< as StartMessage::start
  std::uint64_t number = 0;  ///< of the messages to a receiver, which are counted from 1; 0: not counted
  PartEntry entry{};
};

/// A version of a part [MAP-14].
struct PartMessage {
  std::uint64_t map = 0;     ///< hash_of() the map's description
  std::uint64_t start = 0;   ///< as StartMessage::start
  std::uint64_t number = 0;  ///< as EntryMessage::number
  PartKey key{};
  std::uint64_t revision = 0;
  std::uint64_t group = 0;
  std::vector<PartLink> links{};    ///< as PartEntry::links
  std::vector<std::byte> octets{};  ///< as MapCodec::decode() takes them; 1 to kMostPartBytes
};

/// A version of a part as a patch of an earlier one, or of a part in whose place it comes [MAP-17].
struct PatchMessage {
  PartMessage part{};  ///< without octets
  PartKey base_key{};  ///< of the part that the base is a version of
  /// What makes octets of the base's, which its checksum tells [MAP-17]; 1 to kMostPartBytes.
  std::vector<std::byte> body{};
};

/// Says that a receiver does not get a part as it asked [MAP-22].
struct FaultMessage {
  std::uint64_t map = 0;     ///< hash_of() the map's description
  std::uint64_t start = 0;   ///< as StartMessage::start
  std::uint64_t number = 0;  ///< as EntryMessage::number
  PartKey key{};
  /// kUnmetRequest: it is sent as well as can be; others: it is not sent; 0: nothing is wrong any more.
  std::uint16_t code = 0;
};

/// Says where the map is [MAP-23].
struct PoseMessage {
  std::uint64_t map = 0;     ///< hash_of() the map's description
  std::uint64_t start = 0;   ///< as StartMessage::start
  std::uint64_t number = 0;  ///< as EntryMessage::number; a later one replaces earlier ones
  MapPose pose{};
};

/// Relative to the map's origin; model units.
struct ViewBox {
  std::array<float, 3> low{};
  std::array<float, 3> high{};

  bool operator==(const ViewBox&) const = default;
};

/// A receiver's request. Errors are in model units; VDE and LFE are root mean squares over each part.
struct View {
  std::vector<ViewBox> boxes{};  ///< at most kMostViewBoxes; none: the whole map
  std::uint8_t level = 0;        ///< no parts of lower levels
  std::optional<float> vde{};    ///< above 0
  std::optional<float> lfe{};
  std::optional<float> max_error{};
  /// Of colours, 255ths: the largest error of a component, 0 for exact, or the root mean square over a part
  /// of the errors of red, green and blue, above 0. Not both. Neither: the sender's choice, which is
  /// kPhotographicRms for photographs, else exact (MapSender).
  std::optional<float> color_error{};
  std::optional<float> color_rms{};
  /// Of the map's attributes, in their order; 0: exact. Normals and tangents in degrees, texture coordinates,
  /// weights, and generic ones (labels, intensities) in their unit. Colours and joints: 0. Where this ends:
  /// 0.5 degrees, 1/4096, 1/1024 and 0.
  std::vector<float> attribute_errors{};
  std::uint32_t bytes_per_second = 0;  ///< 0: no limit

  bool operator==(const View&) const = default;
};
inline constexpr std::size_t kMostViewBoxes = 64;    // [MAP-15]
inline constexpr std::size_t kMostViewErrors = 255;  // [MAP-15]

/// A version that a receiver has.
struct HeldVersion {
  PartKey key{};
  std::uint64_t revision = 0;
  std::uint32_t version = 0;  ///< version_hash()
  bool is_waiting = false;    ///< it, or its removal, waits for what it is shown with

  bool operator==(const HeldVersion&) const = default;
};

/// Which messages of a start a receiver has got, by their numbers [MAP-21].
struct Receipt {
  std::uint64_t highest = 0;             ///< 0: none
  std::vector<std::uint64_t> missing{};  ///< of the kReceiptNumbers numbers before; ascending, above 0

  bool operator==(const Receipt&) const = default;
};
inline constexpr std::uint64_t kReceiptNumbers = 256;  // [MAP-21]

/// A receiver's short message to the sender: what has come and what has not [MAP-21].
struct ReceiptMessage {
  std::uint64_t viewer = 0;  ///< as ViewMessage::viewer
  std::uint64_t number = 0;  ///< counted along with those of views
  std::uint64_t map_id = 0;
  std::uint64_t start = 0;  ///< as ViewMessage::start
  Receipt receipt{};

  bool operator==(const ReceiptMessage&) const = default;
};

/// A receiver's message to the sender [MAP-15].
struct ViewMessage {
  std::uint64_t viewer = 0;  ///< chosen by the receiver; another one after a restart
  std::uint64_t number = 0;  ///< ascending; older messages of a viewer are ignored
  std::uint64_t map_id = 0;
  std::uint64_t map = 0;    ///< hash of the description that the receiver has; 0: none
  std::uint32_t epoch = 0;  ///< of that description
  std::uint64_t start = 0;  ///< of the sender that the receiver takes messages of; 0: of none yet
  Receipt receipt{};
  View view{};
  std::vector<HeldVersion> held{};  ///< ascending by key

  bool operator==(const ViewMessage&) const = default;
};

/// Errors: kInvalidArgument (out of range), kOutOfMemory.
Result<std::vector<std::byte>> write_start(const StartMessage& message) noexcept;
Result<std::vector<std::byte>> write_entry(const EntryMessage& message) noexcept;
Result<std::vector<std::byte>> write_part(const PartMessage& message) noexcept;
Result<std::vector<std::byte>> write_patch(const PatchMessage& message) noexcept;
Result<std::vector<std::byte>> write_fault(const FaultMessage& message) noexcept;
Result<std::vector<std::byte>> write_pose(const PoseMessage& message) noexcept;
Result<std::vector<std::byte>> write_view(const ViewMessage& message) noexcept;
Result<std::vector<std::byte>> write_receipt(const ReceiptMessage& message) noexcept;

/// `attributes`: how many the map has. Errors of all: 1xx codes [MAP-1, MAP-12 to MAP-17, MAP-21 to MAP-23],
/// kOutOfMemory. Takes memory in proportion to the bytes.
Result<StartMessage> read_start(std::span<const std::byte> message) noexcept;
Result<EntryMessage> read_entry(std::span<const std::byte> message, std::size_t attributes) noexcept;
Result<PartMessage> read_part(std::span<const std::byte> message) noexcept;
Result<PatchMessage> read_patch(std::span<const std::byte> message) noexcept;
Result<FaultMessage> read_fault(std::span<const std::byte> message) noexcept;
Result<PoseMessage> read_pose(std::span<const std::byte> message) noexcept;
Result<ViewMessage> read_view(std::span<const std::byte> message) noexcept;
Result<ReceiptMessage> read_receipt(std::span<const std::byte> message) noexcept;

}  // namespace deltamesh
