// Maps: one layer at a time over the relief, paths, north arrow and scale bar. `clastMaps` is there
// for the console and for tests.
const clastMaps = (() => {
  const narrow = 600;  // px; a map that is narrower has its colours in a row below it

  const numbers = (base64) => new Float32Array(clastBytes(base64).buffer);

  // Cells in the colours of their classes; what the pointer shows is the value itself.
  function rasterTrace(layer, origin, {xaxis, yaxis}) {
    const values = numbers(layer.values), count = layer.breaks.length;
    const classes = [], shown = [];
    for (let first = 0; first < values.length; first += layer.columns) {
      const row = Array.from(values.subarray(first, first + layer.columns));
      classes.push(row.map((value) => isNaN(value) ? null :
          Math.min(count - 1, layer.breaks.filter((limit) => value > limit).length)));
      shown.push(row.map((value) => isNaN(value) ? null : value / layer.unit_size));
    }
    const right = xaxis.domain[1], [bottom, top] = yaxis.domain, height = top - bottom;
    const place = {x: right + .01, xanchor: 'left', y: bottom + .5 * height, yanchor: 'middle',
                   len: .7 * height};
    return {
      type: 'heatmap', meta: 'raster', name: layer.title, hoverongaps: false,
      x0: origin[0] + layer.x0, dx: layer.cell, y0: origin[1] + layer.y0, dy: -layer.cell,
      z: classes, customdata: shown, zmin: -.5, zmax: count - .5,
      colorscale: layer.colours.flatMap((colour, k) =>
          [[k / count, colour], [(k + 1) / count, colour]]),
      hovertemplate: `${layer.title}: %{customdata:.3~g} ${layer.unit}` +
          '<br>x %{x:.2f}, y %{y:.2f} m<extra></extra>',
      colorbar: {
        ...place, title: {text: layer.unit}, thickness: 14, ticks: 'outside', ticklen: 4,
        tickvals: layer.numbers.map((number, k) => k + .5), ticktext: layer.numbers,
        bgcolor: 'rgba(255,255,255,.85)', xpad: 6,
      },
    };
  }

  // The same classes in a row: the number is the upper limit of its colour.
  function colourRow(layer) {
    const cells = layer.numbers.map((number, k) => {
      const cell = document.createElement('span');
      cell.style.borderTopColor = layer.colours[k];
      cell.textContent = number;
      return cell;
    });
    return [...cells, layer.unit];
  }

  function pathTraces(data) {
    return data.paths.map((path) => ({
      type: 'scatter', mode: 'lines', meta: 'paths', name: `paths, ${path.name}`,
      x: Array.from(numbers(path.x), (x) => isNaN(x) ? null : data.origin[0] + x),
      y: Array.from(numbers(path.y), (y) => isNaN(y) ? null : data.origin[1] + y),
      line: {color: path.colour, width: 1}, opacity: data.path_opacity, hoverinfo: 'skip',
    }));
  }

  // The longest round length of at most so many metres: 1, 2 or 5 times a power of ten.
  function roundDown(metres) {
    const power = 10 ** Math.floor(Math.log10(metres));
    return power * [5, 2, 1].find((factor) => factor * power <= metres);
  }

  // Scale bar at the lower left, north arrow at the upper right, in pixels of the map.
  function furniture(pixelsPerMetre, {xaxis, yaxis}) {
    const [left, right] = xaxis.domain, [bottom, top] = yaxis.domain;
    const metres = roundDown(Math.min(130, .35 * xaxis._length) / pixelsPerMetre);
    const length = metres * pixelsPerMetre;
    const at = (x, y) => ({xref: 'paper', yref: 'paper', xanchor: x, yanchor: y,
                           xsizemode: 'pixel', ysizemode: 'pixel'});
    const box = (x0, x1, y0, y1, fill, line) =>
        ({...at(left, bottom), type: 'rect', x0, x1, y0, y1, fillcolor: fill, line: {width: line}});
    const text = (x, y, words, xshift, yshift, size) =>
        ({xref: 'paper', yref: 'paper', x, y, text: words, showarrow: false, xshift, yshift,
          xanchor: 'center', yanchor: 'middle', font: {size, color: '#111'}, name: 'furniture'});
    const pale = 'rgba(255,255,255,.8)';
    return {
      shapes: [
        box(6, length + 22, 6, 38, pale, 0), box(14, 14 + length / 2, 12, 17, '#111', 1),
        box(14 + length / 2, 14 + length, 12, 17, '#fff', 1),
        {...at(right, top), type: 'circle', x0: -46, x1: -4, y0: -46, y1: -4, fillcolor: pale,
         line: {width: 0}},
        {...at(right, top), type: 'path', path: 'M-25,-7 L-18,-26 L-25,-21 L-32,-26 Z',
         fillcolor: '#111', line: {width: 0}},
      ],
      annotations: [
        text(left, bottom, metres >= 1000 ? `${metres / 1000} km` : `${metres} m`, 14 + length / 2, 27, 12),
        text(right, top, '<b>N</b>', -25, -34, 13),
      ],
    };
  }

  function layered(root) {
    const box = root.querySelector('.chart');
    const part = (name) => root.querySelector(`[data-map=${name}]`);
    const marks = box.data, texts = box.layout.annotations || [];
    const layers = {};  // the trace of each that was shown
    let data, paths, drawn;

    const read = async () =>
        data = data || JSON.parse(await clastUnpacked(root.dataset.layers));

    function scaled() {
      const axis = box._fullLayout.xaxis;
      return axis._length / Math.abs(axis.range[1] - axis.range[0]);
    }
    // Furniture follows the scale; what is as it was is not drawn again.
    function furnish() {
      const scale = scaled(), {xaxis, yaxis} = box._fullLayout;
      const state = [scale.toPrecision(4), xaxis.domain, yaxis.domain].join(' ');
      if (state === drawn) return;
      drawn = state;
      const {shapes, annotations} = furniture(scale, box._fullLayout);
      return Plotly.relayout(box, {shapes, annotations: [...texts, ...annotations]});
    }
    async function draw() {
      const name = part('layer').value, wanted = part('paths') && part('paths').checked;
      const needed = wanted || name !== 'stops' ? await read() : null;
      const layer = name !== 'stops' && needed.layers.find((one) => one.name === name);
      if (layer && !layers[name]) {
        layers[name] = rasterTrace(layer, data.origin, box._fullLayout);
      }
      if (wanted) paths = paths || pathTraces(data);
      for (const trace of marks) {
        if (trace.meta !== 'stops') continue;
        // What the legend has hidden stays so.
        if (layer && trace.visible !== false) {
          trace.before = trace.visible === undefined ? true : trace.visible;
          trace.visible = false;
        } else if (!layer && trace.before !== undefined) {
          trace.visible = trace.before;
          delete trace.before;
        }
      }
      const shown = [...(wanted ? paths : []), ...marks, ...(layer ? [layers[name]] : [])];
      const isNarrow = box.clientWidth < narrow;
      for (const trace of shown) {
        if (trace.type !== 'heatmap') continue;
        trace.opacity = +part('opacity').value;
        trace.showscale = !isNarrow;
      }
      part('colours').replaceChildren(...(layer && isNarrow ? colourRow(layer) : []));
      await Plotly.react(box, shown, box.layout);
      await furnish();
      root.dataset.shown = name;
      return box;
    }

    for (const name of ['layer', 'opacity', 'paths']) {
      if (part(name)) part(name).addEventListener('change', draw);
    }
    box.on('plotly_afterplot', furnish);
    // A browser that goes back may keep what was chosen; a map without stops has a layer at once.
    root.ready = part('layer').value === 'stops' ? furnish() : draw();
    return draw;
  }

  const maps = new Map();
  function begin(box) {
    const root = box.closest('.layered-map');
    if (root && !maps.has(root)) maps.set(root, layered(root));
  }
  document.addEventListener('drawn', (event) => begin(event.target));
  for (const box of document.querySelectorAll('.layered-map .js-plotly-plot')) begin(box);

  // Shows a layer, as its choice by hand does.
  const show = (root, name) => {
    root.querySelector('[data-map=layer]').value = name;
    return maps.get(root)();
  };
  return {show};
})();
