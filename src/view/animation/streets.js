"use strict";
// Names of streets, written along them where there is room: long lines first, none over another.

const kStreetFont = "600 12px system-ui, sans-serif";
const kNameHeight = 16;   // [pixels] with some room
const kMostBend = 5;      // [pixels] a line bends at most so far from its name
const kApart = 260;       // [pixels] so far apart a name is written again
const kTries = 9;         // places along a line that are tried

class Streets {
  // Points come as x, y, x, y in cm.
  constructor(streets) {
    this.lines = streets.map(({name, points}) => {
      const places = [];
      for (let i = 0; i < points.length; i += 2) {
        places.push([points[i] / kPerMetre, points[i + 1] / kPerMetre]);
      }
      let length = 0;
      for (let i = 1; i < places.length; ++i) {
        length += Math.hypot(places[i][0] - places[i - 1][0], places[i][1] - places[i - 1][1]);
      }
      return {name, places, length};
    }).sort((a, b) => b.length - a.length);
    this.widths = new Map();
  }

  width(context, name) {
    if (!this.widths.has(name)) this.widths.set(name, context.measureText(name).width);
    return this.widths.get(name);
  }

  // The context is in pixels of the page; `to_screen` takes metres to them.
  draw(context, theme, camera, to_screen, width, height) {
    context.font = kStreetFont;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineWidth = 3;
    this.placed = [];
    for (const line of this.lines) {
      const room = this.width(context, line.name) + 8;
      if (line.length * camera.scale < room) continue;
      const points = line.places.map(([x, y]) => to_screen(x, y));
      const place = this.place(points, room, line.name, width, height);
      if (!place) continue;
      this.placed.push(place);
      this.write(context, theme, place);
    }
  }

  write(context, theme, {name, x, y, angle}) {
    context.save();
    context.translate(x, y);
    context.rotate(angle);
    context.strokeStyle = theme.colour("ground");
    context.globalAlpha = 0.85;
    context.strokeText(name, 0, 0);
    context.globalAlpha = 1;
    context.fillStyle = theme.colour("street-name");
    context.fillText(name, 0, 0);
    context.restore();
  }

  // Where a name of that length fits along the points [pixels], nearest to the line's middle; null
  // where it does not.
  place(points, room, name, width, height) {
    const at = [0];
    for (let i = 1; i < points.length; ++i) {
      at.push(at[i - 1] + Math.hypot(points[i][0] - points[i - 1][0],
                                     points[i][1] - points[i - 1][1]));
    }
    const total = at[at.length - 1], free = total - room;
    for (let k = 0; k < kTries; ++k) {
      const off = Math.ceil(k / 2) * (k % 2 ? 1 : -1) / (kTries - 1);
      const begin = free * (0.5 + off);
      const place = Streets.along(points, at, begin, begin + room);
      if (!place) continue;
      const {x, y, reach_x, reach_y} = place;
      if (x - reach_x < 0 || x + reach_x > width) continue;
      if (y - reach_y < 0 || y + reach_y > height) continue;
      if (this.placed.every((other) => Streets.apart(other, place, other.name === name))) {
        return {name, ...place};
      }
    }
    return null;
  }

  // The straight name over that part of a line; null where the line bends away from it.
  static along(points, at, begin, end) {
    const point = (s) => {
      let i = 1;
      while (i < at.length - 1 && at[i] < s) ++i;
      const share = (s - at[i - 1]) / (at[i] - at[i - 1] || 1);
      return [0, 1].map((c) => points[i - 1][c] + share * (points[i][c] - points[i - 1][c]));
    };
    const [ax, ay] = point(begin), [bx, by] = point(end);
    const length = Math.hypot(bx - ax, by - ay), room = end - begin;
    if (length < 0.97 * room) return null;
    const ux = (bx - ax) / length, uy = (by - ay) / length;
    for (let i = 0; i < points.length; ++i) {
      if (at[i] <= begin || at[i] >= end) continue;
      const away = Math.abs(ux * (points[i][1] - ay) - uy * (points[i][0] - ax));
      if (away > kMostBend) return null;
    }
    let angle = Math.atan2(uy, ux); // never upside down
    if (angle > Math.PI / 2) angle -= Math.PI;
    if (angle <= -Math.PI / 2) angle += Math.PI;
    return {x: (ax + bx) / 2, y: (ay + by) / 2, angle, half: room / 2,
            reach_x: room / 2 * Math.abs(ux) + kNameHeight / 2,
            reach_y: room / 2 * Math.abs(uy) + kNameHeight / 2};
  }

  // Whether two names do not touch: discs along one against discs along the other.
  static apart(a, b, same) {
    const between = Math.hypot(a.x - b.x, a.y - b.y);
    if (same && between < kApart) return false;
    if (between > a.half + b.half + kNameHeight) return true;
    const discs = ({x, y, angle, half}) => {
      const count = Math.max(1, Math.ceil(2 * half / kNameHeight));
      return Array.from({length: count}, (_, i) => {
        const s = -half + (i + 0.5) * 2 * half / count;
        return [x + s * Math.cos(angle), y + s * Math.sin(angle)];
      });
    };
    const others = discs(b);
    return discs(a).every(([x, y]) => others.every(
      ([ox, oy]) => Math.hypot(x - ox, y - oy) > 1.15 * kNameHeight));
  }
}
