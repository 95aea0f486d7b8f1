// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Where the matrix builds: its tools from the registry, and the packages as npm packs them.
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('./', import.meta.url));
const root = join(here, '../../..');
export const apps = join(here, 'apps');
export const work = join(root, 'build/web/matrix');

/** What the apps draw: a packed asset, and a stream that takes two modules beside the core. */
const SOURCES = {
  'asset.glb': 'gltf_ext/DELTAMESH_mesh_compression/samples/valid/cube.glb',
  'stream.dmsh': () => join('tests/golden', readdirSync(join(root, 'tests/golden')).find((name) => /^attributes\.compact\..*\.dmsh$/.test(name))),
};
export const streams = Object.keys(SOURCES);
const read = (name) => readFileSync(join(root, typeof SOURCES[name] === 'string' ? SOURCES[name] : SOURCES[name]()));

function installTools() {
  const lock = readFileSync(join(here, 'package-lock.json'));
  const known = join(work, 'node_modules/.matrix-lock.json');
  if (existsSync(known) && readFileSync(known).equals(lock)) return;
  for (const name of ['package.json', 'package-lock.json']) cpSync(join(here, name), join(work, name));
  execFileSync('npm', ['ci', '--no-audit', '--no-fund', '--silent'], { cwd: work, stdio: 'inherit' });
  writeFileSync(known, lock);
}

function installPackages() {
  const packed = join(work, 'packed');
  rmSync(packed, { recursive: true, force: true });
  mkdirSync(packed);
  for (const name of ['decoder', 'encoder', 'three', 'babylon', 'gltf-transform']) {
    const folder = join(root, 'web/packages', name);
    const [{ filename }] = JSON.parse(execFileSync('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', packed], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
    const place = join(work, 'node_modules/@deltamesh', name);
    rmSync(place, { recursive: true, force: true });
    mkdirSync(place, { recursive: true });
    execFileSync('tar', ['-xzf', join(packed, filename), '-C', place, '--strip-components=1']);
  }
}

export function prepare() {
  mkdirSync(work, { recursive: true });
  installTools();
  installPackages();
}

/** A folder with the app, nothing built. */
export function fresh(name) {
  const folder = join(work, name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (const file of readdirSync(apps).filter((file) => file !== 'next')) cpSync(join(apps, file), join(folder, file));
  for (const file of streams) writeFileSync(join(folder, file), read(file));
  return folder;
}
