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

  async function plot(box) {
    if (drawn.has(box)) return;
    drawn.add(box);
    const figure = JSON.parse(box.nextElementSibling.textContent);
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
    const alone = !box.closest('.charts'), map = box.classList.contains('map');
    // Below the curves their names take lines of their own.
    const beside = 232 + 14 * Math.max(0, box.data.length - 2);
    return {width: alone ? 680 : 334, height: map ? 430 : alone ? undefined : beside};
  };
  addEventListener('load', () => clastRun('plotly-code').catch(() => {}));
  addEventListener('beforeprint', () => {
    if (!window.Plotly) return;
    for (const box of boxes) {
      if (box.closest('details:not([open])')) continue;
      plot(box);
      const {width, height} = paper(box), before = box.layout;
      box.onScreen = {autosize: true, width: null, height: before.height};
      Plotly.relayout(box, {autosize: false, width, height: height || before.height});
    }
  });
  addEventListener('afterprint', () => {
    for (const box of boxes) if (box.onScreen) Plotly.relayout(box, box.onScreen);
  });
  return {draw, drawAll};
})();
