// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A whole mesh as a map: its state, ready to be saved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/decode.h"
#include "deltamesh/map/folder.h"
#include "deltamesh/map/part.h"
#include "deltamesh/map/part_quality.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// A manifest, and what its entries stand for.
struct MapState {
  MapManifest manifest{};
  std::vector<std::vector<std::byte>> octets{};  ///< of every entry
  /// What was asked of positions, as it was asked: percents stay percents. Empty: nothing, or not known.
  QualityRequest asked{};
  /// That in model units, or what encode() has for the whole mesh where nothing was asked. A state before
  /// with it keeps these bounds, and so its lattice, where settings ask the same again or nothing: however
  /// the mesh has grown. Empty: not known, or no faces yet.
  QualityRequest bounds{};
  AttributeQuality attributes{};  ///< what was asked of attributes, and decided for colours
};

struct MapSettings {
  std::uint64_t id = 1;
  std::string frame = "map";
  /// Edge of the largest parts, model units, above 0; an eighth of it is the smallest.
  double part_edge = 1;
  /// Cells with more triangles are divided, down to the smallest.
  std::uint32_t most_triangles = 16384;
  /// Levels above that of the largest parts. With any, there are coarser copies on all levels above 0
  /// [MAP-19].
  std::uint8_t levels = 0;
  /// Percentages count in the diagonal of the whole mesh, without stray vertices. Without bounds: those of
  /// the state before, or as encode() has it, for the whole mesh; other bounds than those asked before
  /// replace them, all of them. A mesh without faces has bounds for which any will do. Where nothing is said
  /// of colours, those of the whole mesh decide what all parts keep (ColorContent).
  PartQuality quality{};
};

/// Errors: kInvalidArgument.
Result<void> validate(const MapSettings& settings) noexcept;

/// The state after one more update, whose content is `mesh`; where that changes nothing, there is none. The
/// lattice is the coarsest that suits the quality; where a part cannot keep its bounds there, all is encoded
/// again on one of half the step, up to six times. `before`: the state before, or null. What all parts share
/// stays as it is there where that is possible, and a part whose octets stay has the revision that it had;
/// otherwise a new epoch begins, also where the mesh is on another grid than the map. Parts are made smaller
/// where one takes more than kMostPartBytes. Errors: as split() and MapCodec::encode().
Result<MapState> encode_map(const MeshView& mesh, const MapSettings& settings,
                            const MapState* before = nullptr) noexcept;

/// The parts that show the map on a level (keys_on_level()) as one mesh, whose attributes keep the bounds of
/// the parts; see join() for which vertices are shared. Errors: kInvalidArgument (a level above top_level()),
/// as MapCodec::decode() and join().
Result<Mesh> decode_map(const MapState& state, const DecodeOptions& options = {},
                        std::uint8_t level = 0) noexcept;

}  // namespace deltamesh
