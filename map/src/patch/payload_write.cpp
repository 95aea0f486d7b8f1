// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/coder/writer.h"
#include "patch/coder.h"
#include "patch/payload.h"

namespace deltamesh {

std::vector<std::byte> write_patch_plan(const Mesh& base, const Mesh& inserted, PatchPlan plan) {
  CompactWriter writer;
  PatchModels models;
  code_staying(writer, models, base, plan.stays);
  const auto staying = staying_triangles(base, plan.stays);
  JoinCoder(writer, models, base, staying, inserted).code(plan.joins);
  return writer.finish();
}

}  // namespace deltamesh
