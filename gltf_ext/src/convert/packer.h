// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Codes the streams of an asset, and says what its primitives refer to then.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "document/column.h"
#include "document/edits.h"
#include "document/extension.h"
#include "stream/mesh.h"

namespace deltamesh::gltf {

class StreamPacker {
 public:
  /// All arguments must outlive the packer. `kept`: accessors that stay as they are.
  StreamPacker(Document& document, const AccessorStore& store, const std::vector<PrimitiveSource>& sources,
               const GltfPackOptions& options, std::set<std::uint64_t> kept)
      : document_(document),
        store_(store),
        sources_(sources),
        options_(options),
        edits_(document.json, std::move(kept)) {}

  /// Chooses the steps of the lattices that streams share, so that all of them are as `asked`. Errors: as
  /// pack_gltf().
  Result<void> choose_lattices(const std::vector<StreamPlan>& plans, const EncodeOptions& asked);

  struct Coded {
    StreamMesh merged;
    Encoded encoded;
  };
  /// One stream as `asked`, beside the asset. Errors: as pack_gltf().
  Result<Coded> code(const StreamPlan& plan, const EncodeOptions& asked) const;

  /// Puts the stream into the asset and counts it in `report`; returns what the plan's primitives become:
  /// nothing where they stay as they are, as that takes fewer bytes.
  /// Errors: as pack_gltf().
  Result<std::vector<PackedPrimitive>> pack(const StreamPlan& plan, Coded coded, GltfReport& report);

  /// Writes the accessors of all streams: until then the originals are still read.
  void write_accessors() { edits_.apply(); }

 private:
  /// Whether the asset gets smaller by the stream.
  Result<bool> pays(const StreamPlan& plan, std::uint64_t stream_bytes) const;
  std::vector<PackedPrimitive> describe(const StreamPlan& plan, const StreamMesh& merged,
                                        const Mesh& decoded);
  Json described(Json accessor, const Column& column, bool bounds);

  Document& document_;
  const AccessorStore& store_;
  const std::vector<PrimitiveSource>& sources_;
  const GltfPackOptions& options_;
  AccessorEdits edits_;
  std::map<std::size_t, double> lattice_steps_;  ///< by lattice; 0: positions are exact
};

}  // namespace deltamesh::gltf
