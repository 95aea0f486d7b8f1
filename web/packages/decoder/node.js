// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What node, Deno and Bun have and browsers do not. Nothing of it is imported by name: bundlers for browsers would look for it.

const builtin = (name) => globalThis.process?.getBuiltinModule?.(`node:${name}`);

/** A file's bytes; undefined where there are no files. */
export const readLocalFile = (url) => builtin('fs')?.promises.readFile(url);

/** node:worker_threads, or undefined. */
export const threads = () => builtin('worker_threads');
