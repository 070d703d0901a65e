"use strict";

/** How the runs of each model spread: a box and points for each measure, by vega-lite. */
const distributions = {
  jitter: 0.61803398875, // golden section: neighbours lie apart, the same each time
  many: 12, // boxes: more are drawn closer

  /** Boxes and points as rows of one table: facets have but one. */
  rows(data, measure) {
    const rows = [];
    for (const {c, m, n, box, points} of measure.groups) {
      const where = {condition: data.conditions[c], model: data.models[m]};
      const [least, quartile1, median, quartile3, most] = box;
      rows.push({...where, kind: "box", least, quartile1, median, quartile3, most, n});
      points.forEach(([value, seed], i) => {
        rows.push({...where, kind: "run", value, seed, offset: (i * distributions.jitter) % 1});
      });
    }
    return rows;
  },

  layers(data, measure) {
    const y = {field: "model", type: "nominal", sort: data.models, title: null};
    const color = vega_chart.color(palette.named(data));
    const x = (field) => ({field, type: "quantitative", title: measure.unit || null,
                           scale: {zero: false}, axis: {tickCount: 5}});
    const layer = (kind, mark, encoding) => ({
      transform: [{filter: `datum.kind === '${kind}'`}], mark, encoding: {...encoding, y, color}});
    const numbers = ["model", "n", "least", "quartile1", "median", "quartile3", "most"];
    return [
      layer("box", {type: "rule", strokeWidth: 1.5}, {x: x("least"), x2: {field: "most"}}),
      layer("box", {type: "bar", height: 16, fillOpacity: 0.35},
            {x: x("quartile1"), x2: {field: "quartile3"},
             tooltip: numbers.map((field) => ({field}))}),
      layer("run", {type: "circle", size: 14, opacity: 0.8},
            {x: x("value"), tooltip: [{field: "seed"}, {field: "value"}],
             yOffset: {field: "offset", type: "quantitative", scale: {domain: [-0.6, 1.6]}}}),
      layer("box", {type: "tick", size: 22, thickness: 3}, {x: x("median")}),
    ];
  },

  spec(data, measure, width) {
    const values = distributions.rows(data, measure);
    const step = measure.groups.length > distributions.many ? 22 : 34; // [pixels] of a box
    const picture = {width, height: {step}, layer: distributions.layers(data, measure)};
    if (data.conditions.length === 1) return {data: {values}, ...picture};
    const header = {title: null, orient: "top", labelAnchor: "start", labelFontWeight: 600,
                    labelPadding: 2, labelLimit: width};
    return {data: {values}, spacing: 6, spec: picture,
            facet: {row: {field: "condition", type: "nominal", sort: data.conditions, header}}};
  },

  draw(data, measure, element) {
    const title = measure.label.charAt(0).toUpperCase() + measure.label.slice(1);
    const picture = vega_chart.place(title, element);
    const room = 120; // [pixels] for names of models
    const width = Math.max(120, element.clientWidth - room);
    vega_chart.draw(distributions.spec(data, measure, width), picture);
  },

  draw_all(data, element) {
    for (const measure of data.distributions) {
      const chart = document.createElement("div");
      chart.className = "chart";
      element.append(chart);
      distributions.draw(data, measure, chart);
    }
  },
};
