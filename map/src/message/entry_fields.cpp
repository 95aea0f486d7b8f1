// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "message/entry_fields.h"

#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers/zigzag.h"
#include "deltamesh/map/part.h"
#include "support/errors.h"
#include "support/limits.h"

namespace deltamesh {
namespace {

constexpr std::uint8_t kFarPlace = 27;  // [MAP-12]

constexpr std::uint64_t kMostUnsigned = std::numeric_limits<std::uint32_t>::max();

/// Of the 27 cells of the same level around and at `key`; kFarPlace where `other` is none of them.
std::uint8_t place_of(const PartKey& key, const PartKey& other) noexcept {
  if (other.level != key.level) return kFarPlace;
  const std::array<std::int64_t, 3> way{std::int64_t{other.x} - key.x, std::int64_t{other.y} - key.y,
                                        std::int64_t{other.z} - key.z};
  if (std::ranges::any_of(way, [](std::int64_t d) { return d < -1 || d > 1; })) return kFarPlace;
  return static_cast<std::uint8_t>((way[0] + 1) + 3 * (way[1] + 1) + 9 * (way[2] + 1));
}

Result<std::int32_t> moved(std::int32_t from, int by, const ByteReader& in) {
  const std::int64_t to = std::int64_t{from} + by;
  if (to < std::numeric_limits<std::int32_t>::min() || to > std::numeric_limits<std::int32_t>::max())
    return in.error(ErrorCode::kInvalidStream, "a part beyond the last cell", "MAP-12");
  return static_cast<std::int32_t>(to);
}

Result<PartKey> read_place(ByteReader& in, const PartKey& key, std::uint8_t place) {
  if (place == kFarPlace) return read_key(in);
  if (place > kFarPlace) return in.error(ErrorCode::kInvalidStream, "no such place of a neighbour", "MAP-12");
  PartKey other{.level = key.level};
  DELTAMESH_TRY(other.x, moved(key.x, place % 3 - 1, in));
  DELTAMESH_TRY(other.y, moved(key.y, place / 3 % 3 - 1, in));
  DELTAMESH_TRY(other.z, moved(key.z, place / 9 - 1, in));
  return other;
}

bool ascends(const std::vector<PartLink>& links) noexcept {
  return std::ranges::adjacent_find(
             links, [](const PartLink& a, const PartLink& b) { return a.key >= b.key; }) == links.end();
}

/// The least float32 that is not below `value`.
float rounded_up(double value) noexcept {
  const auto nearest = static_cast<float>(value);
  return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

bool is_error(double value) noexcept { return value >= 0 && value <= std::numeric_limits<float>::max(); }

}  // namespace

bool PartEntry::operator==(const PartEntry& other) const noexcept {
  return key == other.key && revision == other.revision && group == other.group && bytes == other.bytes &&
         links == other.links && hash == other.hash && vertices == other.vertices &&
         triangles == other.triangles && box_min == other.box_min && box_max == other.box_max &&
         quality.vde_rms == other.quality.vde_rms && quality.lfe_rms == other.quality.lfe_rms &&
         quality.max_error == other.quality.max_error && attribute_errors == other.attribute_errors;
}

std::uint32_t version_hash(std::uint64_t octets_hash, const std::vector<PartLink>& links) {
  ByteWriter out;
  out.write(octets_hash);
  for (const PartLink& link : links) {
    if (link.border == 0) continue;
    write_key(out, link.key);
    out.write(link.border);
  }
  return static_cast<std::uint32_t>(XXH3_64bits(out.bytes().data(), out.size()));
}

void write_key(ByteWriter& out, const PartKey& key) {
  out.write(key.level);
  for (const std::int32_t x : {key.x, key.y, key.z}) out.write_varint(zigzag(x));
}

Result<PartKey> read_key(ByteReader& in) {
  PartKey key;
  DELTAMESH_TRY(key.level, in.read<std::uint8_t>());
  if (key.level > kMostPartLevel)
    return in.error(ErrorCode::kInvalidStream, "a level of parts above 24", "MAP-3");
  for (std::int32_t* x : {&key.x, &key.y, &key.z}) {
    DELTAMESH_TRY(const auto code, in.read_varint(kMostUnsigned));
    *x = unzigzag(static_cast<std::uint32_t>(code));
  }
  return key;
}

Result<void> check_links(const PartKey& key, const std::vector<PartLink>& links) noexcept {
  if (key.level > kMostPartLevel) return invalid_argument("a level of parts above 24", "MAP-3");
  if (links.size() > kMostLinks) return invalid_argument("a part with too many neighbours", "MAP-12");
  if (!ascends(links)) return invalid_argument("links that do not ascend", "MAP-12");
  for (const PartLink& link : links)
    if (link.key == key || link.key.level > kMostPartLevel)
      return invalid_argument("a link to the part itself, or to no part", "MAP-12");
  return {};
}

std::uint64_t hash_of_shown(std::span<const std::pair<PartKey, std::uint64_t>> parts) {
  ByteWriter out;
  for (const auto& [key, hash] : parts) {
    write_key(out, key);
    out.write(hash);
  }
  return XXH3_64bits(out.bytes().data(), out.size());
}

void write_neighbor(ByteWriter& out, const PartKey& key, const Neighbor& neighbor) {
  const std::uint8_t place = place_of(key, neighbor.key);
  out.write(static_cast<std::uint8_t>(place | neighbor.flags));
  if (place == kFarPlace) write_key(out, neighbor.key);
}

Result<Neighbor> read_neighbor(ByteReader& in, const PartKey& key) {
  DELTAMESH_TRY(const auto code, in.read<std::uint8_t>());
  Neighbor neighbor{.flags = static_cast<std::uint8_t>(code & (kTogetherFlag | kLeastFlag))};
  DELTAMESH_TRY(neighbor.key, read_place(in, key, static_cast<std::uint8_t>(code - neighbor.flags)));
  return neighbor;
}

void write_links(ByteWriter& out, const PartKey& key, std::uint64_t revision,
                 const std::vector<PartLink>& links) {
  out.write_varint(links.size());
  for (const PartLink& link : links) {
    const int flags = (link.together ? kTogetherFlag : 0) | (link.least != 0 ? kLeastFlag : 0);
    write_neighbor(out, key, {link.key, static_cast<std::uint8_t>(flags)});
    out.write(link.border);
    if (link.least != 0) out.write_varint(zigzag(static_cast<std::int64_t>(revision - link.least)));
  }
}

Result<std::vector<PartLink>> read_links(ByteReader& in, const PartKey& key, std::uint64_t revision) {
  DELTAMESH_TRY(const auto count, in.read_varint(kMostLinks));
  std::vector<PartLink> links;
  for (std::uint64_t i = 0; i < count; ++i) {
    DELTAMESH_TRY(const Neighbor neighbor, read_neighbor(in, key));
    PartLink link{.key = neighbor.key, .together = (neighbor.flags & kTogetherFlag) != 0};
    DELTAMESH_TRY(link.border, in.read<std::uint32_t>());
    if ((neighbor.flags & kLeastFlag) != 0) {
      DELTAMESH_TRY(const auto behind, in.read_varint());
      link.least = revision - static_cast<std::uint64_t>(unzigzag(behind));
      if (link.least == 0) return in.error(ErrorCode::kInvalidStream, "a least revision of 0", "MAP-12");
    }
    links.push_back(link);
  }
  if (auto valid = check_links(key, links); !valid)
    return in.error(ErrorCode::kInvalidStream, valid.error().message, valid.error().rule);
  return links;
}

Result<void> check_entry(const PartEntry& entry) noexcept {
  DELTAMESH_CHECK(check_links(entry.key, entry.links));
  if (entry.bytes == 0) return {};
  if (entry.bytes > kMostPartBytes) return invalid_argument("a part of more than 65536 bytes", "MAP-7");
  for (std::size_t k = 0; k < 3; ++k)
    if (!std::isfinite(entry.box_min[k]) || !std::isfinite(entry.box_max[k]) ||
        entry.box_min[k] > entry.box_max[k])
      return invalid_argument("a box that is none", "MAP-13");
  for (const double error : {entry.quality.vde_rms, entry.quality.lfe_rms, entry.quality.max_error})
    if (!is_error(error)) return invalid_argument("an error that is negative or not finite", "MAP-13");
  if (!std::ranges::all_of(entry.attribute_errors, [](float error) { return is_error(error); }))
    return invalid_argument("an error that is negative or not finite", "MAP-13");
  return {};
}

void write_entry_fields(ByteWriter& out, const PartEntry& entry) {
  write_key(out, entry.key);
  out.write_varint(entry.revision);
  out.write_varint(entry.group);
  write_links(out, entry.key, entry.revision, entry.links);
  out.write_varint(entry.bytes);
  if (entry.bytes == 0) return;
  out.write(entry.hash);
  out.write_varint(entry.vertices);
  out.write_varint(entry.triangles);
  for (const float x : entry.box_min) out.write(x);
  for (const float x : entry.box_max) out.write(x);
  for (const double error : {entry.quality.vde_rms, entry.quality.lfe_rms, entry.quality.max_error})
    out.write(rounded_up(error));
  for (const float error : entry.attribute_errors) out.write(error);
}

Result<PartEntry> read_entry_fields(ByteReader& in, std::size_t attributes) {
  PartEntry entry;
  DELTAMESH_TRY(entry.key, read_key(in));
  DELTAMESH_TRY(entry.revision, in.read_varint());
  DELTAMESH_TRY(entry.group, in.read_varint());
  DELTAMESH_TRY(entry.links, read_links(in, entry.key, entry.revision));
  DELTAMESH_TRY(const auto bytes, in.read_varint(kMostPartBytes));
  entry.bytes = static_cast<std::uint32_t>(bytes);
  if (entry.bytes == 0) return entry;
  DELTAMESH_TRY(entry.hash, in.read<std::uint64_t>());
  for (std::uint32_t* count : {&entry.vertices, &entry.triangles}) {
    DELTAMESH_TRY(const auto number, in.read_varint(kMostUnsigned));
    *count = static_cast<std::uint32_t>(number);
  }
  for (auto* corner : {&entry.box_min, &entry.box_max})
    for (float& x : *corner) {
      DELTAMESH_TRY(x, in.read<float>());
    }
  for (double* error : {&entry.quality.vde_rms, &entry.quality.lfe_rms, &entry.quality.max_error}) {
    DELTAMESH_TRY(const auto value, in.read<float>());
    *error = value;
  }
  for (std::size_t i = 0; i < attributes; ++i) {
    DELTAMESH_TRY(const auto error, in.read<float>());
    entry.attribute_errors.push_back(error);
  }
  if (auto valid = check_entry(entry); !valid)
    return in.error(ErrorCode::kInvalidStream, valid.error().message, valid.error().rule);
  return entry;
}

}  // namespace deltamesh
