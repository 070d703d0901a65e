"use strict";

/** A test's curves with what was published beside them, by vega-lite. */
const charts = {
  solid: 5, // models; more are dashed, since so many colours are not told apart by everybody
  dash(index) { return index >= charts.solid ? [6, 3] : [1, 0]; },

  model_rows(data, chart) {
    return chart.curves.flatMap((curve, m) => curve.map(
      ([x, y, least, most]) => ({model: data.models[m], x, y, least, most})));
  },

  reference_rows(chart, joined) {
    return chart.references.filter((one) => one.joined === joined).flatMap(
      (one) => one.points.map(([x, y]) => ({name: one.name, x, y})));
  },

  axis(field, title) {
    return {field, type: "quantitative", title, scale: {zero: field === "y", nice: true},
            axis: {tickCount: 6}};
  },

  published(chart) {
    const x = charts.axis("x", chart.xTitle), y = charts.axis("y", chart.yTitle);
    const layers = [];
    if (chart.band.length > 0) {
      layers.push({data: {values: chart.band.map(([at, low, high]) => ({x: at, low, high}))},
                   mark: {type: "area", color: "var(--better)", opacity: 0.16},
                   encoding: {x, y: {...y, field: "low"}, y2: {field: "high"}}});
    }
    const tooltip = [{field: "name"}, {field: "x"}, {field: "y"}];
    const joined = charts.reference_rows(chart, true), points = charts.reference_rows(chart, false);
    if (joined.length > 0) {
      layers.push({data: {values: joined},
                   mark: {type: "line", color: "var(--ink)", strokeDash: [2, 3], strokeWidth: 1.5},
                   encoding: {x, y, detail: {field: "name"}, tooltip}});
    }
    if (points.length > 0) {
      layers.push({data: {values: points},
                   mark: {type: "point", shape: "diamond", filled: true, size: 90, opacity: 1,
                          color: "var(--ink)"},
                   encoding: {x, y, tooltip}});
    }
    return layers;
  },

  models(data, chart) {
    const x = charts.axis("x", chart.xTitle), y = charts.axis("y", chart.yTitle);
    const color = {field: "model", type: "nominal", legend: null,
                   scale: {domain: data.models,
                           range: data.models.map((_, m) => `var(${palette.variable(data, m)})`)}};
    const strokeDash = {field: "model", type: "nominal", legend: null,
                        scale: {domain: data.models,
                                range: data.models.map((_, m) => charts.dash(m))}};
    const values = charts.model_rows(data, chart);
    return [
      {data: {values}, mark: {type: "line", strokeWidth: 2}, encoding: {x, y, color, strokeDash}},
      {data: {values}, mark: {type: "rule", strokeWidth: 1.5},
       encoding: {x, y: {...y, field: "least"}, y2: {field: "most"}, color}},
      {data: {values}, mark: {type: "circle", size: 38, opacity: 1},
       encoding: {x, y, color, tooltip: ["model", "x", "y", "least", "most"].map(
         (field) => ({field}))}},
    ];
  },

  config: {
    background: null, font: "system-ui, Liberation Sans, sans-serif",
    view: {stroke: null},
    axis: {labelColor: "var(--ink)", titleColor: "var(--faint)", domainColor: "var(--rule)",
           gridColor: "var(--rule)", tickColor: "var(--rule)", labelFontSize: 12,
           titleFontSize: 12, titleFontWeight: "normal"},
  },

  /** What is drawn beside the models, in words. */
  key(chart) {
    const names = chart.references.map(
      (one) => `${one.joined ? "dotted" : "diamonds"}: ${one.name}`);
    if (chart.band.length > 0) names.push("shaded: the limits");
    return names.join("; ");
  },

  draw(data, chart, element) {
    const title = document.createElement("h4"), picture = document.createElement("div");
    title.textContent = chart.title;
    element.append(title, picture);
    const width = Math.max(160, element.clientWidth - 60); // [pixels] but for the axis
    const spec = {width, height: 240, layer: [...charts.published(chart),
                                              ...charts.models(data, chart)]};
    const compiled = vegaLite.compile(spec, {config: charts.config});
    new vega.View(vega.parse(compiled.spec, null, {ast: true}),
                  {expr: vega.expressionInterpreter, renderer: "svg", container: picture,
                   logLevel: vega.Warn}).run();
    const note = document.createElement("p");
    note.className = "note";
    note.textContent = charts.key(chart);
    if (note.textContent) element.append(note);
  },

  draw_test(data, element) {
    for (const chart of data.tests[element.dataset.test]) {
      const place = document.createElement("div");
      place.className = "chart";
      element.append(place);
    }
    [...element.children].forEach(
      (place, i) => charts.draw(data, data.tests[element.dataset.test][i], place));
  },
};
