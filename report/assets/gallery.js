// Blocks of a gallery by class, in an order, and one of them large in 3-D. `clastGallery` is there
// for the console and for tests.
const clastGallery = (() => {
  const gallery = document.querySelector('.gallery');
  const part = (name) => document.querySelector(`[data-gallery=${name}]`);
  const cards = Array.from(gallery.querySelectorAll('.card'));
  const dialog = document.querySelector('dialog.block');
  let up = true;

  function filter() {
    const [scheme, name] = part('class').value.split(':');
    for (const card of cards) card.hidden = scheme !== 'all' && card.dataset[scheme] !== name;
    const shown = cards.filter((card) => !card.hidden).length;
    part('count').textContent = `${shown} of ${cards.length}`;
  }
  function sort() {
    const key = part('order').value;
    const order = key === 'name' ?
        (a, b) => a.dataset.name.localeCompare(b.dataset.name, undefined, {numeric: true}) :
        (a, b) => {
          const [x, y] = [a, b].map((card) => parseFloat(card.dataset[key]));
          // What is not known comes last, whichever way.
          if (isNaN(x) || isNaN(y)) return (isNaN(x) - isNaN(y)) * (up ? 1 : -1);
          return x - y;
        };
    gallery.append(...cards.sort((a, b) => up ? order(a, b) : -order(a, b)));
  }

  // The block in 3-D with all its numbers.
  async function open(card) {
    dialog.querySelector('h2').textContent = card.dataset.name;
    dialog.querySelector('.numbers').replaceChildren(
        card.querySelector('.details').content.cloneNode(true));
    dialog.showModal();
    const turntable = dialog.querySelector('.turntable');
    if (turntable && typeof clastTurntable !== 'undefined') {
      await clastTurntable(turntable).show(card.dataset.source);
    }
    return turntable;
  }

  part('class').addEventListener('change', filter);
  part('order').addEventListener('change', sort);
  part('turn').addEventListener('click', () => {
    up = !up;
    part('turn').textContent = up ? '\u25B4' : '\u25BE';
    sort();
  });
  gallery.addEventListener('click', (event) => {
    const button = event.target.closest('button.open');
    if (button) open(button.closest('.card'));
  });
  document.querySelector('.series-tables')?.addEventListener('click', (event) => {
    const cell = event.target.closest('button.cell');
    if (cell) open(cards.find((card) => card.dataset.source === cell.dataset.source));
  });
  dialog.querySelector('button.close').addEventListener('click', () => dialog.close());
  // A click beside the dialog closes it too.
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close());
  filter();
  return {cards: () => Array.from(gallery.querySelectorAll('.card:not([hidden])')), open};
})();
