"use strict";

/** Which gaps between vehicles people take: counted by seconds, and as a curve, by vega-lite. */
const gaps = {
  apart: 0.035, // share: medians of several models lie beside each other at a half

  /** Points [gap, share, number of gaps] of all models as rows. */
  rows(data, groups, part) {
    return groups.flatMap(({m, [part]: points = []}) => points.map(
      ([gap, share, count]) => ({model: data.models[m], gap, share, count})));
  },

  medians(data, groups) {
    return groups.filter((one) => one.median !== undefined).map(
      ({m, median, interval = [median, median]}, i, {length}) => ({
        model: data.models[m], median, low: interval[0], high: interval[1],
        share: 0.5 + gaps.apart * ((length - 1) / 2 - i)}));
  },

  spec(data, groups, width) {
    const named = palette.named(data), medians = gaps.medians(data, groups);
    const x = (field) => ({field, type: "quantitative", title: "gap, s", axis: {tickCount: 5},
                           scale: {domain: [0, data.gaps.longest], nice: false}});
    const tooltip = (...fields) => fields.map((field) => ({field}));
    const layer = (values, mark, encoding) => ({data: {values}, mark, encoding});
    return {
      width, height: 170,
      layer: [
        layer(gaps.rows(data, groups, "counted"), {type: "circle", opacity: 0.55},
              {x: x("gap"), tooltip: tooltip("model", "gap", "share", "count"),
               size: {field: "count", type: "quantitative", legend: null,
                      scale: {zero: true, rangeMin: 16, rangeMax: 180}}}),
        layer(gaps.rows(data, groups, "curve"), {type: "line", strokeWidth: 2},
              {x: x("gap"), strokeDash: vega_chart.stroke_dash(named), order: {value: null}}),
        layer(medians, {type: "rule", strokeWidth: 2.5, clip: true},
              {x: x("low"), x2: {field: "high"}}),
        layer(medians, {type: "point", shape: "diamond", filled: true, size: 110, opacity: 1,
                        stroke: "var(--page)", strokeWidth: 1},
              {x: x("median"), tooltip: tooltip("model", "median", "low", "high")}),
      ],
      encoding: {
        y: {field: "share", type: "quantitative", title: "share taken", scale: {domain: [0, 1]},
            axis: {format: "%", values: [0, 0.25, 0.5, 0.75, 1]}},
        color: vega_chart.color(named),
      },
    };
  },

  /** Where nobody crosses between the junctions there is nothing to draw. */
  draw_all(data) {
    if (!data.gaps) return;
    const {groups} = data.gaps, element = document.getElementById("gap-charts");
    const drawn = new Set(groups.map((one) => one.m));
    palette.show_keys(palette.named(data).filter(([, model]) => drawn.has(model)),
                      document.getElementById("gap-keys"));
    data.conditions.forEach((condition, c) => {
      const here = groups.filter((one) => one.c === c);
      if (here.length === 0) return;
      const chart = document.createElement("div");
      chart.className = "chart";
      element.append(chart);
      const width = Math.max(140, chart.clientWidth - 62); // [pixels] but for the axis
      vega_chart.draw(gaps.spec(data, here, width), vega_chart.place(condition, chart));
    });
  },
};
