'use client';
import { useEffect, useRef } from 'react';

import { draw } from '../draw.js';

export default function Page() {
  const canvas = useRef(null);
  useEffect(() => {
    draw(canvas.current).then(
      () => (document.title = 'drawn'),
      (error) => (document.title = `failed: ${error.stack}`),
    );
  }, []);
  return <canvas ref={canvas} />;
}
