// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "commands/drive.h"

#include <iostream>
#include <utility>

#include "exit_codes.h"
#include "report/console.h"
#include "scenes/drive.h"
#include "sequence/sequence.h"

namespace deltamesh::cli {
namespace {

SequenceHeader header_of(const Drive& drive, std::uint64_t seed) {
  return {.description =
              "generated drive through rooms, seed " + std::to_string(seed) + ", an update every 0.2 s",
          .voxel = drive.voxel(),
          .block_voxels = kDriveBlockVoxels,
          .block_metres = kDriveBlockVoxels * drive.voxel(),
          .origin = drive.origin()};
}

SequenceStep step_of(DriveUpdate update) {
  SequenceStep step;
  for (DriveBlock& block : update.changed) step.changed.push_back({block.id, std::move(block.mesh)});
  step.removed = std::move(update.removed);
  return step;
}

}  // namespace

int write_drive(const std::string& folder, std::uint32_t steps, std::uint64_t vertices, std::uint64_t seed) {
  auto drive = Drive::make(vertices, seed);
  if (!drive) return fail("--vertices", drive.error());
  auto writer = SequenceWriter::create(folder, header_of(*drive, seed));
  if (!writer) return fail(folder, writer.error());
  std::uint64_t changed = 0;
  std::uint64_t removed = 0;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const SequenceStep step = step_of(drive->next());
    changed += step.changed.size();
    removed += step.removed.size();
    std::vector<SequenceBlock> blocks;
    for (const auto& [id, mesh] : drive->blocks()) blocks.push_back({id, mesh});
    if (auto added = writer->add(step, blocks); !added) return fail(folder, added.error());
  }
  std::cout << "rooms -> " << folder << ": " << counted(steps, "update", "updates") << ", "
            << counted(changed, "changed block", "changed blocks") << ", " << grouped(removed)
            << " removed; at the end " << counted(writer->vertices(), "vertex", "vertices") << ", "
            << counted(writer->triangles(), "triangle", "triangles") << '\n';
  return kOk;
}

}  // namespace deltamesh::cli
