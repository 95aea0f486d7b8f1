// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What `core` and its parts hand to each other by way of JavaScript (packages/decoder/decoder.js): the
// modules `highpass`, `zstd`, `rare` and `grid`, whose memories are others. All are built alike, so
// structures are copied as they are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "attributes/payload.h"
#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"
#include "format/highpass_parameters.h"
#include "format/predictive_parameters.h"
#include "outcome.h"
#include "runtime.h"

namespace deltamesh::web {

/// In the memory of a part.
struct HandedArray {
  std::uint32_t address = 0;
  std::uint32_t bytes = 0;
};

/// What a call returns.
struct PartArrays {
  std::uint32_t count = 0;
  std::array<HandedArray, 4> arrays{};

  template <class Array>
  void add(const Array& array) {
    const auto bytes = std::as_bytes(std::span(array));
    arrays[count++] = {.address = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(bytes.data())),
                       .bytes = static_cast<std::uint32_t>(bytes.size())};
  }
};

struct PartOutcome {
  ErrorOutcome error;
  PartArrays returned;
};
static_assert(offsetof(PartOutcome, returned) == 32 && sizeof(PartArrays) == 36);

/// The arguments of read_highpass(). Returns an array of Vec3, one for every vertex.
struct HighpassCall {
  Box box;
  HighpassParameters parameters;
  HandedArray deltas;
  HandedArray anchors;
  std::uint32_t deltas_are_compact = 0;
  std::uint32_t anchors_are_compact = 0;
  HandedArray offsets;
  HandedArray neighbors;
  HandedArray labels;
  HandedArray sizes;
};

/// The arguments of expand_frame(). Returns an array of bytes, or none where it is false.
struct ZstdCall {
  std::uint32_t expanded_bytes = 0;
  HandedArray frame{};
};

/// What `rare` reads: an array of floats for positions, else of bytes.
enum class RareForm : std::uint32_t {
  kPositions,  ///< read_float_positions()
  kAttribute,  ///< read_rare_values()
  kPlain,      ///< read_plain_values()
};

/// The arguments of these.
struct RareCall {
  RareForm form = RareForm::kPositions;
  std::uint32_t vertex_count = 0;
  HandedArray bytes{};
  HandedArray triangles{};
  HandedArray geometric{};  ///< of attributes' surface
  HandedArray positions{};  ///< likewise, or none
  HandedArray joints{};     ///< of weights
  AttributeCoding coding = AttributeCoding::kLattice;
  AttributeKind kind = AttributeKind::kGeneric;
  ComponentType type = ComponentType::kF32;
  std::uint32_t components = 1;
  Box box{};  ///< of kPositions
};

/// The arguments of read_grid(). Returns an array of faces and one of floats for positions.
struct GridCall {
  PredictiveParameters parameters{};
  std::uint32_t vertices = 0;
  std::uint32_t triangles = 0;
  std::array<HandedArray, 2> chunks{};  ///< GridChunks
};

/// In a part: copies an array that was handed over, and releases it.
template <class Vector>
Vector take_array(HandedArray array) {
  using T = typename Vector::value_type;
  T* const begin = reinterpret_cast<T*>(static_cast<std::uintptr_t>(array.address));
  Vector values(begin, begin + array.bytes / sizeof(T));
  release(begin);
  return values;
}

}  // namespace deltamesh::web
