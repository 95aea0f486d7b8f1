// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Encodes and compares meshes by the module, wherever that comes from.
import { ARRAYS, CODES, DeltameshError, Instance, KINDS, readError, settle } from '@deltamesh/decoder/internal.js';

const UNITS = ['model', 'diagonal', 'paper'];
const GEOMETRIES = ['auto', 'highpass', 'predictive'];
const PROFILES = ['smallest', 'zstd'];

/** As OptionsCall in encoder_call.h, but for bounds and names. */
const NUMBERS = [
  ['targetBytes', NaN],
  ['geometry', 'auto', GEOMETRIES],
  ['lossless', false],
  ['effort', 1],
  ['bits', NaN],
  ['step', NaN],
  ['anchors', NaN],
  ['anchorDensity', NaN],
  ['anchorBits', 12],
  ['normalError', NaN],
  ['tangentError', NaN],
  ['uvError', NaN],
  ['colorError', NaN],
  ['colorRms', NaN],
  ['weightError', NaN],
  ['profile', 'smallest', PROFILES],
  ['keepOrder', false],
  ['keepUnreferenced', false],
];

function invalid(what) {
  throw new DeltameshError({ code: CODES.invalidArgument, what });
}

function indexIn(names, name, what) {
  const index = names.indexOf(name);
  return index >= 0 ? index : invalid(`no such ${what}: ${name}`);
}

function boundNumbers(bound) {
  if (bound === undefined) return [NaN, 0];
  if (typeof bound === 'number') return [bound, 0];
  return [bound.value, indexIn(UNITS, bound.unit ?? 'model', 'unit')];
}

function optionNumbers(options) {
  const bounds = [options.vde, options.lfe, options.maxError].flatMap(boundNumbers);
  const others = NUMBERS.map(([name, usual, names]) => {
    const value = options[name] ?? usual;
    return names ? indexIn(names, value, name) : Number(value);
  });
  return [...bounds, ...others];
}

/** What a call hands over, released when it is over. */
class Arguments {
  #instance;
  #addresses = [];

  constructor(instance) {
    this.#instance = instance;
  }

  put(array) {
    const address = this.#instance.put(new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
    this.#addresses.push(address);
    return address;
  }

  text(text) {
    const bytes = new TextEncoder().encode(text);
    return [this.put(bytes), bytes.length];
  }

  /** As AttributeCall. */
  attribute({ name = '', kind, components, normalized = false, linear = false, values }) {
    const type = ARRAYS.findIndex((Array) => values instanceof Array);
    if (type < 0) invalid(`attribute ${name}: values of a type that attributes do not have`);
    return [
      ...this.text(name),
      indexIn(KINDS, kind, 'kind of attribute'),
      type,
      components,
      (normalized ? 1 : 0) | (linear ? 2 : 0),
      this.put(values),
      values.byteLength,
    ];
  }

  /** As MeshCall. */
  mesh({ origin = [0, 0, 0], positions, indices, groups, attributes = [] }) {
    if (!(positions instanceof Float32Array)) invalid('positions must be a Float32Array');
    if (!(indices instanceof Uint32Array)) invalid('indices must be a Uint32Array');
    if (groups && groups.length * 3 !== indices.length) invalid('groups must have one number for each triangle');
    const call = new Uint8Array(56);
    new Float64Array(call.buffer, 0, 3).set(origin);
    new Uint32Array(call.buffer, 24).set([
      this.put(positions),
      positions.length / 3,
      this.put(indices),
      indices.length / 3,
      groups ? this.put(Uint32Array.from(groups)) : 0,
      this.put(new Uint32Array(attributes.flatMap((attribute) => this.attribute(attribute)))),
      attributes.length,
    ]);
    return this.put(call);
  }

  /** As OptionsCall. */
  options(options) {
    const bounds = (errors, isMean) => Object.entries(errors ?? {}).map(([name, error]) => ({ name, error, isMean }));
    const named = [...bounds(options.attributeErrors, 0), ...bounds(options.attributeRms, 1)];
    const names = new Uint8Array(24 * named.length);
    named.forEach(({ name, error, isMean }, i) => {
      new Float64Array(names.buffer, 24 * i, 2).set([error, isMean]);
      new Uint32Array(names.buffer, 24 * i + 16, 2).set(this.text(name));
    });
    const numbers = new Float64Array([...optionNumbers(options), 0]);
    new Uint32Array(numbers.buffer).set([this.put(names), named.length], 2 * (numbers.length - 1));
    return this.put(numbers);
  }

