const { readFileSync } = require('node:fs');

const { createDecoder } = require('@deltamesh/decoder');
const { DecoderPool } = require('@deltamesh/decoder/pool');

const bytes = readFileSync(`${__dirname}/stream.dmsh`);
Promise.all([createDecoder().then((decoder) => decoder.decode(bytes)), new DecoderPool().decode(bytes)]).then(([here, there]) =>
  console.log(`${here.vertexCount} ${there.vertexCount}`),
);
