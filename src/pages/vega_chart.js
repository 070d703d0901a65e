"use strict";

/** Charts by vega-lite in the page's own colours. */
const vega_chart = {
  config: {
    background: null, font: "system-ui, Liberation Sans, sans-serif",
    view: {stroke: null},
    axis: {labelColor: "var(--ink)", titleColor: "var(--faint)", domainColor: "var(--rule)",
           gridColor: "var(--rule)", tickColor: "var(--rule)", labelFontSize: 12,
           titleFontSize: 12, titleFontWeight: "normal", labelLimit: 110},
    header: {labelColor: "var(--ink)", labelFontSize: 12},
  },

  /** A scale over `named`, [value of the field, model], of what `range` says of a model. */
  by_model(named, field, range) {
    return {field, type: "nominal", legend: null,
            scale: {domain: named.map(([value]) => value),
                    range: named.map(([, model]) => range(model))}};
  },

  color(named, field = "model") { return vega_chart.by_model(named, field, palette.colour); },

  stroke_dash(named, field = "model") {
    const solid = [1, 0];
    return vega_chart.by_model(named, field, (model) => {
      const dashes = palette.dashes(model);
      return dashes.length > 0 ? dashes : solid;
    });
  },

  /** A place for a chart below its title. */
  place(title, element) {
    const heading = document.createElement("h4"), picture = document.createElement("div");
    heading.textContent = title;
    element.append(heading, picture);
    return picture;
  },

  draw(spec, element) {
    const compiled = vegaLite.compile(spec, {config: vega_chart.config});
    new vega.View(vega.parse(compiled.spec, null, {ast: true}),
                  {expr: vega.expressionInterpreter, renderer: "svg", container: element,
                   logLevel: vega.Warn}).run();
  },
};
