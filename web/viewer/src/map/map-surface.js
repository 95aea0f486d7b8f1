// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The parts of a map in the scene.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, Mesh, MeshLambertMaterial, SRGBColorSpace } from 'three';

const COLOR = 0xc9b48f;

/** Of stops like '#aabbcc', mixed as they are seen. */
function colorAt(stops, share) {
  const place = Math.min(share * (stops.length - 1), stops.length - 1 - 1e-9);
  const [low, high] = [stops[Math.floor(place)], stops[Math.floor(place) + 1]].map((stop) => {
    const { r, g, b } = new Color(stop).getRGB({}, SRGBColorSpace);
    return [r, g, b];
  });
  return new Color().setRGB(...low.map((value, c) => value + (place % 1) * (high[c] - value)), SRGBColorSpace);
}

export class MapSurface extends Group {
  #parts = new Map();
  #shading = 'smooth';

  get keys() {
    return [...this.#parts.keys()];
  }

  /** The file that the part of this key was read from. */
  fileOf(key) {
    return this.#parts.get(key)?.file;
  }

  /** `display`: of displayOf(). What the part had before is gone. */
  setPart(key, file, { positions, indices, normals, colors }) {
    this.removePart(key);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    if (colors) geometry.setAttribute('color', new BufferAttribute(colors, 4, true));
    geometry.setIndex(new BufferAttribute(indices, 1));
    const mesh = new Mesh(geometry, new MeshLambertMaterial({ side: DoubleSide, toneMapped: false }));
    this.#shade(mesh.material);
    this.#parts.set(key, { file, mesh });
    this.add(mesh);
  }

  removePart(key) {
    const part = this.#parts.get(key);
    if (!part) return;
    part.mesh.geometry.dispose();
    part.mesh.material.dispose();
    this.remove(part.mesh);
    this.#parts.delete(key);
  }

  empty() {
    for (const key of this.keys) this.removePart(key);
  }

  setShading(shading) {
    if (shading === this.#shading) return;
    this.#shading = shading;
    for (const { mesh } of this.#parts.values()) this.#shade(mesh.material);
  }

  #shade(material) {
    material.wireframe = this.#shading === 'wire';
    material.flatShading = this.#shading !== 'smooth';
    material.needsUpdate = true;
  }

  /** `shares`: by key, 0 to 1, or null for the parts' own colours; `stops`: colours of the scale. */
  setColors(shares, stops) {
    for (const [key, { mesh }] of this.#parts) {
      const { material, geometry } = mesh;
      const hasOwn = shares === null && 'color' in geometry.attributes;
      if (material.vertexColors !== hasOwn) material.needsUpdate = true;
      material.vertexColors = hasOwn;
      if (shares) material.color.copy(colorAt(stops, shares.get(key)));
      else material.color.set(hasOwn ? 0xffffff : COLOR);
    }
  }
}
