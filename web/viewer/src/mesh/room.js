// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A room, metres, z up: what is seen first. Pieces have materials; light that does not come to corners and
// below furniture is in the colours.
import { joinMeshes } from './join.js';
import { cushion, knot, surface, turned } from './shapes.js';

const SIZE = 5;
const HEIGHT = 2.8;
const smooth = (from, to, x) => {
  const share = Math.min(1, Math.max(0, (x - from) / (to - from)));
  return share * share * (3 - 2 * share);
};
const mix = (a, b, share) => a.map((value, i) => value + share * (b[i] - value));
/** 0 to 1, the same for the same numbers. */
const chance = (a, b = 0) => {
  const value = Math.sin(a * 127.1 + b * 311.7) * 43758.5453;
  return value - Math.floor(value);
};
const placeAt = (positions, at) => [positions[at], positions[at + 1], positions[at + 2]];
const interpolate = (points) => (t) => {
  const place = Math.min(points.length - 1.0001, t * (points.length - 1));
  const [low, share] = [Math.floor(place), smooth(0, 1, place % 1)];
  return mix(points[low], points[low + 1], share);
};

/** Footprints that stand on the floor: centre and half sides. */
const STANDING = [[2.6, 4.2, 1.15, 0.5], [0.75, 3.9, 0.3, 0.3], [4.2, 1.5, 0.42, 0.42], [2.5, 2.3, 0.6, 0.36]];

/** How much light comes to a place of the floor. */
function floorLight(x, y) {
  const walls = 0.55 + 0.45 * smooth(0, 0.9, Math.min(x, SIZE - y));
  return STANDING.reduce((light, [cx, cy, hx, hy]) => {
    const away = Math.hypot(Math.max(0, Math.abs(x - cx) - hx), Math.max(0, Math.abs(y - cy) - hy));
    return light * (0.45 + 0.55 * smooth(-0.05, 0.45, away));
  }, walls);
}

function plank([x, y]) {
  const row = Math.floor(x / 0.24);
  const piece = Math.floor((y + chance(row)) / 1.3);
  return mix([150, 104, 66], [186, 140, 96], chance(row, piece));
}
const groove = (x) => (Math.abs((x / 0.24) % 1 - 0.5) > 0.46 ? -0.006 : 0);

const wallLight = (z, away) => (0.55 + 0.45 * smooth(0, 0.7, z)) * (0.6 + 0.4 * smooth(0, 0.9, away)) * (0.8 + 0.2 * smooth(0, 0.6, HEIGHT - z));
const standingLight = ([, , z]) => 0.45 + 0.55 * smooth(0, 0.5, z);
const plaster = (a, b) => 0.003 * Math.sin(9 * a + 2 * Math.sin(5 * b)) * Math.sin(8 * b);

function leaf(number) {
  const angle = 2.4 * number;
  const [length, lift] = [0.45 + 0.25 * chance(number), 0.5 + 0.6 * chance(number, 1)];
  const pointAt = (u, v) => {
    const [side, out] = [(v - 0.5) * 0.2 * Math.sin(Math.PI * (0.05 + 0.95 * u)), length * u];
    const z = 0.62 + lift * Math.sin(1.9 * u) * 0.8 + 0.35 * Math.abs(side) + 0.01 * Math.cos(20 * u);
    return [0.75 + out * Math.cos(angle) - side * Math.sin(angle), 3.9 + out * Math.sin(angle) + side * Math.cos(angle), z];
  };
  return surface(16, 6, pointAt);
}

const POT = interpolate([[0, 0.01], [0.2, 0.02], [0.27, 0.25], [0.3, 0.52], [0.31, 0.6], [0.27, 0.6], [0.25, 0.5], [0, 0.5]]);
const VASE = interpolate([[0, 0.42], [0.09, 0.43], [0.15, 0.55], [0.16, 0.65], [0.08, 0.78], [0.055, 0.86], [0.08, 0.92], [0.06, 0.92], [0.04, 0.8]]);
const LAMP = interpolate([[0, 2.45], [0.02, 2.42], [0.05, 2.3], [0.3, 2.1], [0.34, 2.02], [0.33, 2.02], [0.28, 2.1], [0.04, 2.28]]);

