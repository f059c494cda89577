// A deposit: its map, lists and corrections. `clastDeposit` is there for the console and for tests.
const clastDeposit = (async () => {
  const root = document.querySelector('.deposit');
  const part = (name) => root.querySelector(`[data-deposit=${name}]`);
  const button = (act) => root.querySelector(`[data-act=${act}]`);
  const map = root.querySelector('.map'), pen = map.getContext('2d');
  const numbers = (type, base64) => new type(clastBytes(base64).buffer);

  const data = JSON.parse(await clastUnpacked('deposit-data'));
  const {cloud, plan, leftOut} = data;
  cloud.places = numbers(Uint16Array, cloud.places);
  cloud.blocks = numbers(Uint32Array, cloud.blocks);
  cloud.shades = numbers(Uint8Array, cloud.shades);
  plan.blocks = numbers(Uint32Array, plan.blocks);
  const edits = clastDepositEdits(data);
  const ground = [214, 205, 190], chosenColour = [255, 214, 10];
  const selection = new Set();
  let line = null;     // points of a cut that is being drawn
  let pointer = null;  // place of the pointer on the map
  let saved = 0;       // number of corrections of the page in the saved file
  let changed = false;  // true if corrections of the run were left out or taken back

  // Colours that differ for neighbours in the list of blocks.
  const colours = new Map();
  function colourOf(block) {
    if (!block) return ground;
    if (selection.has(block)) return chosenColour;
    if (!colours.has(block)) {
      const hue = 360 * (block * .61803398875 % 1), bright = block % 3;
      const channel = (n) => {
        const k = (n + hue / 30) % 12, half = [.26, .22, .24][bright];
        return 255 * ([.64, .72, .56][bright] - half * Math.max(-1, Math.min(k - 3, 9 - k, 1)));
      };
      colours.set(block, [channel(0), channel(8), channel(4)]);
    }
    return colours.get(block);
  }

  // The map: the relief in the colours of the blocks, at one pixel per cell.
  const sheet = document.createElement('canvas');
  sheet.width = plan.columns;
  sheet.height = plan.rows;
  const image = new Image();
  image.src = root.dataset.relief;
  await image.decode();
  const paper = sheet.getContext('2d', {willReadFrequently: true});
  paper.drawImage(image, 0, 0);
  const relief = paper.getImageData(0, 0, plan.columns, plan.rows);
  function paint() {
    const picture = new ImageData(plan.columns, plan.rows), {columns, rows} = plan;
    const pixels = picture.data, light = relief.data;
    const block = new Uint32Array(columns * rows).map((_, cell) => edits.blockOfCell(cell));
    for (let cell = 0; cell < block.length; cell++) {
      const at = 4 * cell, own = block[cell], column = cell % columns;
      const border = own && (block[cell - 1] !== own || block[cell + 1] !== own ||
          block[cell - columns] !== own || block[cell + columns] !== own ||
          !column || column === columns - 1);
      const [r, g, b] = colourOf(own), shade = light[at + 1] / 223 * (border ? .45 : 1);
      pixels[at] = own ? r * shade : light[at];
      pixels[at + 1] = own ? g * shade : light[at + 1];
      pixels[at + 2] = own ? b * shade : light[at + 2];
      pixels[at + 3] = light[at + 3];
    }
    paper.putImageData(picture, 0, 0);
  }

  // Place of the map on its canvas: cells times `zoom`, moved by `left` and `top` (px).
  let zoom = 1, left = 0, top = 0, ratio = 1;
  const columnOf = (x) => (x - plan.low[0]) / plan.cell;
  const rowOf = (y) => plan.rows - (y - plan.low[1]) / plan.cell;
  const pixelOf = ([x, y]) => [left + zoom * columnOf(x), top + zoom * rowOf(y)];
  const placeAt = ([px, py]) => [plan.low[0] + plan.cell * (px - left) / zoom,
                                 plan.low[1] + plan.cell * (plan.rows - (py - top) / zoom)];
  function fit() {
    ratio = devicePixelRatio || 1;
    map.width = Math.round(ratio * map.clientWidth);
    map.height = Math.round(ratio * map.clientHeight);
    zoom = Math.min(map.clientWidth / plan.columns, map.clientHeight / plan.rows);
    left = (map.clientWidth - zoom * plan.columns) / 2;
    top = (map.clientHeight - zoom * plan.rows) / 2;
    draw();
  }
  function zoomAt([x, y], factor) {
    const next = Math.max(.2, Math.min(40, zoom * factor));
    left = x - (x - left) * next / zoom;
    top = y - (y - top) * next / zoom;
    zoom = next;
    draw();
  }
  function stroke(points, style, width) {
    pen.strokeStyle = style;
    pen.lineWidth = width;
    pen.beginPath();
    points.forEach((point, i) => pen[i ? 'lineTo' : 'moveTo'](...pixelOf(point)));
    pen.stroke();
  }
  function drawScaleBar() {
    const most = .3 * map.clientWidth * plan.cell / zoom, power = 10 ** Math.floor(Math.log10(most));
    const length = power * [5, 2, 1].find((n) => n * power <= most);
    const width = length / plan.cell * zoom, y = map.clientHeight - 14;
    pen.fillStyle = 'rgba(255,255,255,.8)';
    pen.fillRect(8, y - 18, width + 16, 26);
    pen.fillStyle = '#1d2733';
    pen.fillRect(16, y, width, 3);
    pen.font = '12px system-ui, Arial, sans-serif';
    pen.fillText(`${+length.toPrecision(1)} m`, 16, y - 4);
  }
  function drawParts() {
    leftOut.forEach(({at}, index) => {
      const block = edits.blockOfLabel(edits.partLabel(index));
      if (!block || block !== edits.partLabel(index)) return;
      const [x, y] = pixelOf(at), reach = 4;
      for (const [style, width] of [['#fff', 4], [selection.has(block) ? '#c77700' : '#1d2733', 1.8]]) {
        pen.strokeStyle = style;
        pen.lineWidth = width;
        pen.beginPath();
        pen.moveTo(x - reach, y - reach);
        pen.lineTo(x + reach, y + reach);
        pen.moveTo(x - reach, y + reach);
        pen.lineTo(x + reach, y - reach);
        pen.stroke();
      }
    });
  }
  function draw() {
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, map.clientWidth, map.clientHeight);
    pen.imageSmoothingEnabled = zoom < 2;
    pen.drawImage(sheet, left, top, zoom * plan.columns, zoom * plan.rows);
    drawParts();
    drawScaleBar();
    if (!line) return;
    const points = pointer ? [...line, pointer] : line;
    stroke(points, '#fff', 5);
    stroke(points, '#c0104a', 2);
  }

  // Selection and lists.
  const rows = new Map();  // by label
  for (const mark of document.querySelectorAll('[data-block]')) {
    rows.set(+mark.dataset.block, mark.closest('tr'));
  }
  for (const mark of document.querySelectorAll('[data-part]')) {
    rows.set(edits.partLabel(+mark.dataset.part), mark.closest('tr'));
  }
  function stateOf(label) {
    const block = edits.blockOfLabel(label);
    if (!block) return 'dropped';
    const others = edits.membersOf(block).filter((other) => other !== label);
    return [edits.isAccepted(block) && 'accepted',
            others.length && 'merged with ' + others.map(edits.nameOfLabel).join(', '),
            edits.isCut(block) && 'cut'].filter(Boolean).join(', ');
  }
  function fillLists() {
    for (const [label, row] of rows) {
      const block = edits.blockOfLabel(label);
      row.classList.toggle('chosen', selection.has(block));
      row.classList.toggle('dropped', !block);
      row.cells[1].textContent = stateOf(label);
    }
    const list = part('edits');
    list.replaceChildren();
    edits.applied().forEach((edit, index) => {
      const item = document.createElement('li'), toggle = document.createElement('button');
      const [x, y] = edit.points[0];
      item.textContent = `${edit.kind} at x ${x.toFixed(2)}, y ${y.toFixed(2)} (in this run)`;
      item.classList.toggle('removed', !!edit.removed);
      toggle.type = 'button';
      toggle.textContent = edit.removed ? 'keep' : 'remove';
      toggle.addEventListener('click', () => {
        edits.toggle(index);
        changed = true;
        refresh(edit.removed ? 'It is left out of the saved file and of the next run.' : '');
      });
      item.append(toggle);
      list.append(item);
    });
    for (const {text} of edits.added()) {
      const item = document.createElement('li');
      item.textContent = text;
      list.append(item);
    }
    list.scrollTop = list.scrollHeight;
  }
  function fillControls(status) {
    const chosen = [...selection];
    button('accept').disabled = button('cut').disabled = chosen.length !== 1;
    button('drop').disabled = !chosen.length;
    button('merge').disabled = chosen.length < 2;
    button('undo').disabled = !edits.added().length && !line;
    button('cut').setAttribute('aria-pressed', !!line);
    map.classList.toggle('cutting', !!line);
    part('chosen').textContent = chosen.length ?
        'Selected: ' + chosen.map(edits.nameOf).join('; ') : 'No block is selected.';
    part('status').textContent = status || '';
  }
  function refresh(status) {
    paint();
    draw();
    fillLists();
    fillControls(status);
    scene.colour();
  }
  // Selects a block, or adds it to the selection or removes it from there.
  function select(block, more) {
    if (!more && !part('several').checked) {
      const only = selection.size === 1 && selection.has(block);
      selection.clear();
      if (only) block = 0;
    }
    if (block && !selection.delete(block)) selection.add(block);
    refresh();
  }
  const adds = (event) => event.shiftKey || event.ctrlKey || event.metaKey;

  // Corrections of what is selected. Selected is then what they made.
  function act(kind) {
    if (kind === 'undo') return undo();
    if (kind === 'save') return save();
    if (kind === 'cut') return beginCut();
    endCut();
    const chosen = [...selection];
    let refusal = chosen.length ? '' : 'Select a block first.';
    const keep = kind === 'merge' ? [Math.min(...chosen)] : kind === 'accept' ? chosen : [];
    for (const blocks of kind === 'merge' ? [chosen] : chosen.map((block) => [block])) {
      refusal = refusal || edits.add(kind, blocks) || '';
    }
    if (!refusal) {
      selection.clear();
      keep.forEach((block) => selection.add(block));
    }
    refresh(refusal);
  }
  function undo() {
    if (line) {
      endCut();
      return refresh();
    }
    const edit = edits.undo();
    selection.clear();
    if (edit) edit.blocks.forEach((block) => selection.add(block));
    refresh(edit ? '' : 'There is nothing to undo on this page.');
  }
  function beginCut() {
    if (selection.size !== 1) return refresh('Select the block to cut.');
    line = [];
    refresh('Click two or more points of the line on the map; Enter or a double click ends it, Escape leaves it.');
    map.focus({preventScroll: true});
  }
  function endCut() {
    line = pointer = null;
  }
  function cut(points) {
    endCut();
    const refusal = points.length < 2 ? 'A line has two points or more.' :
        edits.add('cut', [...selection], points);
    refresh(refusal);
  }
  function addToLine(place) {
    const last = line[line.length - 1];
    if (!last || Math.hypot(place[0] - last[0], place[1] - last[1]) > .5 * plan.cell) line.push(place);
    draw();
  }
  function save() {
    const file = document.createElement('a');
    file.href = URL.createObjectURL(new Blob([edits.text()], {type: 'application/json'}));
    file.download = 'edits.json';
    file.click();
    saved = edits.added().length;
    changed = false;
    refresh('Saved as edits.json, among your downloads.');
  }

  // The block of a pixel of the map: a part that is left out, or the block of the cell.
  function blockAtPixel([px, py]) {
    for (let index = 0; index < leftOut.length; index++) {
      const [x, y] = pixelOf(leftOut[index].at);
      const block = edits.blockOfLabel(edits.partLabel(index));
      if (block === edits.partLabel(index) && Math.hypot(x - px, y - py) < 7) return block;
    }
    const column = Math.floor((px - left) / zoom), row = Math.floor((py - top) / zoom);
    const inside = column >= 0 && row >= 0 && column < plan.columns && row < plan.rows;
    return inside ? edits.blockOfCell(row * plan.columns + column) : 0;
  }
  const at = (event) => {
    const box = map.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  let grip = null;
  map.addEventListener('pointerdown', (event) => {
    grip = {at: at(event), left, top, moved: false};
    if (event.isTrusted) map.setPointerCapture(event.pointerId);
  });
  map.addEventListener('pointermove', (event) => {
    const [x, y] = at(event);
    if (grip && event.buttons) {
      grip.moved = grip.moved || Math.hypot(x - grip.at[0], y - grip.at[1]) > 4;
      if (grip.moved) [left, top] = [grip.left + x - grip.at[0], grip.top + y - grip.at[1]];
    }
    if (line) pointer = placeAt([x, y]);
    if (line || grip?.moved) draw();
  });
  map.addEventListener('pointerup', (event) => {
    const moved = grip?.moved;
    grip = null;
    if (moved) return;
    if (line) addToLine(placeAt(at(event)));
    else select(blockAtPixel(at(event)), adds(event));
  });
  map.addEventListener('dblclick', () => line && cut(line));
  map.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoomAt(at(event), Math.exp(-.0015 * event.deltaY));
  }, {passive: false});
  addEventListener('resize', fit);

  function show(block) {
    const place = edits.placeOf(block);
    if (!place) return;
    const [x, y] = pixelOf(place);
    if (x < 0 || y < 0 || x > map.clientWidth || y > map.clientHeight) {
      left += map.clientWidth / 2 - x;
      top += map.clientHeight / 2 - y;
      draw();
    }
    scene.lookAt(place, .45 * Math.max(plan.columns, plan.rows) * plan.cell);
  }
  for (const [label, row] of rows) {
    row.addEventListener('click', (event) => {
      if (event.target.closest('a')) return;
      const block = edits.blockOfLabel(label);
      select(block, adds(event));
      if (block) show(block);
    });
  }
  for (const one of root.querySelectorAll('[data-act]')) {
    one.addEventListener('click', () => act(one.dataset.act));
  }
  const keys = {a: 'accept', d: 'drop', m: 'merge', c: 'cut', z: 'undo'};
  addEventListener('keydown', (event) => {
    if (event.ctrlKey && event.key === 'z') return act('undo');
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.matches('input:not([type=checkbox])')) return;
    if (keys[event.key]) return act(keys[event.key]);
    if (event.key === 'Enter' && line) {
      event.preventDefault();
      return cut(line);
    }
    if (event.key !== 'Escape') return;
    if (!line) selection.clear();
    endCut();
    refresh();
  });
  addEventListener('beforeunload', (event) => {
    if (edits.added().length !== saved || changed) event.preventDefault();
  });

  const scene = typeof THREE !== 'undefined' || document.getElementById('three-code') ?
      clastDepositScene(root.querySelector('.space'), cloud,
                        (i) => colourOf(edits.blockOfPoint(i)),
                        (i, event) => select(edits.blockOfPoint(i), adds(event))) :
      {colour() {}, lookAt() {}, start() {}};
  refresh();
  fit();
  return {edits, select, act, cut, scene, map, pixelOf, blockAtPixel, selection};
})();
