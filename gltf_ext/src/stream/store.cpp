// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/store.h"

#include <algorithm>
#include <utility>

#include "base/checked.h"
#include "base/try.h"
#include "stream/row_hash.h"

namespace deltamesh::gltf {
namespace {

// More than any file of 4 GiB needs, and less than a few bytes of JSON may ask for.
constexpr std::uint64_t kMostOwnedBytes = std::uint64_t{1} << 30;
constexpr std::uint64_t kMostStoredRows = std::uint64_t{1} << 29;

std::uint64_t hash_of(const AccessorRows& rows) noexcept {
  std::uint64_t hash = rows.shape().count;
  for (std::uint64_t i = 0; i < rows.shape().count; ++i) hash = hash_bytes(rows.row(i), hash);
  return hash;
}

bool equal(const AccessorRows& a, const AccessorRows& b) noexcept {
  if (!a.shape().same_rows(b.shape()) || a.shape().count != b.shape().count) return false;
  for (std::uint64_t i = 0; i < a.shape().count; ++i)
    if (!std::ranges::equal(a.row(i), b.row(i))) return false;
  return true;
}

/// Whether an extension holds the data of one of the accessor's buffer views.
bool is_coded(const Json& json, std::size_t accessor) {
  const Json& whole = json["accessors"][accessor];
  const Json* sparse = find(whole, "sparse");
  for (const Json* place :
       {&whole, sparse ? find(*sparse, "indices") : nullptr, sparse ? find(*sparse, "values") : nullptr}) {
    const Json* view = place ? find(*place, "bufferView") : nullptr;
    if (view && json["bufferViews"][view->get<std::size_t>()].contains("extensions")) return true;
  }
  return false;
}

}  // namespace

Result<const AccessorRows*> AccessorStore::read(std::size_t accessor, std::uint64_t zero_rows) {
  const auto [found, is_new] = entries_.try_emplace(accessor);
  Entry& entry = found->second;
  if (is_new || !entry.rows) {
    DELTAMESH_TRY(auto rows, read_accessor(document_, accessor, zero_rows));
    if (!rows || is_coded(document_.json, accessor)) return static_cast<const AccessorRows*>(nullptr);
    if (document_.json["accessors"][accessor].contains("sparse"))
      owned_bytes_ += saturating_mul(rows->shape().count, rows->shape().row_size());
    rows_ = saturating_add(rows_, rows->shape().count);
    if (owned_bytes_ > kMostOwnedBytes || rows_ > kMostStoredRows)
      return Error{.code = ErrorCode::kLimitExceeded,
                   .message = "the accessors stand for too much data",
                   .where_kind = WhereKind::kAccessor,
                   .where = accessor};
    entry.rows = std::move(rows);
    entry.canonical = find_canonical(accessor, *entry.rows);
  }
  return &*std::as_const(entry.rows);
}

std::size_t AccessorStore::find_canonical(std::size_t accessor, const AccessorRows& rows) {
  std::vector<std::size_t>& candidates = by_hash_[hash_of(rows)];
  for (const std::size_t other : candidates)
    if (equal(rows, *entries_.at(other).rows)) return other;
  candidates.push_back(accessor);
  return accessor;
}

}  // namespace deltamesh::gltf
