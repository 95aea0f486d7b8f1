// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// node validate.mjs FOLDER: runs the Khronos glTF validator over every .glb and .gltf of the folder. Fails on an
// error, prints warnings; status 77 and the word "skipped" where the validator is not installed.
import {readFileSync, readdirSync} from 'node:fs';
import {join} from 'node:path';

let validator;
try {
  validator = (await import('gltf-validator')).default;
} catch {
  console.log('skipped: the package gltf-validator is not installed (scripts/setup does it)');
  process.exit(77);
}

const folder = process.argv[2];
const names = readdirSync(folder).filter((name) => /\.(glb|gltf)$/.test(name)).sort();
if (names.length === 0) {
  console.log(`no assets in ${folder}`);
  process.exit(1);
}

let failed = 0;
for (const name of names) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(join(folder, name))), {
    uri: name,
    maxIssues: 100,
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(folder, decodeURIComponent(uri)))),
  });
  const {numErrors, numWarnings, messages} = report.issues;
  console.log(`${numErrors === 0 ? 'ok    ' : 'FAILED'} ${name}: ${numErrors} errors, ${numWarnings} warnings`);
  const shown = messages.filter((message) => message.severity <= 1);
  for (const {code, message, pointer} of shown) console.log(`         ${code} ${pointer ?? ''}: ${message}`);
  if (numErrors > 0) ++failed;
}
process.exit(failed === 0 ? 0 : 1);
