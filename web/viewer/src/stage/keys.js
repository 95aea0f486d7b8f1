// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The camera by keys: arrows turn, + and - zoom, 0 shows all.
import { Spherical, Vector3 } from 'three';

const TURN = Math.PI / 24;
const ZOOM = 1.15;
const TURNS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
const ZOOMS = { '+': 1 / ZOOM, '=': 1 / ZOOM, '-': ZOOM };

export function moveByKeys(element, camera, controls, showAll) {
  const place = new Spherical();
  const offset = new Vector3();
  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const { key } = event;
    if (key === '0' || key === 'Home') showAll();
    else if (!TURNS[key] && !ZOOMS[key]) return;
    event.preventDefault();
    const [around, down] = TURNS[key] ?? [0, 0];
    // Spherical has y up, the camera z.
    offset.copy(camera.position).sub(controls.target);
    place.setFromCartesianCoords(offset.x, offset.z, -offset.y);
    place.theta += around * TURN;
    place.phi = Math.min(Math.PI - 0.01, Math.max(0.01, place.phi + down * TURN));
    place.radius *= ZOOMS[key] ?? 1;
    offset.setFromSpherical(place);
    camera.position.set(offset.x, -offset.z, offset.y).add(controls.target);
    controls.update();
  });
}
