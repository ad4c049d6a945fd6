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
  SVG: { font: "TeX", linebreaks: { automatic: true } },
  showMathMenu: false,
  messageStyle: "none"
});
// A formula on a line of its own is broken where it is too long; one in a sentence or in a table's cell never is.
MathJax.Hub.Register.StartupHook("SVG Jax Ready", function () {
  var svg = MathJax.OutputJax.SVG, translate = svg.Translate;
  svg.Process = function (script, state) {
    var own = script.MathJax.elementJax.SVG;
    if (!own.display) own.lineWidth = 1e7;
    return translate.call(svg, script, state);
  };
});
