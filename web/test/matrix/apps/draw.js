// The app of every bundler: a packed asset and a stream, drawn by three.js.
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { DirectionalLight, Mesh, MeshStandardMaterial, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

export async function draw(canvas) {
  const streams = new DeltameshLoader();
  const { scene: asset } = await new GLTFLoader().register(gltfDeltameshExtension(streams)).loadAsync('asset.glb');
  const geometry = (await streams.loadAsync('stream.dmsh')).center();
  geometry.computeVertexNormals();
  geometry.computeBoundingSphere();
  geometry.scale(...Array(3).fill(1 / geometry.boundingSphere.radius)).translate(2, 0, 0);
  const scene = new Scene().add(asset, new Mesh(geometry, new MeshStandardMaterial()));
  const sun = new DirectionalLight(0xffffff, 3);
  sun.position.set(1, 2, 3);
  const camera = new PerspectiveCamera(50, 2);
  camera.position.set(1, 1, 5);
  const renderer = new WebGLRenderer({ canvas, preserveDrawingBuffer: true });
  renderer.setSize(400, 200, false);
  renderer.render(scene.add(sun), camera);
}
