"use strict";

/** What happens over time: means and bands of each model, by vega-lite. */
const lines = {
  quantities: [
    ["persons", "People in the zone"],
    ["personSpeed", "Speed of people in the zone, m/s"],
    ["density", "Density that people are in, persons/m²"],
    ["vehicleSpeed", "Speed of vehicles, m/s"],
  ],

  /** One row for each model and moment; null where nobody was there: the line has a gap. */
  rows(data, series, quantity) {
    return series.flatMap(({m, times, lines: {[quantity]: {mean, low, high}}}) => times.map(
      (time, i) => ({model: data.models[m], time, mean: mean[i], low: low[i], high: high[i]})));
  },

  spec(data, rows, width) {
    const named = palette.named(data);
    const values = rows.flatMap(({low, high, mean}) => [low, high, mean]);
    const domain = [Math.min(0, ...values), 1.06 * Math.max(0, ...values) || 1];
    const y = (field) => ({field, type: "quantitative", title: null, scale: {domain, nice: false},
                           axis: {tickCount: 5}});
    const line = (values, strokeWidth) => ({
      data: {values}, mark: {type: "line", strokeJoin: "round", strokeWidth},
      encoding: {y: y("mean"), strokeDash: vega_chart.stroke_dash(named)}});
    const is_reference = ({model}) => model === data.reference;
    return {
      width, height: 150,
      layer: [
        {data: {values: rows}, mark: {type: "area", fillOpacity: 0.18},
         encoding: {y: y("low"), y2: {field: "high"}}},
        line(rows.filter(is_reference), 5), // below the others: wide, to be seen
        line(rows.filter((row) => !is_reference(row)), 2),
      ],
      encoding: {
        x: {field: "time", type: "quantitative", title: null, scale: {zero: false, nice: false},
            axis: {labelExpr: "datum.value + ' s'", tickCount: Math.ceil(width / 90)}},
        color: vega_chart.color(named),
      },
    };
  },

  /** Draws the charts of an element that is to be seen, once. */
  draw(data, element) {
    if (element.childElementCount > 0) return;
    const series = data.series[Number(element.dataset.series)];
    for (const [quantity, title] of lines.quantities) {
      const rows = lines.rows(data, series, quantity);
      if (rows.every(({mean}) => mean === null)) continue;
      const chart = document.createElement("div");
      chart.className = "chart";
      element.append(chart);
      const width = Math.max(140, chart.clientWidth - 50); // [pixels] but for the axis
      vega_chart.draw(lines.spec(data, rows, width), vega_chart.place(title, chart));
    }
  },
};
