"use strict";
// One run on its canvas.

const kPickReach = 20; // [pixels] so near a click takes somebody
const kDrawTimes = 400;
const kBySumo = "walked by SUMO"; // SUMO walks the person
const kPale = 0.4;

class Panel {
  constructor(stage, recording, context) {
    Object.assign(this, {recording, ...context}); // scenery, camera, theme, looks, layers, density
    this.figure = document.createElement("figure");
    this.caption = document.createElement("figcaption");
    this.name = document.createElement("b");
    this.count = document.createElement("span");
    this.caption.append(this.name, this.count);
    this.canvas = document.createElement("canvas");
    this.canvas.setAttribute("role", "img");
    this.figure.append(this.canvas, this.caption);
    stage.append(this.figure);
    this.name.textContent = recording.name;
    this.scene = this.canvas.getContext("2d", {alpha: false});
    this.persons = [];
    this.vehicles = [];
    this.draw_times = []; // [ms] of the latest pictures
  }

  // Adapts to the size on the screen; true where that has changed.
  resize() {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    const width = Math.round(this.canvas.clientWidth * ratio);
    const height = Math.round(this.canvas.clientHeight * ratio);
    if (this.canvas.width === width && this.canvas.height === height) return false;
    Object.assign(this.canvas, {width, height});
    this.ratio = ratio;
    return true;
  }

  to_screen(x, y) {
    return [this.canvas.clientWidth / 2 + (x - this.camera.x) * this.camera.scale,
            this.canvas.clientHeight / 2 - (y - this.camera.y) * this.camera.scale];
  }

