// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Parts as they were encoded for views, and what receivers make of them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/sender.h"
#include "part_fitness.h"
#include "source_map.h"

namespace deltamesh {

struct Encoding {
  std::vector<std::byte> octets;
  std::uint64_t hash = 0;
  MapPart decoded;
  Quality quality{};
  std::vector<double> attribute_errors{};
  PartErrors errors{};  ///< against the source that was encoded
};

/// A version that was sent, or would be.
struct KnownVersion {
  std::uint64_t content_revision = 0;  ///< of the source that was encoded
  std::vector<PartLink> links{};
  std::shared_ptr<const Encoding> encoding{};
};

class Encodings {
 public:
  Encodings(MapCodec codec, const SenderOptions& options) : codec_(std::move(codec)), options_(options) {}

  const MapCodec& codec() const noexcept { return codec_; }

  /// Of the newest source of a part as the view asks for; encodes where it was not asked for before. Errors:
  /// those of MapCodec::encode().
  Result<std::shared_ptr<const Encoding>> get(const SourcePart& source, const View& view);

  /// Against the newest source, which may be newer than what was encoded.
  PartErrors errors_of(const KnownVersion& version, const SourcePart& source);

  /// Forgets what is not of the newest source.
  void prune(const SourceMap& map);

  std::uint64_t encoded() const noexcept { return encoded_; }

 private:
  struct Asked {
    View view;  ///< its quality alone
    std::uint64_t content_revision = 0;
    std::shared_ptr<const Encoding> encoding{};
  };
  struct Measured {
    std::uint64_t content_revision = 0;  ///< of the source
    std::uint64_t hash = 0;              ///< of the octets
    PartErrors errors{};
  };

  MapCodec codec_;
  SenderOptions options_;
  std::map<PartKey, std::vector<Asked>> asked_;
  std::map<PartKey, std::vector<Measured>> measured_;
  std::uint64_t encoded_ = 0;
};

}  // namespace deltamesh
