// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "send/encodings.h"

#include <xxhash.h>

#include <algorithm>
#include <cmath>

#include "base/try.h"
#include "part/encode.h"
#include "part/view_cells.h"
#include "part/view_quality.h"
#include "patch/container.h"
#include "patch/encode.h"

namespace deltamesh {
namespace {

/// A patch with a larger share of new faces, or of the bytes of the whole, is not worth it. Below 1: a patch
/// is of something.
constexpr double kMostNewFaces = 0.97;
constexpr double kWorthPatch = 0.97;

/// A copy that is seen before what the view asks for need not be much better than its simplification: the
/// largest error of a cell's edge, and that of colours in 255ths. Larger errors cost more at border vertices,
/// which are on the lattice all the same, than they save elsewhere.
constexpr double kFirstSight = 1.0 / 1024;
constexpr float kFirstSightColor = 8;
constexpr float kFirstSightRms = 4.5F;

/// What the view asks of colours, or what is chosen where it asks nothing.
void set_colors(const View& view, const ColorContent& content, View& quality) {
  quality.color_error = view.color_error;
  quality.color_rms = view.color_rms;
  if (view.color_error || view.color_rms) return;
  if (content.is_photographic())
    quality.color_rms = static_cast<float>(kPhotographicRms);
  else
    quality.color_error = 0.0F;
}

/// The view's quality for a part, without places and rate.
View quality_of(const View& view, const SourcePart& source, const MapDescription& description,
                const ColorContent& content) {
  View quality;
  quality.vde = view.vde;
  quality.lfe = view.lfe;
  quality.max_error = view.max_error;
  set_colors(view, content, quality);
  quality.attribute_errors = view.attribute_errors;
  if (!source.is_copy || source.part.key.level <= view.level) return quality;
  quality.vde = quality.lfe = {};
  const double edge = cube_of(source.part.key, description).edge;
  quality.max_error = std::max(view.max_error.value_or(0), static_cast<float>(kFirstSight * edge));
  if (quality.color_rms) quality.color_rms = std::max(*quality.color_rms, kFirstSightRms);
  if (view.color_error) quality.color_error = std::max(*view.color_error, kFirstSightColor);
  return quality;
}

PartQuality asked_quality(const View& view, const MapDescription& description, const SenderOptions& options) {
  PartQuality quality = part_quality(view, description);
  quality.effort = options.effort;
  quality.geometry = options.geometry;
  return quality;
}

PartErrors errors_of_coded(const CodedPart& coded, const MapDescription& description) {
  PartErrors errors{.vde = coded.quality.vde_rms,
                    .lfe = coded.quality.lfe_rms,
                    .max_error = coded.quality.max_error,
                    .color_rms = coded.color_rms};
  for (std::size_t i = 0; i < coded.attribute_errors.size(); ++i)
    if (description.attributes[i].kind == AttributeKind::kColor)
      errors.color_error = std::max(errors.color_error, coded.attribute_errors[i]);
  return errors;
}

/// Without what is said of patches.
Encoding encoding_of(DecodedPart part, const MapPart& source, const MapDescription& description) {
  Encoding encoding;
  encoding.errors = errors_of_coded(part.coded, description);
  encoding.octets = std::move(part.coded.bytes);
  encoding.hash = XXH3_64bits(encoding.octets.data(), encoding.octets.size());
  encoding.decoded = std::move(part.part);
  encoding.is_grid = part.is_grid;
  encoding.quality = part.coded.quality;
  encoding.attribute_errors = std::move(part.coded.attribute_errors);
  encoding.sources.reserve(3 * part.order.size());
  for (const std::uint32_t v : part.order) {
    const auto position = source.mesh.positions.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{v});
    encoding.sources.insert(encoding.sources.end(), position, position + 3);
  }
  return encoding;
}

/// The smallest largest error that may be asked for [MAP-8].
float finest_error(const MapLattice& lattice) {
  return std::nextafter(static_cast<float>(std::sqrt(3.0) / 2 * lattice.step()), 1e30F);
}

/// Not of the part: other parts fail as well.
bool is_ours(const Error& error) noexcept {
  return error.code == ErrorCode::kOutOfMemory || error.code == ErrorCode::kInternal;
}

/// What the part would take if it were no primer.
double whole_bytes(const Encoding& encoding, const MapDescription& description) {
  const auto primer = primer_of(encoding.octets);
  return static_cast<double>(primer ? description.primers.at(*primer).stream.size() : encoding.octets.size());
}

}  // namespace

bool Encodings::is_asked(const View& quality, const SourcePart& source) const {
  return std::ranges::any_of(views_, [&](const View& view) {
    return quality_of(view, source, codec_.description(), *colors_) == quality;
  });
}

std::vector<Encodings::Asked>& Encodings::asked_of(const SourcePart& source) {
  std::vector<Asked>& asked = asked_[source.part.key];
  std::erase_if(asked, [&](const Asked& a) {
    return a.content_revision != source.content_revision || !is_asked(a.view, source);
  });
  return asked;
}

const Encodings::Asked* Encodings::find(const SourcePart& source, const View& view) const {
  const auto asked = asked_.find(source.part.key);
  if (asked == asked_.end()) return nullptr;
  const View quality = quality_of(view, source, codec_.description(), *colors_);
  const auto found = std::ranges::find_if(asked->second, [&](const Asked& a) {
    return a.content_revision == source.content_revision && a.view == quality && a.base_hash == 0;
  });
  return found == asked->second.end() ? nullptr : &*found;
}

const Error* Encodings::fault(const SourcePart& source, const View& view) const {
  const Asked* asked = find(source, view);
  return asked != nullptr && asked->fault ? &*asked->fault : nullptr;
}

