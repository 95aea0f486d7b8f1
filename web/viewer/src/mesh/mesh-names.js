// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Names of files that meshes are in.

export const MESH_SUFFIXES = ['ply', 'obj', 'stl', 'glb', 'gltf', 'dmsh'];

export const suffixOf = (name) => name.split('.').pop().toLowerCase();

export const isMeshName = (name) => MESH_SUFFIXES.includes(suffixOf(name));
