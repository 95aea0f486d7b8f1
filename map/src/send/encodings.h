// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Parts as they were encoded for views, and what receivers make of them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "deltamesh/color_content.h"
#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/sender.h"
#include "part/fitness.h"
#include "patch/match.h"
#include "send/source_map.h"

namespace deltamesh {

struct Encoding {
  std::vector<std::byte> octets;
  std::uint64_t hash = 0;
  MapPart decoded;
  Quality quality{};
  std::vector<double> attribute_errors{};
  PartErrors errors{};             ///< against the source that was encoded
  std::vector<float> sources{};    ///< of every decoded vertex the position in that source, n x 3
  std::vector<std::byte> patch{};  ///< the octets without those of the base; empty: there is none
  PartKey base_key{};
  std::uint64_t base_hash = 0;  ///< of the base's octets
  double whole_rate = 0;        ///< bytes per triangle of the part without patches
  bool is_grid = false;         ///< as DecodedPart::is_grid: newer versions are coded beside it
};

/// A version that was sent, or would be.
struct KnownVersion {
  std::uint64_t content_revision = 0;  ///< of the source that was encoded
  std::vector<PartLink> links{};
  std::shared_ptr<const Encoding> encoding{};
};

class Encodings {
 public:
  /// `colors`: of the source; must outlive this.
  Encodings(MapCodec codec, const SenderOptions& options, const ColorContent& colors)
      : codec_(std::move(codec)), options_(options), colors_(&colors) {}

  const MapCodec& codec() const noexcept { return codec_; }

  /// What viewers ask for now: when a part is encoded, what was made of it for others is forgotten.
  void set_views(std::vector<View> views) { views_ = std::move(views); }

  /// The encoding of a part's newest source that the view asks for, or else the best that can be had; null if
  /// there is none. Encodes on the first request. Errors: kOutOfMemory, kInternal.
  Result<std::shared_ptr<const Encoding>> get(const SourcePart& source, const View& view);

  /// What is wrong with the encoding that get() gave; null: nothing, or it has not been asked for.
  const Error* fault(const SourcePart& source, const View& view) const;

  /// The newest source as a patch of version `base`; null if a patch does not pay or cannot be had. Errors:
  /// kOutOfMemory, kInternal.
  Result<std::shared_ptr<const Encoding>> patch(const SourcePart& source, const View& view,
                                                const KnownVersion& base);

  /// Whether a version meets the view's bounds for the newest source, which may be newer.
  bool fits(const KnownVersion& version, const SourcePart& source, const View& view);

  /// Of a part that is gone.
  void forget(const PartKey& key);

  std::uint64_t encoded() const noexcept { return encoded_; }

 private:
  struct Asked {
    View view;  ///< its quality alone
    std::uint64_t content_revision = 0;
    std::uint64_t base_hash = 0;                 ///< 0: not as a patch
    std::shared_ptr<const Encoding> encoding{};  ///< null: a patch is not worth it, or there is none
    std::optional<Error> fault{};                ///< why it is not as the view asks
  };
  struct Matched {
    View view;                           ///< its quality alone
    std::uint64_t content_revision = 0;  ///< of the source
    std::uint64_t hash = 0;              ///< of the version's octets
    std::shared_ptr<const PartMatch> match{};
  };

  bool is_asked(const View& quality, const SourcePart& source) const;
  std::vector<Asked>& asked_of(const SourcePart& source);
  const Asked* find(const SourcePart& source, const View& view) const;
  Result<std::shared_ptr<const Encoding>> make(const SourcePart& source, const View& quality) const;
  Result<std::shared_ptr<const Encoding>> make_patch(const SourcePart& source, const View& quality,
                                                     const Encoding& base);
  std::shared_ptr<const PartMatch> match(const SourcePart& source, const View& quality, const Encoding& base);

  MapCodec codec_;
  SenderOptions options_;
  const ColorContent* colors_;
  std::vector<View> views_{};
  std::map<PartKey, std::vector<Asked>> asked_;
  std::map<PartKey, std::vector<Matched>> matched_;
  std::uint64_t encoded_ = 0;
};

}  // namespace deltamesh
