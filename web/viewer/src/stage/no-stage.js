// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A Stage on which nothing is drawn, where there is no WebGL.
import { MapSurface } from '../map/map-surface.js';
import { Surface } from './surface.js';

export class NoStage {
  original = new Surface();
  result = new Surface();
  map = new MapSurface();
  diagonal = 1;

  frame(diagonal = this.diagonal) {
    this.diagonal = diagonal;
  }
  setView() {}
  setSplit() {}
  setUp() {}
  setBackground() {}
  showMaterials() {}
  draw() {}
  drawNew() {}
  whenDrawn() {}
}
