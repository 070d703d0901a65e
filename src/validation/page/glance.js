"use strict";

/** Key figures: for each model a dot with its interval, over that of the recording. */
const glance = {
  names: 132, numbers: 44, // [pixels] beside the picture

  spec(data, figure, width) {
    const x = {field: "value", type: "quantitative", title: null,
               scale: {domain: [0, figure.end]}, axis: {tickCount: 4}};
    const y = {field: "row", type: "nominal", title: null, sort: null,
               axis: {domain: false, ticks: false, grid: true, labelPadding: 6,
                      labelLimit: glance.names - 8, labelExpr: "split(datum.label, '\\n')[1]"}};
    const looks = figure.rows.map(({look}) => [String(look), look]);
    const color = vega_chart.color(looks, "look");
    // Rows are told apart by their looks: two models may have one name.
    const values = figure.rows.map((row) => ({
      ...row, look: String(row.look), row: `${row.look}\n${row.name}`}));
    const recorded = values.filter(({look}) => look === "recorded");
    const ends = {x: {...x, field: "low"}, x2: {field: "high"}};
    return {
      width, height: {step: 24}, data: {values},
      layer: [
        {data: {values: recorded}, mark: {type: "rect", color: "var(--ink)", opacity: 0.12},
         encoding: ends},
        {mark: {type: "rule", strokeWidth: 2.5}, encoding: {...ends, y, color}},
        {mark: {type: "circle", size: 90, opacity: 1},
         encoding: {x, y, color, tooltip: ["name", "value", "low", "high"].map(
           (field) => ({field}))}},
        {mark: {type: "text", align: "left", color: "var(--ink)", fontSize: 12},
         encoding: {x: {value: width + 8}, y, text: {field: "text"}}},
      ],
    };
  },

  draw_all(data, element) {
    for (const figure of data.glance[Number(element.dataset.glance)]) {
      const chart = document.createElement("div");
      chart.className = "chart";
      element.append(chart);
      const picture = vega_chart.place(figure.title, chart);
      const width = Math.max(100, chart.clientWidth - glance.names - glance.numbers);
      vega_chart.draw(glance.spec(data, figure, width), picture);
    }
  },
};
