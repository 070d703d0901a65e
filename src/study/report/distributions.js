"use strict";

/** How the runs of each model spread: a box and points for each measure, by vega-lite. */
const distributions = {
  jitter: 0.61803398875, // golden section: neighbours lie apart, the same each time

  rows(data, measure) {
    const boxes = [], points = [];
    for (const {c, m, n, box, points: runs} of measure.groups) {
      const where = {condition: data.conditions[c], model: data.models[m]};
      const [least, quartile1, median, quartile3, most] = box;
      boxes.push({...where, least, quartile1, median, quartile3, most, n});
      runs.forEach(([value, seed], i) => {
        points.push({...where, value, seed, offset: (i * distributions.jitter) % 1});
      });
    }
    return {boxes, points};
  },

  spec(data, measure, width) {
    const {boxes, points} = distributions.rows(data, measure);
    const y = {field: "model", type: "nominal", sort: data.models, title: null};
    const colour = {
      field: "model", type: "nominal", legend: null,
      scale: {domain: data.models,
              range: data.models.map((_, model) => `var(${palette.variable(data, model)})`)}};
    const x = (field) => ({field, type: "quantitative", title: measure.unit || null,
                           scale: {zero: false, nice: true}, axis: {tickCount: 5}});
    const layer = [
      {data: {values: boxes}, mark: {type: "rule", strokeWidth: 1.5},
       encoding: {x: x("least"), x2: {field: "most"}, y, color: colour}},
      {data: {values: boxes}, mark: {type: "bar", height: 16, fillOpacity: 0.35, strokeWidth: 1.5},
       encoding: {x: x("quartile1"), x2: {field: "quartile3"}, y, color: colour,
                  tooltip: ["model", "n", "least", "quartile1", "median", "quartile3", "most"].map(
                    (field) => ({field}))}},
      {data: {values: points}, mark: {type: "circle", size: 14, opacity: 0.8},
       encoding: {x: x("value"), y, color: colour,
                  yOffset: {field: "offset", type: "quantitative", scale: {domain: [-0.6, 1.6]}},
                  tooltip: [{field: "seed"}, {field: "value"}]}},
      {data: {values: boxes}, mark: {type: "tick", size: 22, thickness: 3},
       encoding: {x: x("median"), y, color: colour}},
    ];
    return {width, height: {step: 34}, layer};
  },

  config: {
    background: null, font: "system-ui, Liberation Sans, sans-serif",
    view: {stroke: null},
    axis: {labelColor: "var(--ink)", titleColor: "var(--faint)", domainColor: "var(--rule)",
           gridColor: "var(--rule)", tickColor: "var(--rule)", labelFontSize: 12,
           titleFontSize: 12, titleFontWeight: "normal", labelLimit: 110},
  },

  draw(data, measure, element) {
    const title = document.createElement("h4"), picture = document.createElement("div");
    title.textContent = measure.label.charAt(0).toUpperCase() + measure.label.slice(1);
    element.append(title, picture);
    const room = 120; // [pixels] for names of models
    const width = Math.max(120, element.clientWidth - room);
    const {spec} = vegaLite.compile(distributions.spec(data, measure, width),
                                    {config: distributions.config});
    new vega.View(vega.parse(spec, null, {ast: true}),
                  {expr: vega.expressionInterpreter, renderer: "svg", container: picture,
                   logLevel: vega.Warn}).run();
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
