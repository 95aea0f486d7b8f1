// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "convert/packer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/try.h"
#include "convert/quality.h"
#include "deltamesh/decode.h"

namespace deltamesh::gltf {
namespace {

constexpr std::size_t kNoAccessor = std::numeric_limits<std::size_t>::max();

/// Mesh errors of the encoder count vertices of the stream, which say nothing to the asset's owner.
Error named_error(const Error& error, const PrimitiveNumber& primitive) noexcept {
  return error.code == ErrorCode::kInvalidMesh ? at_primitive(error, primitive) : error;
}

void count_attribute(std::vector<GltfAttributeReport>& reports, const GltfAttributeReport& one) {
  const auto known = std::ranges::find_if(reports, [&](const GltfAttributeReport& report) {
    return report.semantic == one.semantic && report.morph == one.morph && report.kind == one.kind;
  });
  if (known == reports.end()) {
    reports.push_back(one);
    return;
  }
  known->bytes += one.bytes;
  known->error = std::max(known->error, one.error);
  known->rms = std::max(known->rms, one.rms);
}

void count_stream(GltfReport& report, const StreamMesh& merged, const Encoded& encoded) {
  const StreamInfo& info = encoded.report.stream;
  ++report.streams;
  report.stream_bytes += encoded.bytes.size();
  report.vertices += info.vertices;
  report.triangles += info.triangles;
  report.unreferenced_vertices += merged.unreferenced_vertices;
  report.degenerate_triangles += merged.degenerate_triangles;
  report.welded_vertices += merged.welded_vertices;
  report.dropped_lengths += encoded.report.dropped_lengths;
  GltfStreamReport stream{.info = info};
  report.max_error = std::max(report.max_error, info.quality.max_error);
  if (info.diagonal > 0)
    report.max_error_percent = std::max(
        report.max_error_percent, 100 * info.quality.max_error / (info.diagonal * merged.smallest_diagonal));
  for (std::size_t i = 0; i < merged.attributes.size() && i < info.attributes.size(); ++i) {
    const Semantic& semantic = merged.attributes[i].semantic;
    const GltfAttributeReport one{.semantic = semantic.name,
                                  .morph = semantic.target != kBase,
                                  .kind = info.attributes[i].kind,
                                  .bytes = info.attributes[i].coded_bytes,
                                  .error = info.attributes[i].error,
                                  .rms = info.attributes[i].rms};
    count_attribute(stream.attributes, one);
    count_attribute(report.attributes, one);
  }
  report.stream_reports.push_back(std::move(stream));
}

}  // namespace

Result<StreamPacker::Coded> StreamPacker::code(const StreamPlan& plan, const EncodeOptions& wanted) const {
  const PrimitiveNumber& first = sources_[plan.primitives.front()].number;
  const auto lattice = plan.lattice ? lattice_steps_.find(*plan.lattice) : lattice_steps_.end();
  const bool exact = lattice != lattice_steps_.end() && lattice->second == 0;
  const EncodeOptions asked = exact ? lossless_options(wanted) : wanted;
  const bool keep_order = asked.keep_order || plan.exact_order;
  Coded coded;
  DELTAMESH_TRY(coded.merged, merge_primitives(store_, sources_, plan, merge_options(asked, plan)));
  auto options = stream_options(asked, coded.merged);
  if (!options) return named_error(options.error(), first);
  if (lattice != lattice_steps_.end() && !exact) *options = lattice_options(*options, lattice->second);
  options->keep_order = keep_order;
  options->keep_unreferenced = true;  // merge_primitives() has chosen
  auto encoded = encode(coded.merged.mesh, *options);
  if (!encoded) return named_error(encoded.error(), first);
  coded.encoded = *std::move(encoded);
  return coded;
}

Result<void> StreamPacker::choose_lattices(const std::vector<StreamPlan>& plans, const EncodeOptions& asked) {
  if (asked.lossless) return {};
  for (const StreamPlan& plan : plans) {
    if (!plan.lattice) continue;
    const PrimitiveNumber& first = sources_[plan.primitives.front()].number;
    DELTAMESH_TRY(const StreamMesh merged,
                  merge_primitives(store_, sources_, plan, merge_options(asked, plan)));
    const auto options = stream_options(asked, merged);
    if (!options) return named_error(options.error(), first);
    const auto step = lattice_step(*options, merged.mesh);
    if (!step) return named_error(step.error(), first);
    double& finest = lattice_steps_.try_emplace(*plan.lattice, *step).first->second;
    finest = std::min(finest, *step);
  }
  return {};
}

/// Counted are bytes in buffers and the JSON that primitives grow by, about.
Result<bool> StreamPacker::pays(const StreamPlan& plan, std::uint64_t stream_bytes) const {
  constexpr std::uint64_t kExtensionText = 64;
  constexpr std::uint64_t kAttributeText = 6;  // and the name
  constexpr std::uint64_t kViewText = 50;      // of buffer views that go
  std::set<const std::byte*> places;
  std::uint64_t plain = 0;
  std::uint64_t packed = stream_bytes + kViewText;
  const auto add = [&](std::size_t accessor) -> Result<void> {
    const AccessorRows& rows = store_.rows(accessor);
    if (edits_.is_taken(accessor) || rows.shape().count == 0 || !places.insert(rows.row(0).data()).second)
      return {};
    DELTAMESH_TRY(const std::uint64_t bytes, stored_bytes(document_, accessor));
    plain += bytes + kViewText;
    return {};
  };
  for (const std::size_t primitive : plan.primitives) {
    const PrimitiveSource& source = sources_[primitive];
    DELTAMESH_CHECK(add(source.position));
    if (source.indices) DELTAMESH_CHECK(add(*source.indices));
    packed += kExtensionText;
    for (const SourceAttribute& attribute : source.attributes) {
      DELTAMESH_CHECK(add(attribute.accessor));
      packed += kAttributeText + attribute.semantic.name.size();
    }
  }
  return packed < plain;
}

Result<std::vector<PackedPrimitive>> StreamPacker::pack(const StreamPlan& plan, Coded coded,
                                                        GltfReport& report) {
  DELTAMESH_TRY(const bool worthwhile, pays(plan, coded.encoded.bytes.size()));
  if (!options_.fallback && !worthwhile) {
    report.not_smaller += plan.primitives.size();
    report.converted -= plan.primitives.size();
    return std::vector<PackedPrimitive>();
  }
  DELTAMESH_TRY(const Mesh decoded, decode(coded.encoded.bytes));
  DELTAMESH_ENSURE(decoded.attributes.size() == coded.merged.attributes.size());
  count_stream(report, coded.merged, coded.encoded);
  auto packed = describe(plan, coded.merged, decoded);
  const std::size_t view = append_view(document_, std::move(coded.encoded.bytes));
  for (PackedPrimitive& primitive : packed) primitive.view = view;
  return packed;
}

std::vector<PackedPrimitive> StreamPacker::describe(const StreamPlan& plan, const StreamMesh& merged,
                                                    const Mesh& decoded) {
  const auto replace = [&](std::size_t accessor, const Column& column, bool bounds) {
    return edits_.replace(accessor, described(edits_.original(accessor), column, bounds));
  };
  const std::size_t position =
      replace(sources_[plan.primitives.front()].position, position_column(decoded), true);
  std::vector<std::size_t> attributes(merged.attributes.size(), kNoAccessor);
  std::vector<std::size_t> indices(plan.groups.size(), kNoAccessor);
  const auto corners = corners_by_group(decoded);
  std::vector<PackedPrimitive> packed;
  for (std::size_t i = 0; i < plan.primitives.size(); ++i) {
    const PrimitiveSource& source = sources_[plan.primitives[i]];
    const std::uint32_t group = plan.group_of[i];
    PackedPrimitive primitive{.number = source.number, .group = group, .position = position};
    for (const SourceAttribute& attribute : source.attributes) {
      const std::size_t id = stream_attribute(merged.attributes, store_, source, attribute);
      if (attributes[id] == kNoAccessor) {
        const bool bounds = attribute.semantic.name == "POSITION";
        attributes[id] =
            replace(attribute.accessor, attribute_column(decoded, decoded.attributes[id]), bounds);
      }
      primitive.attributes.push_back({attribute.semantic, attributes[id], id});
    }
    if (indices[group] == kNoAccessor) {
      const ComponentType type = index_type(corners[group]);
      const auto bytes = index_bytes(corners[group], type);
      const Column column = index_column(type, bytes);
      indices[group] = source.indices ? replace(*source.indices, column, false)
                                      : edits_.append(described(Json::object(), column, false));
    }
    primitive.indices = indices[group];
    packed.push_back(std::move(primitive));
  }
  return packed;
}

/// The accessor's JSON, made to fit the column; with its data where there is a fallback.
Json StreamPacker::described(Json accessor, const Column& column, bool bounds) {
  describe_column(accessor, column, bounds);
  if (options_.fallback) accessor["bufferView"] = append_column(document_, column);
  return accessor;
}

}  // namespace deltamesh::gltf
