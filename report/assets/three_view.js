// Loads three.js and opens its renderer in an element.
async function clastOpenRenderer(view, options = {}) {
  await clastRun('three-code');
  await clastRun('orbit-code');
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({antialias: true, ...options});
  } catch {
    throw new Error('This browser draws no 3-D graphics (WebGL is off).');
  }
  view.append(renderer.domElement);
  return renderer;
}
