// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Seeds of attributes predicted from the surface: normals, texture coordinates, tangents.
#include <cstdint>
#include <string>
#include <vector>

#include "attribute_values.h"
#include "attributes/normals/normals.h"
#include "attributes/tangents/tangents.h"
#include "attributes/uvs/uvs.h"
#include "seeds.h"
#include "support/attribute_coding.h"
#include "targets/chunks/meshes.h"

namespace deltamesh::fuzz {
namespace {

using enum AttributeKind;
using enum ComponentType;

/// A patch as FuzzedSurface has it; `flags`: copies, which are the faces' of every other row, and positions.
Bytes patch_bytes(unsigned flags) {
  const test::Soup soup = test::grid(kSide - 1, kSide - 1, false, false, 0, 3);
  Bytes bytes = bytes_of({soup.vertex_count - 1, soup.triangles.size() / 3, flags});
  for (const std::uint32_t v : soup.triangles) bytes.push_back(static_cast<std::byte>(v));
  std::vector<float> positions;
  for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
    if ((flags & 1) != 0) bytes.push_back(static_cast<std::byte>(v / 2));
    for (const double x : {static_cast<double>(v % kSide), static_cast<double>(v / kSide), wave(v, 0)})
      positions.push_back(static_cast<float>(x));
  }
  return (flags & 2) != 0 ? bytes + float_bytes(positions) : bytes;
}

std::vector<float> floats_of(AttributeKind kind, unsigned components, std::uint32_t vertices) {
  return test::numbers<float>(attribute_of(kind, kF32, components, vertices));
}

void make_directions(const Corpora& corpora) {
  const test::Soup soup = test::grid(kSide - 1, kSide - 1, false, false, 0, 3);
  for (unsigned flags = 0; flags < 4; ++flags) {
    const std::string name =
        std::string((flags & 1) != 0 ? "positions" : "blind") + ((flags & 2) != 0 ? "_copies" : "");
    Bytes seed = bytes_of({flags, soup.triangles.size() / 3});
    for (const std::uint32_t v : soup.triangles) seed.push_back(static_cast<std::byte>(v));
    const FacesOfBytes faces(seed);
    const auto normals = floats_of(kNormal, 3, faces.surface().vertex_count());
    const auto coded = check(write_surface_normals(normals, 0.5, faces.surface()));
    corpora.add("normals", name, seed + coded.bytes);
  }
}

void make_textured(const Corpora& corpora) {
  for (unsigned flags = 0; flags < 4; ++flags) {
    const std::string name =
        std::string((flags & 2) != 0 ? "positions" : "blind") + ((flags & 1) != 0 ? "_copies" : "");
    const Bytes patch = patch_bytes(flags);
    const test::FuzzedSurface mesh(patch);
    const std::uint32_t count = mesh.vertex_count();
    const std::vector<float> uvs = floats_of(kUv, 2, count);
    corpora.add("uvs", name, patch + check(write_surface_uvs(uvs, 1.0 / 1024, mesh.surface())).bytes);
    for (unsigned known = 0; known < 4; ++known) {
      Bytes seed = patch + bytes_of({known});
      if ((known & 1) != 0) seed = seed + float_bytes(floats_of(kNormal, 3, count));
      if ((known & 2) != 0) seed = seed + float_bytes(uvs);
      test::FuzzedSurface basis(seed);
      const auto coded =
          check(write_surface_tangents(floats_of(kTangent, 4, count), 0.5, basis.surface(), basis_of(basis)));
      corpora.add("tangents", name + "_" + std::to_string(known), seed + coded.bytes);
    }
  }
}

}  // namespace

void make_surface_attributes(const Corpora& corpora) {
  make_directions(corpora);
  make_textured(corpora);
}

}  // namespace deltamesh::fuzz