Result<std::shared_ptr<const Encoding>> Encodings::make(const SourcePart& source, const View& quality) const {
  DELTAMESH_TRY(DecodedPart part, encode_part(codec_.state(), source.part,
                                              asked_quality(quality, codec_.description(), options_)));
  auto encoding = std::make_shared<Encoding>(encoding_of(std::move(part), source.part, codec_.description()));
  encoding->whole_rate =
      whole_bytes(*encoding, codec_.description()) / static_cast<double>(source.part.mesh.triangle_count());
  return std::shared_ptr<const Encoding>(std::move(encoding));
}

Result<std::shared_ptr<const Encoding>> Encodings::get(const SourcePart& source, const View& view) {
  if (const Asked* asked = find(source, view); asked != nullptr) return asked->encoding;
  Asked asked{quality_of(view, source, codec_.description(), *colors_), source.content_revision, 0};
  auto made = make(source, asked.view);
  if (!made && is_ours(made.error())) return made.error();
  if (!made) asked.fault = made.error();
  if (!made && made.error().code == ErrorCode::kUnmetRequest) {
    View finest;
    finest.max_error = finest_error(codec_.description().lattice);
    finest.color_error = asked.view.color_error;
    finest.color_rms = asked.view.color_rms;
    finest.attribute_errors = asked.view.attribute_errors;
    made = make(source, finest);
    if (!made && is_ours(made.error())) return made.error();
    if (!made) asked.fault = made.error();
  }
  if (made) asked.encoding = *std::move(made);
  ++encoded_;
  asked_of(source).push_back(asked);
  return asked.encoding;
}

Result<std::shared_ptr<const Encoding>> Encodings::patch(const SourcePart& source, const View& view,
                                                         const KnownVersion& base) {
  const View quality = quality_of(view, source, codec_.description(), *colors_);
  std::vector<Asked>& asked = asked_of(source);
  for (const Asked& a : asked)
    if (a.view == quality && a.base_hash == base.encoding->hash) return a.encoding;
  DELTAMESH_TRY(auto encoding, make_patch(source, quality, *base.encoding));
  asked.push_back({quality, source.content_revision, base.encoding->hash, encoding});
  return encoding;
}

Result<std::shared_ptr<const Encoding>> Encodings::make_patch(const SourcePart& source, const View& quality,
                                                              const Encoding& base) {
  std::shared_ptr<const Encoding> none;
  if (!quality.max_error || count_patches(base.octets) >= kMostPatches) return none;
  const PartQuality asked = asked_quality(quality, codec_.description(), options_);
  std::optional<DecodedPart> part;
  if (base.is_grid) {
    auto made = encode_beside(codec_.state(), source.part, base.decoded, base.hash, asked);
    ++encoded_;
    if (!made && is_ours(made.error())) return made.error();
    if (made) part = *std::move(made);
  }
  const auto triangles = static_cast<double>(source.part.mesh.triangle_count());
  if (!part) {
    const auto matched = match(source, quality, base);
    if (static_cast<double>(matched->new_faces.size()) > kMostNewFaces * triangles) return none;
    auto made =
        encode_patch(codec_.state(), source.part, {base.decoded, base.sources}, base.hash, *matched, asked);
    ++encoded_;
    if (!made && is_ours(made.error())) return made.error();
    if (made) part = *std::move(made);
  }
  if (!part || static_cast<double>(part->coded.bytes.size()) > kWorthPatch * base.whole_rate * triangles)
    return none;
  std::vector<std::byte> patch = std::move(part->coded.bytes);
  part->coded.bytes = join_patched({base.decoded.key, base.octets, patch});
  if (part->coded.bytes.size() > kMostPartBytes) return none;
  auto encoding =
      std::make_shared<Encoding>(encoding_of(*std::move(part), source.part, codec_.description()));
  encoding->patch = std::move(patch);
  encoding->base_key = base.decoded.key;
  encoding->base_hash = base.hash;
  encoding->whole_rate = base.whole_rate;
  return std::shared_ptr<const Encoding>(std::move(encoding));
}

std::shared_ptr<const PartMatch> Encodings::match(const SourcePart& source, const View& quality,
                                                  const Encoding& base) {
  std::vector<Matched>& matched = matched_[source.part.key];
  for (const Matched& m : matched)
    if (m.content_revision == source.content_revision && m.view == quality && m.hash == base.hash)
      return m.match;
  std::erase_if(matched, [&](const Matched& m) {
    return m.content_revision != source.content_revision || !is_asked(m.view, source);
  });
  const AttributeQuality colors = part_quality(quality, codec_.description()).attributes;
  const MatchBounds bounds{*quality.max_error, colors};
  matched.push_back(
      {quality, source.content_revision, base.hash,
       std::make_shared<const PartMatch>(match_part(source.part, {base.decoded, base.sources}, bounds))});
  return matched.back().match;
}

bool Encodings::fits(const KnownVersion& version, const SourcePart& source, const View& view) {
  const View quality = quality_of(view, source, codec_.description(), *colors_);
  if (version.content_revision == source.content_revision) {
    const Asked* asked = find(source, view);
    const bool is_asked = asked != nullptr && version.encoding == asked->encoding;
    return is_asked || (satisfies(version.encoding->errors, quality) &&
                        keeps_attributes(version.encoding->attribute_errors, quality, codec_.description()));
  }
  if (!quality.max_error || quality.vde || quality.lfe) return false;
  return match(source, quality, *version.encoding)->is_whole();
}

void Encodings::forget(const PartKey& key) {
  asked_.erase(key);
  matched_.erase(key);
}

}  // namespace deltamesh
