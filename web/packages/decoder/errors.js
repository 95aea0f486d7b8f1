// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What is wrong, as a value. See decoder.d.ts.

/** Numbers of codec/include/deltamesh/result.h, and 3xx, which are these packages'. */
export const CODES = { corrupt: 103, invalidArgument: 200, noFile: 300, invalidAsset: 304, outOfMemory: 900, internal: 901 };

export class DeltameshError extends Error {
  constructor({ code, what, rule = '', where = null, chunk = '', source = '' }, options) {
    super(
      (source && `${source}: `) +
        what +
        (where ? `, ${where.unit} ${where.position}` : '') +
        (chunk && `, chunk ${chunk}`) +
        (rule && ` [${rule}]`),
      options,
    );
    Object.assign(this, { name: 'DeltameshError', code, what, rule, where, chunk, source });
  }
}

/** What an error is made from again, on the other side of a message. */
export function plainError({ code, what, rule, where, chunk, source }) {
  return { code, what, rule, where, chunk, source };
}

/** The same error in `source`: a file, a part of it. Errors of other kinds stay as they are. */
export function errorIn(source, error) {
  if (!(error instanceof DeltameshError)) return error;
  const both = [source, error.source].filter(Boolean).join(': ');
  return new DeltameshError({ ...plainError(error), source: both }, { cause: error.cause });
}
