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
