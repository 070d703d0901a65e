"use strict";
// What can be switched on over the map: ways of the last seconds, and how crowded it is.

const kTrail = 10;           // [s]
const kSpread = 1;           // [m] standard deviation of the room a person counts in
const kReach = 2.5 * kSpread;
const kLeastCell = 0.5;      // [m] of the density's grid ...
const kCellPixels = 2;       // [pixels] ... or larger
const kFaint = 0.1;          // of the density of one person alone: less is nobody ...
const kFull = 0.5;           // ... from here on it is not fainter
const kDensityAlpha = 0.62;

// Where those who are there have come along.
function draw_trails(panel) {
  const context = panel.scene, {x, y} = panel.recording;
  const since = panel.recording.frame_at(panel.time - kTrail).frame;
  const draw = (poses, width, colour_of) => {
    const lines = new Map(); // those of one colour are one path
    for (const pose of poses) {
      const colour = colour_of(pose);
      if (!lines.has(colour)) lines.set(colour, new Path2D());
      const line = lines.get(colour);
      const first = Math.max(pose.begin, pose.sample - (pose.frame - since));
      line.moveTo(...panel.to_screen(x[first] / kPerMetre, y[first] / kPerMetre));
      for (let i = first + 1; i <= pose.sample; ++i) {
        line.lineTo(...panel.to_screen(x[i] / kPerMetre, y[i] / kPerMetre));
      }
      line.lineTo(...panel.to_screen(pose.x, pose.y));
    }
    context.lineWidth = width;
    for (const [colour, line] of lines) {
      context.strokeStyle = panel.theme.colour(colour);
      context.stroke(line);
    }
  };
  context.globalAlpha = 0.45;
  draw(panel.vehicles, 4, () => "vehicle");
  draw(panel.persons, 2, (pose) => activity_look(panel.recording.doing(pose).activity).colour);
  context.globalAlpha = 1;
}

// Persons per square metre, each spread over the room around it, in the colours of its level of
// service.
class Density {
  constructor(levels) {
    this.levels = levels.map(({least, colour}) => ({
      least, rgb: [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16))}));
    this.canvas = document.createElement("canvas");
  }

  // A grid over what the panel shows.
  measure(panel) {
    const {camera, canvas} = panel;
    const cell = Math.max(kLeastCell, kCellPixels / camera.scale);
    const columns = Math.ceil(canvas.clientWidth / camera.scale / cell) + 1;
    const rows = Math.ceil(canvas.clientHeight / camera.scale / cell) + 1;
    const west = camera.x - canvas.clientWidth / 2 / camera.scale;
    const north = camera.y + canvas.clientHeight / 2 / camera.scale;
    const values = new Float32Array(columns * rows);
    const spread = Math.max(kSpread, cell), reach = Math.max(kReach, 2.5 * cell);
    const peak = 1 / (2 * Math.PI * spread * spread);
    for (const {x, y} of panel.persons) {
      const left = Math.max(0, Math.ceil((x - reach - west) / cell - 0.5));
      const right = Math.min(columns - 1, Math.floor((x + reach - west) / cell - 0.5));
      const top = Math.max(0, Math.ceil((north - y - reach) / cell - 0.5));
      const bottom = Math.min(rows - 1, Math.floor((north - y + reach) / cell - 0.5));
      for (let row = top; row <= bottom; ++row) {
        const dy = north - (row + 0.5) * cell - y;
        for (let column = left; column <= right; ++column) {
          const dx = west + (column + 0.5) * cell - x;
          values[row * columns + column] +=
            peak * Math.exp(-(dx * dx + dy * dy) / (2 * spread * spread));
        }
      }
    }
    return {cell, columns, rows, values, peak};
  }

  draw(panel) {
    const {cell, columns, rows, values, peak} = this.measure(panel);
    Object.assign(this.canvas, {width: columns, height: rows});
    const own = this.canvas.getContext("2d"), image = own.createImageData(columns, rows);
    for (let i = 0; i < values.length; ++i) {
      if (values[i] < kFaint * peak) continue;
      let level = 0;
      while (level + 1 < this.levels.length && values[i] >= this.levels[level + 1].least) ++level;
      const [red, green, blue] = this.levels[level].rgb;
      image.data.set([red, green, blue, 255 * Math.min(1, values[i] / (kFull * peak))], 4 * i);
    }
    own.putImageData(image, 0, 0);
    const context = panel.scene, size = cell * panel.camera.scale;
    context.globalAlpha = kDensityAlpha;
    context.imageSmoothingEnabled = true;
    context.drawImage(this.canvas, 0, 0, columns * size, rows * size);
    context.globalAlpha = 1;
  }
}
