import { draw } from './draw.js';

const canvas = document.body.appendChild(document.createElement('canvas'));
draw(canvas).then(
  () => (document.title = 'drawn'),
  (error) => (document.title = `failed: ${error.stack}`),
);