  release() {
    for (const address of this.#addresses) this.#instance.calls.release(address);
  }
}

/** As EncodeOutcome. */
function readEncoded(instance, address) {
  const [bytes, byteCount, order, orderCount] = instance.words(address + 48, 4);
  return {
    bytes: new Uint8Array(instance.bytes(bytes, byteCount)),
    order: new Uint32Array(instance.bytes(order, 4 * orderCount)),
  };
}

/** As CompareOutcome. */
function readComparison(instance, address) {
  const [vde, lfe, maxError, surfaceRms, surfaceMax, normalAngleMean, normalAngleP95, diagonal] = instance.doubles(address + 32, 8);
  const [corresponding, signedError, count] = instance.words(address + 96, 3);
  return {
    corresponding: corresponding !== 0,
    quality: { vde, lfe, maxError },
    surfaceRms,
    surfaceMax,
    normalAngleMean,
    normalAngleP95,
    diagonal,
    signedError: new Float32Array(instance.bytes(signedError, 4 * count)),
  };
}

/** Of GltfReport, as PackOutcome has them. */
const COUNTS = [
  'primitives', 'converted', 'streams', 'notTriangles', 'notFloatPositions', 'otherwiseCompressed', 'notSmaller', 'vertices', 'triangles',
  'unreferencedVertices', 'degenerateTriangles', 'droppedLengths', 'weldedVertices', 'streamBytes', 'inputBytes', 'outputBytes',
  'animationBytes', 'imageBytes',
];

/** As PackOutcome. */
function readPacked(instance, address) {
  const [maxError, maxErrorPercent] = instance.doubles(address + 176, 2);
  const [bytes, byteCount, attributes, attributeCount] = instance.words(address + 192, 4);
  const counts = [...instance.doubles(address + 32, COUNTS.length)];
  return {
    bytes: new Uint8Array(instance.bytes(bytes, byteCount)),
    report: {
      ...Object.fromEntries(COUNTS.map((name, i) => [name, counts[i]])),
      maxError,
      maxErrorPercent,
      attributes: Array.from({ length: attributeCount }, (_, i) => readPackedAttribute(instance, attributes + 32 * i)),
    },
  };
}

function readPackedAttribute(instance, address) {
  const [bytes, error] = instance.doubles(address, 2);
  const [semantic, semanticBytes, kind, morph] = instance.words(address + 16, 4);
  return { semantic: instance.text(semantic, semanticBytes), morph: morph !== 0, kind: KINDS[kind], bytes, error };
}

/** `module`: compiled. */
export class Encoder {
  #module;
  #maximum;
  #instance;
  #progress;

  constructor(module, maxMemory) {
    this.#module = module;
    this.#maximum = maxMemory;
  }

  encode(mesh, options = {}) {
    this.#progress = options.onProgress;
    return this.#call(
      (calls, given) => calls.encode(given.mesh(mesh), given.options(options)),
      readEncoded,
      (instance, outcome, error) => {
        const [value, bytes] = instance.doubles(outcome + 32, 2);
        return Object.assign(error, bytes > 0 || value > 0 ? { best: { value, bytes } } : {});
      },
    );
  }

  packGltf(asset, { fallback = false, ...options } = {}) {
    this.#progress = options.onProgress;
    return this.#call(
      (calls, given) => calls.pack(given.put(asset), asset.byteLength, given.options(options), fallback ? 1 : 0),
      readPacked,
      (instance, outcome, error) => error,
    );
  }

  compare(a, b, order = new Uint32Array()) {
    return this.#call(
      (calls, given) => calls.compare(given.mesh(a), given.mesh(b), given.put(order), order.length),
      readComparison,
      (instance, outcome, error) => error,
    );
  }

  #call(call, read, explain) {
    return settle(
      () => {
        const progress = (share) => this.#progress?.(share);
        const instance = (this.#instance ??= new Instance(this.#module, this.#maximum, { env: { progress } }));
        const given = new Arguments(instance);
        const outcome = call(instance.calls, given);
        const error = readError(instance, outcome);
        const result = error ? explain(instance, outcome, error) : read(instance, outcome);
        given.release();
        instance.calls.forget();
        if (instance.isLarge) this.release();
        return result;
      },
      () => this.release(),
    );
  }

  release() {
    this.#instance = undefined;
  }
}
