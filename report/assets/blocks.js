// A block under the pointer is highlighted in all diagrams of the page.
{
  let marks = [];
  document.addEventListener('pointerover', (event) => {
    for (const mark of marks) mark.classList.remove('lit');
    marks = [];
    const mark = event.target.closest && event.target.closest('[data-block]');
    if (!mark) return;
    marks = document.querySelectorAll(`[data-block="${mark.dataset.block}"]`);
    for (const one of marks) one.classList.add('lit');
  });
}
