// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The accessors of an asset's primitives, read once, and which of them hold the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "io/gltf/accessor.h"
#include "io/gltf/document.h"

namespace deltamesh::gltf {

class AccessorStore {
 public:
  /// `document` must outlive the store, and its accessors not change.
  explicit AccessorStore(const Document& document) : document_(document) {}

  const Document& document() const noexcept { return document_; }

  /// As read_accessor(); null for its nothing, and where a buffer view has an extension. The rows stay where
  /// they are as long as the store. Errors: kInvalidFile, kLimitExceeded (2^29 rows in all accessors, 1 GiB
  /// of sparse ones).
  Result<const AccessorRows*> read(std::size_t accessor, std::uint64_t zero_rows = 0);

  /// The first accessor read that has the same shape and rows. Precondition: `accessor` was read, and is not
  /// null.
  std::size_t canonical(std::size_t accessor) const { return entries_.at(accessor).canonical; }
  /// Precondition: as canonical().
  const AccessorRows& rows(std::size_t accessor) const { return *entries_.at(accessor).rows; }

 private:
  struct Entry {
    std::optional<AccessorRows> rows;
    std::size_t canonical = 0;
  };
  std::size_t find_canonical(std::size_t accessor, const AccessorRows& rows);

  const Document& document_;
  std::map<std::size_t, Entry> entries_;
  std::map<std::uint64_t, std::vector<std::size_t>> by_hash_;
  std::uint64_t owned_bytes_ = 0;  ///< of sparse accessors
  std::uint64_t rows_ = 0;         ///< of all
};

}  // namespace deltamesh::gltf
