// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Assets as they are, packed, and unpacked again, by the native program: generated ones, and those of a corpus where there is one.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const folder = join(root, 'build/web/pixels');
const program = join(root, 'build/release/deltamesh');
const corpus = process.env.DELTAMESH_CORPUS ?? join(root, '../shared/corpus');

export const hasProgram = existsSync(program);
export const hasCorpus = existsSync(corpus);

/** Scenes that `deltamesh generate` makes. */
const SCENES = ['rooms', 'terrain', 'sphere', 'cad'];

function run(...args) {
  execFileSync(program, args, { stdio: ['ignore', 'ignore', 'inherit'] });
}

function* sources() {
  for (const scene of SCENES) {
    const path = join(folder, `generated.${scene}.glb`);
    run('generate', scene, path, '--vertices', '5000');
    yield path;
  }
  for (const part of ['gltf', 'formats'].map((name) => join(corpus, name)).filter(existsSync))
    yield* readdirSync(part).filter((name) => name.endsWith('.glb')).map((name) => join(part, name));
}

/** { name, packed, plain }: bytes. */
export function* assets() {
  mkdirSync(folder, { recursive: true });
  for (const source of sources()) {
    const name = basename(source);
    const [packed, plain] = ['packed', 'plain'].map((kind) => join(folder, `${kind}.${name}`));
    run('gltf', 'pack', source, packed);
    run('gltf', 'unpack', packed, plain);
    yield { name, packed: readFileSync(packed), plain: readFileSync(plain) };
  }
}
