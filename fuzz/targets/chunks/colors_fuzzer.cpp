// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Coded colours from anywhere, and numbers at a mean error. The last byte says their type, the number of
// components, the mesh, if its positions are known, and the coding. What is read must be whole; written
// exactly it must come back, and what is written at a mean error as the writer says.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "attributes/colors/colors.h"
#include "attributes/haar/haar.h"
#include "goal.h"
#include "meshes.h"
#include "support/attribute_coding.h"

namespace {

using namespace deltamesh;

fuzz::Goal exact_colors("colours");
fuzz::Goal colors_at_mean("colours at a mean error");
fuzz::Goal numbers_at_mean("numbers at a mean error");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr ComponentType kTypes[] = {ComponentType::kU8, ComponentType::kU16, ComponentType::kF32,
                                      ComponentType::kU8};
  static const fuzz::ColoredMesh kMeshes[] = {fuzz::ColoredMesh(test::fragments()),
                                              fuzz::ColoredMesh(test::fan(30))};
  if (size == 0) return 0;
  const unsigned choice = data[size - 1];
  const ComponentType type = kTypes[choice % 4];
  const bool at_mean_error = (choice & 64) != 0;
  const bool are_numbers = at_mean_error && choice >= 128;
  const unsigned components = are_numbers ? 1 : 3 + choice / 4 % 2;
  const AttributeSurface surface = kMeshes[choice / 8 % 2].surface((choice & 16) != 0, (choice & 32) != 0);
  const Attribute shape{.kind = are_numbers ? AttributeKind::kGeneric : AttributeKind::kColor,
                        .type = type,
                        .components = static_cast<std::uint8_t>(components)};
  const auto bytes = std::as_bytes(std::span(data, size - 1));
  const auto read = at_mean_error ? read_haar_values(bytes, shape, surface)
                                  : read_surface_colors(bytes, type, components, surface);
  if (!fuzz::check(read)) return 0;
  if (read->size() != surface.vertex_count() * components * component_size(type)) std::abort();
  const auto order = test::identity(surface.vertex_count());
  const AttributeView view{
      .type = type, .components = static_cast<std::uint8_t>(components), .name = {}, .values = *read};
  if (at_mean_error) {
    const AttributeRows rows(view, order);
    const double rms = 1 + choice % 4;
    const auto written = write_haar_values(type, rows, rms, surface);
    if (!written) return 0;
    const auto again = read_haar_values(written->bytes, shape, surface);
    if (!again || *again != written->values) std::abort();
    (are_numbers ? numbers_at_mean : colors_at_mean).reach();
    return 0;
  }
  const auto written = write_surface_colors(type, AttributeRows(view, order), 0, surface);
  if (!written || written->values != *read) std::abort();
  const auto again = read_surface_colors(written->bytes, type, components, surface);
  if (!again || *again != *read) std::abort();
  exact_colors.reach();
  return 0;
}
