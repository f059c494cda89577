// A click on a column's head sorts the table by it; once more, the other way round.
for (const head of document.querySelectorAll('th')) {
  const sort = () => {
    const body = head.closest('table').tBodies[0];
    const up = head.getAttribute('aria-sort') !== 'ascending';
    for (const other of head.parentNode.children) other.removeAttribute('aria-sort');
    head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
    const cell = (row) => row.cells[head.cellIndex].textContent.trim();
    // What is no number comes last.
    const byNumber = (x, y) => (isNaN(x) ? (isNaN(y) ? 0 : 1) : isNaN(y) ? -1 : x - y);
    const order = (a, b) => head.classList.contains('t') ?
        cell(a).localeCompare(cell(b), undefined, {numeric: true}) :
        byNumber(parseFloat(cell(a)), parseFloat(cell(b)));
    body.append(...Array.from(body.rows).sort((a, b) => up ? order(a, b) : -order(a, b)));
  };
  head.tabIndex = 0;
  head.addEventListener('click', sort);
  head.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    sort();
  });
}

// What a marked word means, beside it while it is pointed at, has the focus or was tapped.
{
  const hint = document.createElement('div');
  hint.className = 'hint';
  hint.setAttribute('role', 'tooltip');
  hint.hidden = true;
  document.body.append(hint);
  const show = (word) => {
    hint.textContent = document.getElementById(word.getAttribute('aria-describedby')).textContent;
    hint.hidden = false;
    const place = word.getBoundingClientRect(), size = hint.getBoundingClientRect();
    const below = place.bottom + 6 + size.height < innerHeight;
    hint.style.left = Math.max(8, Math.min(place.left, innerWidth - size.width - 8)) + 'px';
    hint.style.top = (below ? place.bottom + 6 : Math.max(8, place.top - size.height - 6)) + 'px';
  };
  const hide = () => { hint.hidden = true; };
  for (const word of document.querySelectorAll('.term')) {
    for (const kind of ['pointerenter', 'focus', 'click']) {
      word.addEventListener(kind, () => show(word));
    }
    for (const kind of ['pointerleave', 'blur']) word.addEventListener(kind, hide);
  }
  addEventListener('keydown', (event) => { if (event.key === 'Escape') hide(); });
  addEventListener('scroll', () => {
    const word = document.activeElement;
    if (word && word.classList.contains('term') && !hint.hidden) show(word);
    else hide();
  }, {passive: true});
}

// The section that is in view, in the contents.
{
  const links = new Map(Array.from(document.querySelectorAll('nav.contents a'),
                                   (link) => [link.hash.slice(1), link]));
  const current = new IntersectionObserver((entries) => {
    for (const {isIntersecting, target} of entries) {
      if (!isIntersecting) continue;
      for (const link of links.values()) link.removeAttribute('aria-current');
      links.get(target.id).setAttribute('aria-current', 'true');
    }
  }, {rootMargin: '-10% 0px -80% 0px'});
  for (const id of links.keys()) current.observe(document.getElementById(id));
}
