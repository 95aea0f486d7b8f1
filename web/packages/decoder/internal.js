// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the other packages share with this one, and nobody else.
export { CODES, DeltameshError, plainError } from './errors.js';
export { Instance, settle } from './instance.js';
export { compileGiven, compileOwn } from './modules.js';
export { ARRAYS, KINDS, readError } from './outcome.js';
export { listen, post } from './port.js';
export { hasWorkers, startWorker, workerError } from './start-worker.js';
