// Corrections of a segmented deposit, applied to the cells of its map and the points of its 3-D view
// as clast applies them to the scan: in their order, each to the result of those before it.
// Labels: 0 ground; 1, 2, ... the blocks, then the parts that are left out, then sides of cuts. A
// group of labels is a block.
function clastDepositEdits(data) {
  const {cloud, plan, ids, leftOut} = data;
  const firstPart = ids.length + 1, firstSide = firstPart + leftOut.length;
  const added = [];  // corrections made on this page, after those in data.edits
  const applied = data.edits.map((edit) => ({...edit}));
  let pointLabels, cellLabels, group, accepted, source;

  const pointAt = (i) => [0, 1, 2].map((k) => cloud.origin[k] + cloud.step * cloud.places[3 * i + k]);
  const cellAt = (i) => [plan.low[0] + plan.cell * (i % plan.columns + .5),
                         plan.low[1] + plan.cell * (plan.rows - .5 - Math.floor(i / plan.columns))];

  // True to the left of the nearest part of a line whose ends extend without limit.
  function isLeft(line, [x, y]) {
    const direction = (i) => {
      const dx = line[i + 1][0] - line[i][0], dy = line[i + 1][1] - line[i][1];
      const length = Math.hypot(dx, dy);
      return [dx / length, dy / length, length];
    };
    let nearest = Infinity, side = 0;
    const last = line.length - 2;
    for (let i = 0; i <= last; i++) {
      const [u, v, length] = direction(i);
      const px = x - line[i][0], py = y - line[i][1];
      let t = px * u + py * v, tangent = [u, v];
      if (t < 0 && i > 0) {
        const before = direction(i - 1);
        t = 0;
        tangent = [u + before[0], v + before[1]];
      } else if (t > length && i < last) {
        const after = direction(i + 1);
        t = length;
        tangent = [u + after[0], v + after[1]];
      }
      const gx = px - t * u, gy = py - t * v, gap = gx * gx + gy * gy;
      if (gap >= nearest) continue;
      nearest = gap;
      side = tangent[0] * gy - tangent[1] * gx;
    }
    return side > 0;
  }

  function unite(from, to) {
    for (let label = 1; label < group.length; label++) if (group[label] === from) group[label] = to;
    accepted.delete(from);
    accepted.delete(to);
  }
  // Gives the points and cells of a block to the left of the line a label of their own. Returns
  // false where it leaves the block on one side.
  function cut(block, line) {
    const sides = (labels, at) => {
      const left = [], right = [];
      for (let i = 0; i < labels.length; i++) {
        if (labels[i] && group[labels[i]] === block) (isLeft(line, at(i)) ? left : right).push(i);
      }
      return [left, right];
    };
    const [left, right] = sides(pointLabels, pointAt);
    if (!left.length || !right.length) return false;
    const label = group.length;
    group.push(label);
    source.push(block);
    for (const i of left) pointLabels[i] = label;
    for (const i of sides(cellLabels, cellAt)[0]) cellLabels[i] = label;
    accepted.delete(block);
    return true;
  }
  function apply({kind, blocks, line}) {
    if (kind === 'accept') accepted.add(blocks[0]);
    if (kind === 'drop') unite(blocks[0], 0);
    if (kind === 'merge') {
      const [first, ...others] = [...blocks].sort((a, b) => a - b);
      for (const other of others) unite(other, first);
    }
    return kind !== 'cut' || cut(blocks[0], line);
  }

  // The point of a block nearest to the mean of its points.
  function placeOf(block) {
    const mean = [0, 0, 0], own = [];
    for (let i = 0; i < pointLabels.length; i++) {
      if (!pointLabels[i] || group[pointLabels[i]] !== block) continue;
      own.push(i);
      pointAt(i).forEach((x, k) => { mean[k] += x; });
    }
    if (!own.length) return leftOut[block - firstPart]?.at;
    let best, least = Infinity;
    for (const i of own) {
      const place = pointAt(i);
      const distance = Math.hypot(...place.map((x, k) => x - mean[k] / own.length));
      if (distance < least) [least, best] = [distance, place];
    }
    return best;
  }
  function replay() {
    pointLabels = cloud.blocks.slice();
    cellLabels = plan.blocks.slice();
    group = Array.from({length: firstSide}, (_, label) => label);
    source = group.slice();
    accepted = new Set(data.accepted);
    for (const edit of added) apply(edit);
  }
  replay();

  const nameOf = (label) => label < firstPart ? ids[label - 1] :
      label < firstSide ? `part ${label - ids.length}` : `side of ${nameOf(source[label])}`;
  const membersOf = (block) => group.map((_, label) => label)
      .filter((label) => label && group[label] === block);
  const rounded = (place) => place.map((x) => +x.toFixed(4));

  return {
    // Adds a correction of blocks. Returns why it is impossible, or nothing.
    add(kind, blocks, line) {
      if (kind === 'merge' ? blocks.length < 2 : blocks.length !== 1) {
        return kind === 'merge' ? 'Select two or more blocks to merge.' : 'Select one block.';
      }
      const isPart = blocks.every((block) => block >= firstPart && block < firstSide);
      if (isPart && kind !== 'drop') {
        return kind === 'merge' ? 'Select a block to merge the part with.' :
            'A part that is left out can be dropped, or merged with a block.';
      }
      const edit = {kind, blocks, points: blocks.map(placeOf).map(rounded),
                    text: `${kind} ${blocks.map((block) => this.nameOf(block)).join(', ')}`};
      if (line) edit.line = line.map(rounded);
      if (!apply(edit)) return 'The line leaves the whole block on one side; draw it across.';
      added.push(edit);
    },
    // Removes the last correction of this page. Returns it.
    undo() {
      const edit = added.pop();
      replay();
      return edit;
    },
    // Leaves a correction of the run out of the file, or takes it back in.
    toggle(index) {
      applied[index].removed = !applied[index].removed;
    },
    applied: () => applied,
    added: () => added,
    blockOfPoint: (i) => group[pointLabels[i]],
    blockOfCell: (i) => group[cellLabels[i]],
    blockOfLabel: (label) => group[label],
    placeOf,
    membersOf,
    partLabel: (index) => firstPart + index,
    nameOfLabel: nameOf,
    nameOf: (block) => membersOf(block).slice(0, 4).map(nameOf).join(' + ') || nameOf(block),
    isAccepted: (block) => accepted.has(block),
    isCut: (block) => source.some((from, label) => label >= firstSide && from === block),
    // The file of corrections.
    text() {
      const kept = applied.filter((edit) => !edit.removed).map(({removed, ...edit}) => edit);
      const edits = kept.concat(added.map(({kind, points, line}) =>
          line ? {kind, points, line} : {kind, points}));
      return '{"format": "clast deposit edits",\n "edits": [\n' +
          edits.map((edit) => '  ' + JSON.stringify(edit)).join(',\n') + '\n]}\n';
    },
  };
}
