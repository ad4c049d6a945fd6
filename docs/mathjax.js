// Read by every page before MathJax starts. Listings are left alone: an \eqref quoted in code is not a formula.
MathJax.Hub.Config({
  tex2jax: { ignoreClass: "tex2jax_ignore|fragment" },
  TeX: {
    equationNumbers: { autoNumber: "AMS" },
    Macros: {
      dd: "{\\mathrm{d}}",
      norm: ["{\\lVert #1 \\rVert}", 1]
    }
  },
  SVG: { font: "TeX", linebreaks: { automatic: false } },
  showMathMenu: false,
  messageStyle: "none"
});
