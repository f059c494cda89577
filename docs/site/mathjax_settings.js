// Settings of MathJax 2 on the site. It draws the formulas that pymdownx.arithmatex marks as SVG; the fonts of
// SVG output are scripts, which browsers also load from files.
window.MathJax = {
  config: ["TeX-AMS_SVG.js"],
  messageStyle: "none",
  tex2jax: {inlineMath: [["\\(", "\\)"]], displayMath: [["\\[", "\\]"]], ignoreClass: ".*", processClass: "arithmatex"},
  // The theme makes displayed formulas as narrow as their content, which has no width before it is drawn.
  styles: {".md-typeset div.arithmatex > .MathJax_SVG_Display": {width: "auto !important"}},
};
