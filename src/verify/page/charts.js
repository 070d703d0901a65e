"use strict";

/** A test's curves with what was published beside them, by vega-lite. */
const charts = {
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
                   mark: {type: "area", color: "var(--accent)", opacity: 0.16},
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
    const named = palette.named(data);
    const color = vega_chart.color(named), strokeDash = vega_chart.stroke_dash(named);
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

  /** What is drawn beside the models, in words. */
  key(chart) {
    const names = chart.references.map(
      (one) => `${one.joined ? "dotted" : "diamonds"}: ${one.name}`);
    if (chart.band.length > 0) names.push("shaded: the limits");
    return names.join("; ");
  },

  draw(data, chart, element) {
    const picture = vega_chart.place(chart.title, element);
    const width = Math.max(160, element.clientWidth - 60); // [pixels] but for the axis
    vega_chart.draw({width, height: 240, layer: [...charts.published(chart),
                                                 ...charts.models(data, chart)]}, picture);
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
