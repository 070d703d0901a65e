"use strict";

/** What happens over time: means and bands of each model, by uPlot. */
const lines = {
  quantities: [
    ["persons", "People in the zone"],
    ["personSpeed", "Speed of people in the zone, m/s"],
    ["density", "Density that people are in, persons/m²"],
    ["vehicleSpeed", "Speed of vehicles, m/s"],
  ],
  drawn: [], // {element, plot, make}

  /** The models' lines of a quantity, on one clock: uPlot's columns, bands before all lines. */
  columns(series, quantity) {
    const times = [...new Set(series.flatMap((one) => one.times))].sort((a, b) => a - b);
    const row = new Map(times.map((time, i) => [time, i]));
    const columns = [times];
    const add = (one, part) => {
      const column = new Array(times.length).fill(null);
      one.times.forEach((time, i) => { column[row.get(time)] = one.lines[quantity][part][i]; });
      columns.push(column);
    };
    for (const one of series) for (const part of ["low", "high"]) add(one, part);
    for (const one of series) add(one, "mean");
    return columns;
  },

  /** `scale`: how much larger than shown it is drawn. */
  options(data, series, width, scale) {
    const ink = palette.value("--ink"), rule = palette.value("--rule");
    const axis = {stroke: ink, font: `${11 * scale}px system-ui`, ticks: {stroke: rule, width: scale},
                  grid: {stroke: rule, width: scale}};
    const bands = [], edges = [], means = [];
    series.forEach((one, i) => {
      const colour = palette.value(`--model-${one.m}`), first = 1 + 2 * i;
      bands.push({series: [first + 1, first], fill: colour + "2e"});
      const edge = {stroke: colour + "00", width: 0, points: {show: false}};
      const wide = data.models[one.m] === data.reference; // to be seen below the others
      edges.push(edge, {...edge});
      means.push({stroke: colour, width: (wide ? 5 : 2) * scale, points: {show: false},
                  dash: palette.dashes(one.m).map((length) => length * scale)});
    });
    return {
      width: width * scale, height: 190 * scale, bands,
      series: [{}, ...edges, ...means],
      legend: {show: false}, cursor: {show: false},
      scales: {x: {time: false}, y: {range: (_, least, most) => [Math.min(0, least), 1.06 * most || 1]}},
      axes: [{...axis, values: (_, ticks) => ticks.map((time) => `${time} s`), space: 70 * scale,
              size: 30 * scale, gap: 4 * scale},
             {...axis, size: 46 * scale, space: 32 * scale, gap: 4 * scale}],
    };
  },

  chart(data, series, quantity, title, element) {
    const columns = lines.columns(series, quantity);
    if (!columns.slice(1).some((column) => column.some((value) => value !== null))) return;
    const chart = document.createElement("div"), heading = document.createElement("h4");
    chart.className = "chart";
    heading.textContent = title;
    chart.append(heading);
    element.append(chart);
    const one = {plot: null, draw(width, scale) {
      if (one.plot) one.plot.destroy();
      one.plot = new uPlot(lines.options(data, series, width, scale), columns, chart);
    }, chart};
    one.draw(chart.clientWidth, 1);
    lines.drawn.push(one);
  },

  /** Draws the charts of an element that is to be seen, once. */
  draw(data, element) {
    if (element.childElementCount > 0) return;
    const series = data.series[Number(element.dataset.series)];
    for (const [quantity, title] of lines.quantities) {
      lines.chart(data, series, quantity, title, element);
    }
  },

  paper_width: 320, // [pixels] half of what A4 has between its margins

  redraw(on_paper) {
    for (const one of lines.drawn) {
      if (on_paper) one.draw(lines.paper_width, 2); // the style sheet halves it: finer
      else if (one.chart.clientWidth > 0) one.draw(one.chart.clientWidth, 1);
    }
  },
};
