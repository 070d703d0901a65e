"use strict";

/** Cumulative curves: which share of the persons had at most a value. */
const curves = {
  /** What is drawn, [name, look]: the recording first, then the page's model and the others. */
  named(data) {
    return [["recorded", "recorded"],
            ...[...data.drawn].reverse().map((model) => [data.models[model], model])];
  },

  /** A step up at each of the sorted values. */
  steps(look, values, end) {
    const points = values.map((value, i) => ({look, value, share: (i + 1) / values.length}));
    return [{look, value: 0, share: 0}, ...points, {look, value: end, share: 1}];
  },

  /** That of the recording lies below the others, that of the page's model on top. */
  spec(data, {measure, chart, end, width}) {
    const looks = ["recorded", ...data.drawn].map((look) => [String(look), look]);
    const mark = {type: "line", interpolate: "step-after", strokeJoin: "round"};
    const walked = data.drawn.flatMap(
      (model, i) => curves.steps(String(model), chart.walked[i], end));
    return {
      width, height: 150,
      layer: [
        {data: {values: curves.steps("recorded", chart.recorded, end)},
         mark: {...mark, strokeWidth: 3.5}},
        {data: {values: walked}, mark: {...mark, strokeWidth: 1.8}},
      ],
      encoding: {
        x: {field: "value", type: "quantitative", title: measure.unit,
            scale: {domain: [0, end], nice: false}, axis: {tickCount: 5}},
        y: {field: "share", type: "quantitative", title: "share of persons",
            scale: {domain: [0, 1]}, axis: {format: "%", values: [0, 0.25, 0.5, 0.75, 1]}},
        color: vega_chart.color(looks, "look"), strokeDash: vega_chart.stroke_dash(looks, "look"),
        order: {value: null},
      },
    };
  },

  /** Distances to the recording, as tables have them. */
  show_distances(data, chart, element) {
    const note = document.createElement("p");
    note.className = "keys distances";
    note.append("K-S: ");
    palette.show_keys(
      data.drawn.map((model, i) => [`${data.models[model]} ${chart.ks[i]}`, model]).reverse(),
      note);
    element.append(note);
  },

  draw_group(data, element) {
    const {ends, groups} = data.sets[element.dataset.set];
    const places = data.measures.map(() => {
      const place = document.createElement("div");
      place.className = "chart";
      element.append(place);
      return place;
    });
    groups[element.dataset.group].forEach((chart, k) => {
      const measure = data.measures[k], place = places[k];
      const width = Math.max(140, place.clientWidth - 62); // [pixels] but for the axis
      const title = measure.title.charAt(0).toUpperCase() + measure.title.slice(1);
      vega_chart.draw(curves.spec(data, {measure, chart, end: ends[k], width}),
                      vega_chart.place(title, place));
      curves.show_distances(data, chart, place);
    });
  },
};