/** Shape, colour of a place (sRGB, before light), light there, and what the surface is like. */
function pieces() {
  const cloth = { roughness: 0.95, metalness: 0 };
  const sofa = (x, y, z) => mix([42, 86, 110], [52, 104, 128], 0.5 + 0.5 * Math.sin(90 * x) * Math.sin(90 * y + 40 * z));
  const seat = (x, y) => -0.03 * (1 - x * x) * (1 - y * y) + 0.004 * Math.sin(25 * x) * Math.sin(20 * y);
  const all = [
    { shape: surface(64, 64, (u, v) => [SIZE * v, 1.01 * SIZE * u, groove(SIZE * v)]), color: plank, light: ([x, y]) => floorLight(x, y), roughness: 0.45, metalness: 0 },
    { shape: surface(24, 40, (u, v) => [0.01 + plaster(5 * v, 3 * u), SIZE * v, HEIGHT * u - 0.02]), color: () => [214, 206, 194], light: ([, y, z]) => wallLight(z, SIZE - y), ...cloth },
    { shape: surface(24, 40, (u, v) => [SIZE * v, SIZE - 0.01 + plaster(5 * v, 3 * u), HEIGHT * u - 0.02]), color: () => [172, 104, 80], light: ([x, , z]) => wallLight(z, x), ...cloth },
    {
      shape: surface(48, 72, (u, v) => [1.1 + 2.9 * v, 1.2 + 2.1 * u, 0.018 + 0.006 * Math.sin(40 * v) * Math.sin(30 * u)]),
      color: ([x, y]) => (Math.abs(((2.4 * x) % 1) - 0.5) < 0.13 || Math.abs(y - 2.25) > 0.95 ? [158, 62, 52] : [218, 202, 172]),
      light: ([x, y]) => floorLight(x, y),
      ...cloth,
    },
  ];
  const soft = [
    cushion(28, 44, [2.6, 4.2, 0.28], [1.12, 0.46, 0.2], seat), cushion(28, 44, [2.6, 4.58, 0.62], [1.1, 0.16, 0.36]),
    cushion(24, 32, [1.46, 4.2, 0.4], [0.15, 0.48, 0.28]), cushion(24, 32, [3.74, 4.2, 0.4], [0.15, 0.48, 0.28]),
  ];
  for (const shape of soft) all.push({ shape, color: ([x, y, z]) => sofa(x, y, z), light: standingLight, ...cloth });
  for (const [x, color] of [[1.95, [222, 168, 62]], [3.2, [206, 92, 70]]])
    all.push({ shape: cushion(24, 32, [x, 4.32, 0.68], [0.24, 0.11, 0.23]), color: () => color, light: () => 0.95, ...cloth });
  all.push({ shape: cushion(24, 60, [2.5, 2.3, 0.38], [0.62, 0.38, 0.035]), color: ([x, y]) => mix([96, 58, 36], [128, 82, 52], 0.5 + 0.5 * Math.sin(60 * y + 3 * Math.sin(4 * x))), light: () => 1, roughness: 0.3, metalness: 0 });
  for (const x of [2.05, 2.95]) for (const y of [2.05, 2.55])
    all.push({ shape: turned(6, 16, [x, y], (t) => [0.022 + 0.012 * t, 0.36 * t]), color: () => [60, 60, 62], light: standingLight, roughness: 0.35, metalness: 1 });
  all.push({ shape: turned(48, 72, [2.35, 2.3], VASE, (t, angle) => 0.006 * Math.cos(12 * angle + 20 * t)), color: () => [46, 110, 112], light: () => 1, roughness: 0.15, metalness: 0 });
  all.push({ shape: turned(32, 40, [0.75, 3.9], POT), color: () => [188, 104, 70], light: standingLight, roughness: 0.8, metalness: 0 });
  for (let i = 0; i < 15; ++i) all.push({ shape: leaf(i), color: () => mix([44, 92, 48], [84, 142, 66], chance(i, 2)), light: ([, , z]) => 0.6 + 0.4 * smooth(0.6, 1.3, z), roughness: 0.6, metalness: 0, hasTwoSides: true });
  all.push({ shape: turned(24, 40, [2.5, 2.3], LAMP), color: () => [236, 226, 204], light: () => 1, roughness: 0.5, metalness: 0 });
  all.push({ shape: cushion(20, 32, [4.2, 1.5, 0.35], [0.38, 0.38, 0.35]), color: () => [228, 226, 222], light: standingLight, roughness: 0.9, metalness: 0 });
  const art = knot(240, 30);
  for (let i = 0; i < art.positions.length; i += 3) {
    const [x, y, z] = placeAt(art.positions, i);
    art.positions.set([4.2 + 0.145 * x, 1.5 + 0.145 * z, 1.24 - 0.145 * y], i);
  }
  all.push({ shape: art, color: () => [214, 168, 84], light: () => 1, roughness: 0.28, metalness: 1 });
  return all;
}

function colored({ shape: { positions, indices }, color, light }) {
  const values = new Uint8Array(positions.length);
  for (let i = 0; i < positions.length; i += 3) {
    const place = placeAt(positions, i);
    const shade = light(place) ** (1 / 2.2);
    values.set(color(place).map((value) => Math.round(value * shade)), i);
  }
  return { positions, indices, groups: null, attributes: [{ kind: 'color', name: 'color', components: 3, normalized: true, values }] };
}

/** Pieces of one material are one group. */
export function room() {
  const all = pieces();
  const described = all.map(({ roughness, metalness, hasTwoSides = false }) => JSON.stringify({ roughness, metalness, hasTwoSides }));
  const materials = [...new Set(described)];
  const { groups, ...mesh } = joinMeshes(all.map(colored));
  const numbers = described.map((material) => materials.indexOf(material));
  return { ...mesh, groups: groups.map((piece) => numbers[piece]), materials: materials.map((material) => JSON.parse(material)) };
}
