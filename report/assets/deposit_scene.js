// The points of a deposit in 3-D in the colours of their blocks. Drawing starts when the view is
// first seen. `pick` is called with the index of a point that was clicked.
function clastDepositScene(view, cloud, colourOf, pick) {
  let renderer, scene, camera, controls, cloudOfPoints, wanted = false;

  function draw() {
    renderer.render(scene, camera);
    view.dataset.points = renderer.info.render.points;
  }
  function drawSoon() {
    if (wanted || !renderer) return;
    wanted = true;
    requestAnimationFrame(() => {
      wanted = false;
      draw();
    });
  }
  function fit() {
    const width = view.clientWidth, height = view.clientHeight;
    if (!width || !height) return;
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    drawSoon();
  }
  function colour() {
    if (!cloudOfPoints) return;
    const tints = cloudOfPoints.geometry.getAttribute('color');
    for (let i = 0; i < cloud.count; i++) {
      const [r, g, b] = colourOf(i), shade = cloud.shades[i] / 65025;
      tints.setXYZ(i, r * shade, g * shade, b * shade);
    }
    tints.needsUpdate = true;
    drawSoon();
  }
  function makeCloud() {
    const places = Float32Array.from(cloud.places, (step) => step * cloud.step);
    const made = new THREE.BufferGeometry();
    made.setAttribute('position', new THREE.BufferAttribute(places, 3));
    made.setAttribute('color', new THREE.BufferAttribute(new Float32Array(3 * cloud.count), 3));
    made.computeBoundingBox();
    const size = made.boundingBox.getSize(new THREE.Vector3());
    const spacing = Math.sqrt(size.x * size.y / cloud.count);
    const points = new THREE.Points(made, new THREE.PointsMaterial(
        {size: 3 * spacing, vertexColors: THREE.VertexColors}));
    points.userData = {spacing, box: made.boundingBox};
    return points;
  }
  function look(target, distance) {
    camera.position.set(target.x - .1 * distance, target.y - .75 * distance, target.z + .65 * distance);
    controls.target.copy(target);
    controls.update();
  }
  function listen() {
    let start;
    const canvas = renderer.domElement;
    canvas.addEventListener('pointerdown', (event) => { start = [event.clientX, event.clientY]; });
    canvas.addEventListener('pointerup', (event) => {
      if (!start || Math.hypot(event.clientX - start[0], event.clientY - start[1]) > 4) return;
      const box = canvas.getBoundingClientRect(), ray = new THREE.Raycaster();
      ray.params.Points = {threshold: cloudOfPoints.userData.spacing};
      ray.setFromCamera({x: 2 * (event.clientX - box.left) / box.width - 1,
                         y: 1 - 2 * (event.clientY - box.top) / box.height}, camera);
      const hit = ray.intersectObject(cloudOfPoints)[0];
      if (hit) pick(hit.index, event);
    });
    addEventListener('resize', fit);
  }
  async function open() {
    renderer = await clastOpenRenderer(view, {preserveDrawingBuffer: true});
    scene = new THREE.Scene();
    scene.background = new THREE.Color(0xeef3f7);
    cloudOfPoints = makeCloud();
    scene.add(cloudOfPoints);
    const {box} = cloudOfPoints.userData, size = box.getSize(new THREE.Vector3()).length();
    camera = new THREE.PerspectiveCamera(40, 1, size / 2000, 20 * size);
    camera.up.set(0, 0, 1);
    controls = new THREE.OrbitControls(camera, renderer.domElement);
    look(box.getCenter(new THREE.Vector3()), 1.05 * size);
    controls.addEventListener('change', drawSoon);
    listen();
    colour();
    fit();
    draw();
  }
  let opened;
  const start = () => opened = opened || open().catch((error) => {
    view.textContent = error.message;
  });
  new IntersectionObserver((entries, watcher) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    watcher.disconnect();
    start();
  }, {rootMargin: '200px'}).observe(view);

  return {
    start,
    colour,
    // Looks at a place from a distance, both in m.
    lookAt(place, distance) {
      if (!camera) return;
      look(new THREE.Vector3(...place.map((x, k) => x - cloud.origin[k])), distance);
      drawSoon();
    },
    // Position of a place in the view, px; for tests.
    pixelOf(place) {
      const seen = new THREE.Vector3(...place.map((x, k) => x - cloud.origin[k])).project(camera);
      return [(seen.x + 1) / 2 * view.clientWidth, (1 - seen.y) / 2 * view.clientHeight];
    },
  };
}
