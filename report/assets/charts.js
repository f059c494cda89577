// Charts are drawn when they are first seen, so that the page opens at once. `clastCharts` is there
// for the console and for tests.
const clastCharts = (() => {
  const settings = {
    responsive: true,
    displaylogo: false,
    modeBarButtonsToRemove: ['lasso2d', 'select2d', 'zoomIn2d', 'zoomOut2d', 'autoScale2d'],
    toImageButtonOptions: {format: 'svg'},
  };
  const boxes = Array.from(document.querySelectorAll('.chart'));
  const drawn = new Set();

  // Height of a chart and place of its names, in rows below, for a plot of that size (px).
  function withNames({data, layout}, plotWidth, plotHeight) {
    const {t, b} = layout.margin, shown = data.filter(({showlegend}) => showlegend !== false);
    const widest = Math.max(...shown.map(({name}) => 48 + 6.6 * (name || '').length));
    const rows = Math.ceil(shown.length / Math.max(1, Math.floor(plotWidth / widest)));
    return {height: Math.round(t + plotHeight + b + 19 * rows), 'legend.y': -b / plotHeight};
  }
  // A map is as high as its window asks for at that width.
  function fitted(map, width, highest) {
    const {margin, xaxis, yaxis} = map.layout, plotWidth = width - margin.l - margin.r;
    const length = ({range}) => Math.abs(range[1] - range[0]);
    return withNames(map, plotWidth, Math.min(plotWidth * length(yaxis) / length(xaxis), highest));
  }
  // The title below a chart goes on as many lines as its plot is too narrow for it (px).
  function breakTitle({data, layout}, width) {
    const {xaxis, yaxis, margin, legend} = layout, title = xaxis && xaxis.title;
    if (!title || !title.text) return;
    const names = yaxis.automargin ? data.flatMap(({y}) => y).map((name) => `${name}`.length) : [];
    const left = Math.max(margin.l, 20 + 6.6 * Math.max(0, ...names));
    const lines = [''];
    for (const word of title.text.split(' ')) {
      const longer = `${lines[lines.length - 1]} ${word}`.trim();
      if (lines[lines.length - 1] && 7.2 * longer.length > width - left + margin.r) lines.push(word);
      else lines[lines.length - 1] = longer;
    }
    if (lines.length < 2) return;
    const more = 18 * (lines.length - 1), plotHeight = layout.height - margin.t - margin.b;
    title.text = lines.join('<br>');
    margin.b += more;
    layout.height += more;
    if (legend) legend.y -= more / plotHeight;
  }
  const highestMap = () => Math.max(300, Math.min(520, .58 * innerHeight));

  async function plot(box) {
    if (drawn.has(box)) return;
    drawn.add(box);
    const figure = JSON.parse(box.nextElementSibling.textContent);
    if (box.classList.contains('map')) {
      const {height, 'legend.y': y} = fitted(figure, box.clientWidth, highestMap());
      figure.layout.height = height;
      figure.layout.legend.y = y;
    } else {
      breakTitle(figure, box.clientWidth);
    }
    await Plotly.newPlot(box, figure.data, figure.layout, {...settings, ...figure.config});
    box.dispatchEvent(new CustomEvent('drawn', {bubbles: true}));
  }
  async function draw(box) {
    try {
      await clastRun('plotly-code');
      await plot(box);
    } catch (error) {
      box.textContent = error.message;
    }
    return box;
  }
  const drawAll = () => Promise.all(boxes.map(draw));

  const watcher = new IntersectionObserver((entries) => {
    for (const {isIntersecting, target} of entries) {
      if (!isIntersecting) continue;
      watcher.unobserve(target);
      draw(target);
    }
  }, {rootMargin: '300px'});
  for (const box of boxes) watcher.observe(box);
  // Paper waits for nothing: the library must be there by then, and draws at once, in the widths of
  // A4 (px): a map takes the page, two charts stand side by side.
  const paper = (box) => {
    const alone = !box.closest('.charts'), width = alone ? 680 : 334;
    if (box.classList.contains('map')) return {width, ...fitted(box, width, 380)};
    if (alone) return {width, height: box.layout.height};
    const {l, r} = box.layout.margin;
    return {width, ...withNames(box, width - l - r, 140)};
  };
  const folded = Array.from(document.querySelectorAll('details.paper:not([open])'));
  addEventListener('load', () => clastRun('plotly-code').catch(() => {}));
  addEventListener('beforeprint', () => {
    if (!window.Plotly) return;
    for (const fold of folded) fold.open = true;
    for (const box of boxes) {
      if (box.closest('details:not([open])')) continue;
      plot(box);
      const {height, legend} = box.layout;
      box.onScreen = {autosize: true, width: null, height, 'legend.y': legend.y};
      Plotly.relayout(box, {autosize: false, ...paper(box)});
    }
  });
  addEventListener('afterprint', () => {
    for (const fold of folded) fold.open = false;
    for (const box of boxes) if (box.onScreen) Plotly.relayout(box, box.onScreen);
  });
  return {draw, drawAll};
})();
