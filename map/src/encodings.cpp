// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encodings.h"

#include <xxhash.h>

#include <algorithm>

#include "base/try.h"

namespace deltamesh {
namespace {

/// The view's quality, without places and rate.
View quality_of(const View& view) {
  View quality;
  quality.vde = view.vde;
  quality.lfe = view.lfe;
  quality.max_error = view.max_error;
  quality.color_error = view.color_error;
  return quality;
}

PartQuality part_quality(const View& view, const SenderOptions& options) {
  PartQuality quality;
  if (view.vde) quality.bounds.vde = QualityBound{*view.vde};
  if (view.lfe) quality.bounds.lfe = QualityBound{*view.lfe};
  if (view.max_error) quality.bounds.max_error = QualityBound{*view.max_error};
  quality.attributes.color_error = view.color_error;
  quality.effort = options.effort;
  quality.geometry = options.geometry;
  return quality;
}

PartErrors errors_of_coded(const CodedPart& coded, const MapDescription& description) {
  PartErrors errors{.is_per_vertex = true,
                    .vde = coded.quality.vde_rms,
                    .lfe = coded.quality.lfe_rms,
                    .max_error = coded.quality.max_error};
  for (std::size_t i = 0; i < coded.attribute_errors.size(); ++i)
    if (description.attributes[i].kind == AttributeKind::kColor)
      errors.color_error = std::max(errors.color_error, coded.attribute_errors[i]);
  return errors;
}

}  // namespace

Result<std::shared_ptr<const Encoding>> Encodings::get(const SourcePart& source, const View& view) {
  const View quality = quality_of(view);
  std::vector<Asked>& asked = asked_[source.part.key];
  std::erase_if(asked, [&](const Asked& a) { return a.content_revision != source.content_revision; });
  const auto known = std::ranges::find(asked, quality, &Asked::view);
  if (known != asked.end()) return known->encoding;
  DELTAMESH_TRY(CodedPart coded, codec_.encode(source.part, part_quality(quality, options_)));
  auto encoding = std::make_shared<Encoding>();
  DELTAMESH_TRY(encoding->decoded, codec_.decode(source.part.key, coded.bytes));
  encoding->hash = XXH3_64bits(coded.bytes.data(), coded.bytes.size());
  encoding->errors = errors_of_coded(coded, codec_.description());
  encoding->octets = std::move(coded.bytes);
  encoding->quality = coded.quality;
  encoding->attribute_errors = std::move(coded.attribute_errors);
  ++encoded_;
  asked.push_back({quality, source.content_revision, encoding});
  return std::shared_ptr<const Encoding>(std::move(encoding));
}

PartErrors Encodings::errors_of(const KnownVersion& version, const SourcePart& source) {
  if (version.content_revision == source.content_revision) return version.encoding->errors;
  std::vector<Measured>& measured = measured_[source.part.key];
  std::erase_if(measured, [&](const Measured& m) { return m.content_revision != source.content_revision; });
  const auto known = std::ranges::find(measured, version.encoding->hash, &Measured::hash);
  if (known != measured.end()) return known->errors;
  const PartErrors errors = errors_between(source.part.mesh, version.encoding->decoded.mesh);
  measured.push_back({source.content_revision, version.encoding->hash, errors});
  return errors;
}

void Encodings::prune(const SourceMap& map) {
  const auto is_gone = [&](const auto& entry) { return map.find(entry.first) == nullptr; };
  std::erase_if(asked_, is_gone);
  std::erase_if(measured_, is_gone);
}

}  // namespace deltamesh
