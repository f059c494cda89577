// Drawing starts when the view is first seen, so that the page opens at once. `clastScene` is there
// for the console and for tests.
const clastScene = (() => {
  const box = document.getElementById('scene');
  const view = box.querySelector('.view');
  const part = (name) => box.querySelector(`[data-scene=${name}]`);
  const bodies = [], paths = {}, hidden = {};
  let data, renderer, scene, camera, controls;
  let time = 0, scale = 1, playing = false, wanted = false, lastTick = 0;
  let from, to, place, size, matrix;  // reused for every block of every frame

  const numbers = (type, base64) => new type(clastBytes(base64).buffer);

  function geometry(mesh) {
    const made = new THREE.BufferGeometry();
    made.setAttribute(
        'position', new THREE.BufferAttribute(numbers(Float32Array, mesh.vertices), 3));
    made.setIndex(new THREE.BufferAttribute(numbers(Uint32Array, mesh.triangles), 1));
    return made;
  }

  // Flat faces: every triangle gets corners, a normal and the tint of its zone to itself.
  function ground() {
    const made = geometry(data.terrain).toNonIndexed();
    const zones = numbers(Uint16Array, data.terrain.zones);
    const colours = new Float32Array(9 * zones.length);
    const tints = data.tints.map((tint) => new THREE.Color(tint));
    zones.forEach((zone, t) => {
      for (let k = 0; k < 3; k++) (tints[zone] || tints[0]).toArray(colours, 9 * t + 3 * k);
    });
    made.setAttribute('color', new THREE.BufferAttribute(colours, 3));
    made.computeVertexNormals();
    return new THREE.Mesh(made, new THREE.MeshLambertMaterial(
        {vertexColors: THREE.VertexColors, side: THREE.DoubleSide}));
  }

  // Upright walls as lines: down and up at each corner, and back along the foot.
  function addBarriers() {
    const {min, max} = new THREE.Box3().setFromObject(scene);
    for (const {name, through} of data.barriers) {
      const points = [];
      const add = ([x, y], z) => points.push(new THREE.Vector3(x, y, z));
      through.forEach((corner, i) => {
        for (const z of [max.z, min.z, max.z]) add(corner, z);
        if (i + 1 < through.length) add(through[i + 1], max.z);
      });
      for (const corner of through.slice().reverse()) add(corner, min.z);
      const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(points),
          new THREE.LineBasicMaterial({color: 0xaa3377}));
      line.name = name;
      scene.add(line);
    }
  }

  function addBlocks() {
    data.bodies.forEach((body, number) => {
      const runs = data.runs.filter((run) => run.body === number);
      if (!runs.length) return;
      const made = geometry(body).toNonIndexed();
      made.computeVertexNormals();
      const mesh = new THREE.InstancedMesh(
          made, new THREE.MeshLambertMaterial({color: body.colour}), runs.length);
      mesh.frustumCulled = false;
      scene.add(mesh);
      bodies.push({runs, mesh, group: body.group});
    });
  }

  function addPaths() {
    const groups = {};
    for (const run of data.runs) {
      const {group, colour} = data.bodies[run.body];
      const {points} = groups[group] = groups[group] || {colour, points: []};
      for (let k = run.first; k + 1 < run.first + run.count; k++) {
        for (const f of [8 * k, 8 * k + 8]) points.push(...data.frames.subarray(f + 1, f + 4));
      }
    }
    for (const [group, {colour, points}] of Object.entries(groups)) {
      const made = new THREE.BufferGeometry();
      made.setAttribute('position', new THREE.BufferAttribute(new Float32Array(points), 3));
      paths[group] = new THREE.LineSegments(
          made, new THREE.LineBasicMaterial({color: colour, transparent: true, opacity: .35}));
      scene.add(paths[group]);
    }
  }

  // The last stored state before `time`, by halving; then a straight way and an even turn.
  function setState(run) {
    const f = data.frames;
    let low = run.first, high = run.first + run.count - 1;
    if (f[8 * low] >= time) high = low;
    else if (f[8 * high] <= time) low = high;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (f[8 * middle] <= time) low = middle;
      else high = middle;
    }
    const a = 8 * low, b = 8 * high;
    const share = high > low ? (time - f[a]) / (f[b] - f[a]) : 0;
    const between = (k) => f[a + k] + share * (f[b + k] - f[a + k]);
    place.set(between(1), between(2), between(3));
    from.set(f[a + 5], f[a + 6], f[a + 7], f[a + 4]);
    to.set(f[b + 5], f[b + 6], f[b + 7], f[b + 4]);
    from.slerp(to, share);
  }

  function draw() {
    size.setScalar(scale);
    for (const {runs, mesh, group} of bodies) {
      mesh.visible = !hidden[group];
      runs.forEach((run, i) => {
        setState(run);
        mesh.setMatrixAt(i, matrix.compose(place, from, size));
      });
      mesh.instanceMatrix.needsUpdate = true;
    }
    for (const group of Object.keys(paths)) {
      paths[group].visible = part('paths').checked && !hidden[group];
    }
    renderer.render(scene, camera);
    setState(data.runs[0]);
    box.dataset.first = place.toArray().map((x) => x.toFixed(3)).join(' ');
    box.dataset.triangles = renderer.info.render.triangles;
  }
  function drawSoon() {
    if (wanted) return;
    wanted = true;
    requestAnimationFrame(() => {
      wanted = false;
      draw();
    });
  }
  function seek(t) {
    time = Math.max(0, Math.min(t, data.duration));
    part('time').value = 1000 * time / (data.duration || 1);
    part('clock').textContent = time.toFixed(1) + ' s';
    drawSoon();
  }
  function tick(now) {
    if (!playing) return;
    seek(time + Math.min(.1, (now - lastTick) / 1000));
    lastTick = now;
    if (time >= data.duration) play(false);
    else requestAnimationFrame(tick);
  }
  function play(on) {
    playing = on;
    part('play').textContent = on ? 'Pause' : 'Play';
    if (!on) return;
    if (time >= data.duration) seek(0);
    lastTick = performance.now();
    requestAnimationFrame(tick);
  }

  function fit() {
    const width = view.clientWidth, height = Math.max(320, Math.round(.56 * width));
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    drawSoon();
  }
  function fillScene() {
    scene = new THREE.Scene();
    scene.background = new THREE.Color(0xeef3f7);
    scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8f96, .75));
    const sun = new THREE.DirectionalLight(0xffffff, .55);
    sun.position.set(-1, 1, 1.4);
    scene.add(sun);
    scene.add(ground());
    addBarriers();
    addBlocks();
    addPaths();
  }
  // Looks at the middle of all paths from the south and above.
  function placeCamera() {
    camera = new THREE.PerspectiveCamera(40, 1, .05, 1e5);
    camera.up.set(0, 0, 1);
    const ways = new THREE.Box3();
    for (const run of data.runs) {
      for (let k = run.first; k < run.first + run.count; k++) {
        ways.expandByPoint(place.fromArray(data.frames, 8 * k + 1));
      }
    }
    const middle = ways.getCenter(new THREE.Vector3());
    const reach = Math.max(5, ways.getSize(size).length());
    camera.position.set(middle.x + .25 * reach, middle.y - 1.15 * reach, middle.z + .75 * reach);
    controls = new THREE.OrbitControls(camera, renderer.domElement);
    controls.target.copy(middle);
    controls.update();
    controls.addEventListener('change', drawSoon);
  }
  function listen() {
    part('time').addEventListener('input', (event) => {
      play(false);
      seek(event.target.value * data.duration / 1000);
    });
    part('play').addEventListener('click', () => play(!playing));
    part('paths').addEventListener('change', drawSoon);
    part('size').addEventListener('change', (event) => {
      scale = +event.target.value;
      drawSoon();
    });
    for (const key of box.querySelectorAll('[data-group]')) {
      key.addEventListener('change', () => {
        hidden[key.dataset.group] = !key.checked;
        drawSoon();
      });
    }
    addEventListener('resize', fit);
  }

  async function open() {
    renderer = await clastOpenRenderer(view);
    data = JSON.parse(await clastUnpacked('scene-data'));
    data.frames = numbers(Float32Array, data.frames);
    [from, to] = [new THREE.Quaternion(), new THREE.Quaternion()];
    [place, size, matrix] = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Matrix4()];
    fillScene();
    placeCamera();
    listen();
    fit();
    seek(0);
    box.dataset.runs = data.runs.length;
  }
  // Paper has the view as it stands, as a picture.
  function picture() {
    draw();
    const image = new Image();
    image.className = 'paper';
    image.src = renderer.domElement.toDataURL();
    view.append(image);
  }
  addEventListener('beforeprint', () => {
    if (box.dataset.runs) picture();
  });
  addEventListener('afterprint', () => view.querySelectorAll('.paper').forEach((image) => image.remove()));
  let opened;
  const start = () => opened = opened || open().catch((error) => view.textContent = error.message);

  new IntersectionObserver((entries, watcher) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    watcher.disconnect();
    start();
  }, {rootMargin: '200px'}).observe(box);
  if (location.hash === '#print') start();  // by a browser that prints without looking
  return {start, seek, draw};
})();
