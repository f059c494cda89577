// Blocks in 3-D. Drawing starts when a view is first seen. `clastTurntable(element)` is the view of
// an element: `show(id)` draws the block of a packed element, and is there for galleries and tests.
const clastTurntable = (() => {
  const rock = 0xd6cdbe, scanned = 0x8fa3b8, unobserved = 0xe88e28;

  const numbers = (type, base64) => new type(clastBytes(base64).buffer);

  function geometry(mesh) {
    const steps = numbers(Int16Array, mesh.vertices);
    const made = new THREE.BufferGeometry();
    made.setAttribute('position',
        new THREE.BufferAttribute(Float32Array.from(steps, (step) => step / 32767), 3));
    made.setIndex(new THREE.BufferAttribute(numbers(Uint32Array, mesh.triangles), 1));
    return made;
  }
  // Flat faces: every triangle gets corners and a normal to itself.
  function flat(mesh) {
    const made = geometry(mesh).toNonIndexed();
    made.computeVertexNormals();
    return made;
  }
  function smooth(mesh) {
    const made = geometry(mesh);
    made.computeVertexNormals();
    return mesh.unobserved || mesh.components ? made.toNonIndexed() : made;
  }

  // Sets the colour of each face: of its component, or orange if it was not observed.
  function tintFaces(mesh, colour) {
    const tint = new THREE.Color();
    if (mesh.components) {
      // Steps of the golden angle keep the hues of following components apart.
      return [numbers(Uint16Array, mesh.components),
              (component) => tint.setHSL(component * .618034 % 1, .4, .76)];
    }
    return [numbers(Uint8Array, mesh.unobserved), (face) => tint.set(face ? unobserved : colour)];
  }
  function tinted(mesh, made, colour, options = {}) {
    if (!mesh.unobserved && !mesh.components) return solid(made, {color: colour, ...options});
    const [faces, tintOf] = tintFaces(mesh, colour), tints = new Float32Array(9 * faces.length);
    faces.forEach((face, t) => {
      const tint = tintOf(face);
      for (let k = 0; k < 3; k++) tint.toArray(tints, 9 * t + 3 * k);
    });
    made.setAttribute('color', new THREE.BufferAttribute(tints, 3));
    return solid(made, {vertexColors: THREE.VertexColors, ...options});
  }

  // The triangles of the block cut into pieces, each corner in the colour of its distance.
  function coloured(data) {
    const {pieces, shares, colours} = data.deviation;
    const counts = numbers(Uint8Array, pieces), distances = numbers(Int8Array, shares);
    const scale = colours.map((colour) => new THREE.Color(colour));
    const corners = flat(data.block).getAttribute('position').array;
    const positions = [], tints = [], tint = new THREE.Color();
    let first = 0;
    counts.forEach((n, t) => {
      const at = (k) => new THREE.Vector3().fromArray(corners, 9 * t + 3 * k);
      const a = at(0), ab = at(1).sub(a), ac = at(2).sub(a);
      const add = (row, column) => {
        positions.push(...a.clone().addScaledVector(ab, (row - column) / n)
            .addScaledVector(ac, column / n).toArray());
        const share = distances[first + row * (row + 1) / 2 + column] / 127;
        const place = (share + 1) / 2 * (scale.length - 1);
        const below = Math.min(Math.floor(place), scale.length - 2);
        tints.push(...tint.copy(scale[below]).lerp(scale[below + 1], place - below).toArray());
      };
      for (let row = 0; row < n; row++) {
        for (let column = 0; column <= row; column++) {
          add(row, column), add(row + 1, column), add(row + 1, column + 1);
          if (column < row) add(row, column), add(row + 1, column + 1), add(row, column + 1);
        }
      }
      first += (n + 1) * (n + 2) / 2;
    });
    const made = new THREE.BufferGeometry();
    made.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
    made.setAttribute('color', new THREE.BufferAttribute(new Float32Array(tints), 3));
    made.computeVertexNormals();
    return made;
  }

  function solid(made, options) {
    return new THREE.Mesh(made, new THREE.MeshLambertMaterial(options));
  }

  // A text that always faces the reader.
  function label(text, height) {
    const sheet = document.createElement('canvas'), pen = sheet.getContext('2d');
    const font = '600 44px system-ui, Arial, sans-serif';
    pen.font = font;
    sheet.width = Math.ceil(pen.measureText(text).width) + 16;
    sheet.height = 60;
    pen.font = font;
    pen.lineWidth = 8;
    pen.strokeStyle = '#fff';
    pen.fillStyle = '#1d2733';
    pen.textBaseline = 'middle';
    pen.strokeText(text, 8, 30);
    pen.fillText(text, 8, 30);
    const texture = new THREE.CanvasTexture(sheet);
    texture.minFilter = THREE.LinearFilter;
    const sprite = new THREE.Sprite(
        new THREE.SpriteMaterial({map: texture, depthTest: false, transparent: true}));
    sprite.scale.set(height * sheet.width / sheet.height, height, 1);
    return sprite;
  }
  // The edges of the box, three of them named with their lengths.
  function boxOf(data) {
    const group = new THREE.Group(), {axes, lengths} = data.box;
    const centre = new THREE.Vector3(...data.box.centre).sub(new THREE.Vector3(...data.centre));
    const half = axes.map((axis, k) =>
        new THREE.Vector3(...axis).multiplyScalar(lengths[k] / 2 / data.size));
    const at = (...signs) => signs.reduce((sum, sign, k) => sum.addScaledVector(half[k], sign),
        centre.clone().divideScalar(data.size));
    const points = [];
    for (let k = 0; k < 3; k++) {
      for (const [s, t] of [[-1, -1], [-1, 1], [1, -1], [1, 1]]) {
        for (const end of [-1, 1]) {
          const signs = [s, t];
          signs.splice(k, 0, end);
          points.push(at(...signs));
        }
      }
      const side = [1, 1];
      side.splice(k, 0, 0);
      const name = label(`${'LIS'[k]} ${lengths[k].toPrecision(3)} ${data.unit}`, .1);
      name.position.copy(at(...side)).multiplyScalar(1.08);
      group.add(name);
    }
    group.add(new THREE.LineSegments(new THREE.BufferGeometry().setFromPoints(points),
        new THREE.LineBasicMaterial({color: 0x1d2733})));
    return group;
  }

  function view(element) {
    const frame = element.querySelector('.view');
    const part = (name) => element.querySelector(`[data-turn=${name}]`);
    let renderer, scene, camera, controls, data, shapes = {}, box, wanted = false;

    function draw() {
      renderer.render(scene, camera);
      element.dataset.triangles = renderer.info.render.triangles;
      element.dataset.eye = camera.position.toArray().map((x) => x.toFixed(3)).join(' ');
    }
    function drawSoon() {
      if (wanted) return;
      wanted = true;
      requestAnimationFrame(() => {
        wanted = false;
        draw();
      });
    }
    function fit() {
      const width = frame.clientWidth, height = Math.max(280, Math.round(.6 * width));
      if (!width) return;
      renderer.setSize(width, height);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      drawSoon();
    }

    // What is shown is made when it is first asked for.
    const makers = {
      block: () => tinted(data.block, (data.block.smooth ? smooth : flat)(data.block), rock),
      scan: () => tinted(data.scan, smooth(data.scan), scanned, {side: THREE.DoubleSide}),
      veil: () => tinted(data.scan, smooth(data.scan), scanned,
          {side: THREE.DoubleSide, transparent: true, opacity: .35, depthWrite: false}),
      deviation: () => solid(coloured(data),
          {vertexColors: THREE.VertexColors, side: THREE.DoubleSide}),
    };
    const needs = {block: ['block'], scan: ['scan'], both: ['block', 'veil'],
                   deviation: ['deviation']};
    function choose() {
      const names = needs[part('what').value];
      for (const name of names) {
        if (shapes[name]) continue;
        shapes[name] = makers[name]();
        scene.add(shapes[name]);
      }
      for (const [name, shape] of Object.entries(shapes)) shape.visible = names.includes(name);
      box.visible = part('box').checked;
      const deviates = part('what').value === 'deviation';
      part('distances').hidden = !deviates;
      part('unobserved').hidden = deviates || !data.block.unobserved && !data.scan?.unobserved;
      drawSoon();
    }
    function fillScene() {
      if (scene) scene.traverse((part) => part.geometry && part.geometry.dispose());
      scene = new THREE.Scene();
      scene.background = new THREE.Color(0xeef3f7);
      scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8f96, .62));
      const lamp = new THREE.DirectionalLight(0xffffff, .38);
      lamp.position.set(-.45, .55, .7);
      camera.add(lamp);
      scene.add(camera);
      shapes = {};
      box = boxOf(data);
      scene.add(box);
      for (const option of part('what').options) {
        option.disabled = !data.scan && option.value !== 'block' ||
            !data.deviation && option.value === 'deviation';
      }
      if (part('what').selectedOptions[0].disabled) part('what').value = 'block';
      if (data.deviation) {
        const most = `${data.deviation.reach.toPrecision(2)} ${data.unit}`;
        part('distances').innerHTML = `inside ${most} <i style="background:linear-gradient(` +
            `to right,${data.deviation.colours.join(',')})"></i> ${most} outside`;
      }
    }
    function placeCamera() {
      camera.position.set(.55, -1, .55).setLength(3.7);
      controls.target.set(0, 0, 0);
      controls.update();
    }
    async function prepare() {
      renderer = await clastOpenRenderer(frame, {preserveDrawingBuffer: true});
      camera = new THREE.PerspectiveCamera(38, 1, .01, 100);
      camera.up.set(0, 0, 1);
      controls = new THREE.OrbitControls(camera, renderer.domElement);
      controls.addEventListener('change', drawSoon);
      for (const name of ['what', 'box']) part(name).addEventListener('change', choose);
      addEventListener('resize', fit);
    }
    let prepared;
    async function show(id) {
      try {
        prepared = prepared || prepare();
        await prepared;
        data = JSON.parse(await clastUnpacked(id));
        fillScene();
        placeCamera();
        choose();
        fit();
        draw();
      } catch (error) {
        frame.textContent = error.message;
      }
      return element;
    }
    if (element.dataset.source) {
      new IntersectionObserver((entries, watcher) => {
        if (!entries.some((entry) => entry.isIntersecting)) return;
        watcher.disconnect();
        show(element.dataset.source);
      }, {rootMargin: '200px'}).observe(element);
    }
    return {show, draw, choose};
  }

  const views = new Map();
  const viewOf = (element) => {
    if (!views.has(element)) views.set(element, view(element));
    return views.get(element);
  };
  for (const element of document.querySelectorAll('.turntable')) viewOf(element);
  return viewOf;
})();
