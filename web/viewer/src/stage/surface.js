// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// One mesh in the scene: shading, wires, heat.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  Sphere,
  Vector2,
} from 'three';

import { withCopies } from '../mesh/creases.js';

const COLOR = 0xc9b48f;

/** Replaces the colour by that of `value` in the heat map, where that is on. */
function addHeat(material, uniforms) {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nattribute float value;\nvarying float vValue;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nvValue = value;');
    shader.fragmentShader = shader.fragmentShader
      .replace(
        '#include <common>',
        '#include <common>\nuniform sampler2D heatMap;\nuniform vec2 heatRange;\nuniform bool heatOn;\nvarying float vValue;',
      )
      .replace(
        '#include <color_fragment>',
        `#include <color_fragment>
        if (heatOn) {
          float share = clamp((vValue - heatRange.x) / (heatRange.y - heatRange.x), 0.0, 1.0);
          diffuseColor.rgb = texture2D(heatMap, vec2(share, 0.5)).rgb;
        }`,
      );
  };
}

export class Surface extends Group {
  #geometry = null;
  #material = new MeshLambertMaterial({ side: DoubleSide, toneMapped: false, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  #wires = null;
  #mesh = null;
  #authored = null;
  #isAuthored = false;
  #model = null;
  #copies = null;
  #values = null;
  #uniforms = { heatMap: { value: null }, heatRange: { value: new Vector2() }, heatOn: { value: false } };
  #wireMaterial = new LineBasicMaterial({ color: 0x10161d, toneMapped: false, transparent: true, opacity: 0.4 });

  constructor() {
    super();
    addHeat(this.#material, this.#uniforms);
  }

  /** `materials`: of the groups' numbers, or null. */
  setMaterials(materials) {
    for (const material of this.#authored ?? []) material.dispose();
    this.#authored = materials?.map((material) => material.clone()) ?? null;
    this.#choose();
  }

  /** Whether materials are seen where there are any, and no heat. */
  showMaterials(isShown) {
    this.#isAuthored = isShown;
    this.#choose();
  }

  /** What is seen in place of the mesh where materials are: a Model, or null. */
  setModel(model) {
    this.#model?.removeFromParent();
    this.#model?.dispose();
    this.#model = model;
    if (model) this.add(model);
    this.#choose();
  }

  get model() {
    return this.#model;
  }

  #choose() {
    if (!this.#mesh) return;
    const isOwn = this.#isAuthored && !this.#uniforms.heatOn.value;
    const isAuthored = isOwn && this.#authored;
    if (this.#model) this.#model.visible = isOwn;
    this.#mesh.visible = !(isOwn && this.#model);
    this.#mesh.material = isAuthored ? this.#ofGroups() : this.#material;
  }

  #ofGroups() {
    for (const material of this.#authored) {
      material.vertexColors = Boolean(this.#geometry.attributes.color);
      material.needsUpdate = true;
    }
    return this.#geometry.groups.length > 0 ? this.#authored : this.#authored[0];
  }

  /** `display`: of displayOf(). */
  setDisplay({ positions, indices, normals, colors, uvs, ranges, copies }, radius) {
    this.empty();
    this.#copies = copies;
    const geometry = (this.#geometry = new BufferGeometry());
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    if (colors) geometry.setAttribute('color', new BufferAttribute(colors, 4, true));
    if (uvs) geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
    geometry.setIndex(new BufferAttribute(indices, 1));
    for (const { group, start, count } of ranges ?? []) geometry.addGroup(start, count, group);
    geometry.boundingSphere = new Sphere(undefined, radius);
    this.#material.vertexColors = Boolean(colors);
    this.#material.color.set(colors ? 0xffffff : COLOR);
    this.#material.needsUpdate = true;
    this.#mesh = new Mesh(geometry, this.#material);
    this.#mesh.castShadow = this.#mesh.receiveShadow = true;
    this.add(this.#mesh);
    this.#choose();
  }

  empty() {
    this.#geometry?.dispose();
    this.#wires?.geometry.dispose();
    this.#geometry = this.#wires = this.#mesh = this.#copies = this.#values = null;
    this.setModel(null);
    this.clear();
  }

  get geometry() {
    return this.#geometry;
  }

  /** Vertices of the geometry that are there once more: see creasedNormals(); or null. */
  get copies() {
    return this.#copies;
  }

  setShading(isFlat) {
    if (this.#material.flatShading === isFlat) return;
    this.#material.flatShading = isFlat;
    this.#material.needsUpdate = true;
  }

  get hasWires() {
    return this.#wires !== null;
  }

  /** `edges`: pairs of vertices. */
  setWires(edges) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.#geometry.attributes.position);
    geometry.setIndex(new BufferAttribute(edges, 1));
    geometry.boundingSphere = this.#geometry.boundingSphere;
    this.#wires = new LineSegments(geometry, this.#wireMaterial);
    this.add(this.#wires);
  }

  showWires(isShown) {
    if (this.#wires) this.#wires.visible = isShown;
  }

  /** `values`: one per vertex, or null for the own colour. `limit`: end of the scale. */
  setHeat(values, { texture, isSigned, limit } = {}) {
    this.#uniforms.heatOn.value = values !== null;
    this.#choose();
    if (values === null) return;
    if (this.#values !== values) this.#geometry.setAttribute('value', new BufferAttribute(this.#copies ? withCopies(values, 1, this.#copies) : values, 1));
    this.#values = values;
    this.#uniforms.heatMap.value = texture;
    this.#uniforms.heatRange.value.set(isSigned ? -limit : 0, limit);
  }
}
