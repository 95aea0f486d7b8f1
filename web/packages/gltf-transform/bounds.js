// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the options of a whole asset mean for one of its streams, as gltf_ext/src/convert/quality.h has it.
import { PropertyType } from '@gltf-transform/core';

/** A displacement is within a distance where each of its three components is within this part of it. */
const COMPONENT_SHARE = 0.57735026918962576;
const RADIANS_PER_DEGREE = 0.017453292519943296;
const SHARE_OF_DIAGONAL = 0.0002;
const SHARE_OF_EDGE = 0.04;
const SAMPLED_FACES = 2 ** 15;

/** The largest factor by which KHR_texture_transform stretches what the primitives' materials draw. */
export function stretchOf(primitives, graph) {
  let largest = 1;
  const seen = new Set();
  const pending = [...primitives];
  while (pending.length > 0) {
    const property = pending.pop();
    if (seen.has(property) || property.propertyType === PropertyType.ACCESSOR) continue;
    seen.add(property);
    const scale = property.propertyType === PropertyType.TEXTURE_INFO && property.getExtension('KHR_texture_transform')?.getScale();
    if (scale) largest = Math.max(largest, ...scale.map(Math.abs));
    pending.push(...graph.listChildren(property));
  }
  return largest;
}

function diagonalOf(positions) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3], x);
    max[i % 3] = Math.max(max[i % 3], x);
  });
  return Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}

/** What the encoder keeps of positions that nothing is asked of. */
function defaultError({ positions, indices }) {
  const length = (a, b) => {
    const [x, y, z] = [0, 1, 2].map((k) => positions[3 * a + k] - positions[3 * b + k]);
    return Math.sqrt(x * x + y * y + z * z);
  };
  const faces = indices.length / 3;
  let sum = 0;
  let count = 0;
  for (let f = 0; f < faces; f += Math.floor(faces / SAMPLED_FACES) + 1) {
    const [a, b, c] = indices.subarray(3 * f, 3 * f + 3);
    sum += length(a, b) + length(b, c) + length(c, a);
    count += 3;
  }
  const bound = Math.min(SHARE_OF_DIAGONAL * diagonalOf(positions), count > 0 && sum > 0 ? (SHARE_OF_EDGE * sum) / count : Infinity);
  return bound > 0 ? bound : 1;
}

/** About the largest distance of a decoded position from its source. `measure`: what a mesh without attributes gets. */
function positionError(options, mesh, measure) {
  const inModel = (bound) => {
    if (typeof bound === 'number') return bound;
    if (bound?.unit === 'paper') return undefined;
    return bound?.unit === 'diagonal' ? (bound.value / 100) * diagonalOf(mesh.positions) : bound?.value;
  };
  const most = inModel(options.maxError);
  if (most !== undefined && Number.isFinite(most)) return most;
  const mean = inModel(options.lfe);
  if (mean !== undefined) return mean / COMPONENT_SHARE;
  const { targetBytes, ...trial } = options;
  const asks = ['vde', 'lfe', 'maxError', 'bits', 'step', 'anchors', 'anchorDensity'].some((name) => trial[name] !== undefined);
  return asks ? measure({ ...mesh, attributes: [] }, trial) : defaultError(mesh);
}

/**
 * Displacements of morph targets get bounds where the caller names none: of positions the bound on those, of normals and tangents the
 * angle's. Texture coordinates keep theirs behind KHR_texture_transform.
 */
export function streamOptions(options, mesh, stretch, measure) {
  if (options.lossless) return options;
  const named = options.attributeErrors ?? {};
  const { normalError = 0.5, uvError = 1 / 4096 } = options;
  const usual = {
    POSITION: () => positionError(options, mesh, measure) * COMPONENT_SHARE,
    NORMAL: () => normalError * RADIANS_PER_DEGREE * COMPONENT_SHARE,
    TANGENT: () => (options.tangentError ?? normalError) * RADIANS_PER_DEGREE * COMPONENT_SHARE,
  };
  const attributeErrors = { ...named };
  for (const name of new Set(mesh.attributes.filter(({ kind }) => kind === 'generic').map((attribute) => attribute.name))) {
    const semantic = name.slice(1);
    const error = name.startsWith('d') ? (named[semantic] ?? usual[semantic]?.()) : undefined;
    if (error !== undefined) attributeErrors[name] = error;
  }
  return { ...options, uvError: uvError / stretch, attributeErrors };
}