  draw(time, selected) {
    const begin = performance.now();
    const recording = this.recording, context = this.scene;
    this.time = time;
    this.persons = recording.poses(recording.persons, time);
    this.vehicles = recording.poses(recording.vehicles, time);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.scenery.picture(this.camera, this.theme, this.canvas.width,
                                           this.canvas.height, this.ratio,
                                           this.layers.names), 0, 0);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.lineJoin = context.lineCap = "round";
    if (this.layers.density) this.density.draw(this);
    if (this.layers.trails) draw_trails(this);
    this.draw_way(selected);
    const figures = this.figures();
    draw_links(context, this.theme, this.groups(figures));
    for (const pose of this.vehicles) {
      const [x, y] = this.to_screen(pose.x, pose.y);
      draw_vehicle(context, this.theme, x, y, pose.heading, pose.track.length * this.camera.scale,
                   pose.track.width * this.camera.scale, this.camera.scale,
                   pose.track.part === 0);
    }
    for (const figure of figures) {
      if (figure.standing >= 0) draw_halo(context, this.theme, figure);
    }
    for (const figure of figures) {
      context.globalAlpha = figure.pale ? kPale : 1;
      draw_person(context, this.theme, figure);
    }
    context.globalAlpha = 1;
    for (const figure of figures) draw_letter(context, this.theme, figure);
    this.draw_selection(selected);
    this.draw_scale_bar();
    this.tell(figures);
    this.draw_times.push(performance.now() - begin);
    if (this.draw_times.length > kDrawTimes) this.draw_times.shift();
  }

  // Persons within the picture, ready to be drawn.
  figures() {
    const margin = 2 * this.camera.scale + 10, figures = [];
    for (const pose of this.persons) {
      const [x, y] = this.to_screen(pose.x, pose.y);
      if (x < -margin || x > this.canvas.clientWidth + margin) continue;
      if (y < -margin || y > this.canvas.clientHeight + margin) continue;
      const shape = this.looks.shape(pose.track.profile);
      const [along, across] = extent(pose.track, shape, this.camera.scale);
      const {motion, activity} = this.recording.doing(pose);
      const look = activity_look(activity);
      figures.push({x, y, heading: pose.heading, along, across, shape, colour: look.colour,
                    hollow: motion !== "walking" && motion !== kBySumo,
                    waiting: motion === "waiting", pale: motion === kBySumo,
                    standing: this.standing(pose), ring: this.looks.ring(pose.track.group),
                    group: pose.track.group, letter: look.letter});
    }
    return figures;
  }

  // Number of the halo of one who has stood for long; -1: none.
  standing(pose) {
    const stood = this.recording.stood(pose, this.time);
    return kStanding.findLastIndex(({least}) => stood >= least);
  }

  groups(figures) {
    const members = new Map();
    for (const figure of figures) {
      if (!figure.group) continue;
      if (!members.has(figure.group)) members.set(figure.group, []);
      members.get(figure.group).push(figure);
    }
    return [...members.values()].filter((all) => all.length > 1).map((all) => (
      {ring: all[0].ring, members: all, reach: kMostLink * this.camera.scale}));
  }

  tell(figures) {
    const persons = `${this.persons.length} person${this.persons.length === 1 ? "" : "s"}`;
    const driven = this.vehicles.filter(({track}) => track.part === 0).length;
    const vehicles = `${driven} vehicle${driven === 1 ? "" : "s"}`;
    const long = figures.filter(({standing}) => standing >= kStanding.indexOf(kCounted)).length;
    const stand = long ? `, ${long} stood ${kCounted.least} s` : "";
    const text = `${persons}, ${vehicles}${stand}`;
    if (this.count.textContent === text) return;
    this.count.textContent = text;
    this.canvas.setAttribute("aria-label", `${this.recording.name}: ${text}`);
  }

  pose_of(selected) {
    if (!selected) return null;
    const among = selected.kind === "person" ? this.persons : this.vehicles;
    return among.find((pose) => pose.track.id === selected.id) || null;
  }

  // The whole way of the one that is selected.
  draw_way(selected) {
    const track = selected && this.recording.by_id.get(selected.kind + " " + selected.id);
    if (!track) return;
    const context = this.scene, {x, y} = this.recording;
    context.beginPath();
    for (const {sample, count} of track.spans) {
      for (let i = sample; i < sample + count; ++i) {
        const [px, py] = this.to_screen(x[i] / kPerMetre, y[i] / kPerMetre);
        if (i === sample) context.moveTo(px, py); else context.lineTo(px, py);
      }
    }
    context.lineWidth = 2;
    context.strokeStyle = this.theme.colour("selected-way");
    context.setLineDash([6, 5]);
    context.stroke();
    context.setLineDash([]);
  }

  draw_selection(selected) {
    const pose = this.pose_of(selected);
    if (!pose) return;
    const context = this.scene, [x, y] = this.to_screen(pose.x, pose.y);
    const size = pose.track.kind === "person" ? pose.track.radius : pose.track.length / 2;
    const radius = Math.max(size * this.camera.scale, kLeastRadius) + 8;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.lineWidth = 3;
    context.strokeStyle = this.theme.colour("selected");
    context.stroke();
    this.draw_label(x, y - radius - 6, pose.track.id, `${pose.speed.toFixed(2)} m/s`);
  }

  draw_label(x, y, id, speed) {
    const context = this.scene, shown = id.length > 24 ? id.slice(0, 23) + "…" : id;
    const text = `${shown.replace(/\s/g, " ")} · ${speed}`;
    context.font = "600 13px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "bottom";
    const half = context.measureText(text).width / 2 + 6;
    const middle = Math.min(Math.max(x, half + 4), this.canvas.clientWidth - half - 4);
    const bottom = Math.max(y, 28);
    context.fillStyle = this.theme.colour("label");
    context.fillRect(middle - half, bottom - 20, 2 * half, 22);
    context.fillStyle = this.theme.colour("on-label");
    context.fillText(text, middle, bottom - 1);
  }

  // 1, 2 or 5 times a power of ten metres.
  draw_scale_bar() {
    const context = this.scene;
    const most = Math.min(140, this.canvas.clientWidth / 4) / this.camera.scale;
    const ten = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].find((step) => step * ten <= most) * ten;
    const right = this.canvas.clientWidth - 14, left = right - length * this.camera.scale;
    const bottom = this.canvas.clientHeight - 14;
    context.beginPath();
    context.moveTo(left, bottom - 6);
    context.lineTo(left, bottom);
    context.lineTo(right, bottom);
    context.lineTo(right, bottom - 6);
    for (const [width, colour] of [[5, "ground"], [2, "ink"]]) {
      context.lineWidth = width;
      context.strokeStyle = this.theme.colour(colour);
      context.stroke();
    }
    context.font = "600 12px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "bottom";
    context.lineWidth = 4;
    context.strokeStyle = this.theme.colour("ground");
    const text = `${length} m`;
    context.strokeText(text, (left + right) / 2, bottom - 5);
    context.fillStyle = this.theme.colour("ink");
    context.fillText(text, (left + right) / 2, bottom - 5);
  }

  // Who is at a place of the screen: the nearest person within reach, else the vehicle there.
  pick({x, y}) {
    let best = null, nearest = kPickReach;
    for (const pose of this.persons) {
      const [px, py] = this.to_screen(pose.x, pose.y);
      const apart = Math.hypot(px - x, py - y);
      if (apart < nearest) [best, nearest] = [pose, apart];
    }
    if (best) return {kind: "person", id: best.track.id};
    const point = {x: this.camera.x + (x - this.canvas.clientWidth / 2) / this.camera.scale,
                   y: this.camera.y - (y - this.canvas.clientHeight / 2) / this.camera.scale,
                   track: {radius: 0}};
    const there = this.vehicles.find((pose) => clearance(point, pose) * this.camera.scale < 10);
    return there ? {kind: "vehicle", id: there.track.id} : null;
  }
}
