"use strict";
// What does not move: ground, roads, zone, obstacles, waypoints. Drawn once for each view of the
// camera on a canvas of its own.

// Rings and lines come as x, y, x, y in cm.
function add_points(path, points, closed) {
  for (let i = 0; i < points.length; i += 2) {
    const x = points[i] / kPerMetre, y = points[i + 1] / kPerMetre;
    if (i === 0) path.moveTo(x, y); else path.lineTo(x, y);
  }
  if (closed) path.closePath();
}

function area_path(regions) {
  const path = new Path2D();
  for (const region of regions) for (const ring of region) add_points(path, ring, true);
  return path;
}

class Scenery {
  constructor(data) {
    this.junctions = area_path(data.junctions.map((ring) => [ring]));
    this.roads = Scenery.by_width(data.roads);
    this.footways = Scenery.by_width(data.footways);
    this.footways_inside = area_path(data.footareas.map((ring) => [ring]));
    this.zone = area_path(data.zone);
    this.obstacles = area_path(data.obstacles);
    this.waypoints = data.waypoints;
    this.streets = new Streets(data.streets);
    this.canvas = document.createElement("canvas");
    this.drawn = "";
  }

  // Lines of one width are one path.
  static by_width(lines) {
    const paths = new Map();
    for (const {width, points} of lines) {
      if (!paths.has(width)) paths.set(width, new Path2D());
      add_points(paths.get(width), points, false);
    }
    return paths;
  }

  // The picture for a camera and size [device pixels], with `ratio` device pixels a pixel.
  picture(camera, theme, width, height, ratio, names) {
    const wanted = [camera.version, theme.dark, width, height, ratio, names].join();
    if (wanted === this.drawn) return this.canvas;
    this.drawn = wanted;
    this.canvas.width = width;
    this.canvas.height = height;
    const context = this.canvas.getContext("2d");
    context.fillStyle = theme.colour("ground");
    context.fillRect(0, 0, width, height);
    const scale = camera.scale * ratio;
    context.setTransform(scale, 0, 0, -scale, width / 2 - camera.x * scale,
                         height / 2 + camera.y * scale);
    this.draw(context, theme, 1 / camera.scale);
    if (names) this.draw_names(context, theme, camera, width / ratio, height / ratio, ratio);
    return this.canvas;
  }

  draw_names(context, theme, camera, width, height, ratio) {
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const to_screen = (x, y) => [width / 2 + (x - camera.x) * camera.scale,
                                 height / 2 - (y - camera.y) * camera.scale];
    this.streets.draw(context, theme, camera, to_screen, width, height);
  }

  // `pixel`: [m]
  draw(context, theme, pixel) {
    const fill = (path, colour) => {
      context.fillStyle = theme.colour(colour);
      context.fill(path, "evenodd");
    };
    const outline = (path, colour, width) => {
      context.strokeStyle = theme.colour(colour);
      context.lineWidth = width * pixel;
      context.stroke(path);
    };
    context.lineJoin = context.lineCap = "round";
    const lanes = (paths, colour) => {
      context.strokeStyle = theme.colour(colour);
      for (const [width, path] of paths) {
        context.lineWidth = width / kPerMetre;
        context.stroke(path);
      }
    };
    fill(this.junctions, "road");
    context.lineCap = "butt";
    lanes(this.roads, "road");
    lanes(this.footways, "footway");
    fill(this.footways_inside, "footway");
    fill(this.zone, "zone");
    fill(this.obstacles, "obstacle");
    outline(this.obstacles, "obstacle-edge", 1);
    outline(this.zone, "zone-edge", 1.5);
    for (const waypoint of this.waypoints) this.draw_waypoint(context, theme, waypoint, pixel);
  }

  draw_waypoint(context, theme, {x, y, radius}, pixel) {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = theme.colour("waypoint");
    context.globalAlpha = 0.15;
    context.fill();
    context.globalAlpha = 1;
    context.setLineDash([5 * pixel, 4 * pixel]);
    context.lineWidth = 1.5 * pixel;
    context.strokeStyle = theme.colour("waypoint");
    context.stroke();
    context.setLineDash([]);
    draw_star(context, x, y, 2.2 * least_radius(1 / pixel) * pixel);
    context.fillStyle = theme.colour("waypoint");
    context.fill();
  }
}

function draw_star(context, x, y, size) {
  context.beginPath();
  for (let i = 0; i < 10; ++i) {
    const angle = Math.PI * (0.5 + i / 5), reach = i % 2 ? 0.42 * size : size;
    context.lineTo(x + reach * Math.cos(angle), y + reach * Math.sin(angle));
  }
  context.closePath();
}
