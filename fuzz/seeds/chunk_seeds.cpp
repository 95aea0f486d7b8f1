// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// chunk_seeds FOLDER: writes the seeds of chunks' fuzz targets, of the present draft, below FOLDER
// (fuzz/corpus).
#include "seeds.h"

int main(int argc, char** argv) {
  if (argc != 2) return EXIT_FAILURE;
  const deltamesh::fuzz::Corpora corpora(argv[1]);
  make_topology(corpora);
  make_geometry(corpora);
  make_attributes(corpora);
  make_surface_attributes(corpora);
}
