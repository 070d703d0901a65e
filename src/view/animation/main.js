"use strict";
// Puts the parts together.

const kWide = 1.6; // a map so much wider than high is shown above another, not beside it
const kLongestPause = 0.25; // [s] whoever comes back to the page has missed nothing

class Animation {
  constructor(data, recordings) {
    const find = (id) => document.getElementById(id);
    this.find = find;
    const redraw = () => this.redraw();
    this.theme = new Theme(document.documentElement, () => this.repaint());
    this.camera = new Camera(data.box);
    this.looks = new Looks(recordings);
    const scenery = new Scenery(data.scenery);
    this.layers = {names: true, trails: false, density: false};
    const density = new Density(data.levels);
    const stage = find("stage");
    stage.dataset.panels = recordings.length;
    const [west, south, east, north] = data.box;
    stage.classList.toggle("stacked", east - west > kWide * (north - south));
    this.panels = recordings.map((recording) => new Panel(stage, recording, {
      scenery, camera: this.camera, theme: this.theme, looks: this.looks,
      layers: this.layers, density}));
    for (const panel of this.panels) {
      new Gestures(panel.canvas, this.camera, {
        changed: redraw, clicked: (place) => this.select(panel.pick(place))});
    }
    this.clock = new Clock(Math.min(...recordings.map((one) => one.begin)),
                           Math.max(...recordings.map((one) => one.end)), data.step);
    this.clock.set(Math.min(...recordings.map((one) => one.first_person())));
    this.legend = new Legend(find("legend"), this.theme, this.looks, data.scenery,
                             recordings.some((one) => one.vehicles.length), data.levels);
    this.details = new Details(this.panels);
    this.selected = null;
    if (data.selected) this.select({kind: "person", id: data.selected});
    this.show_layers(data.scenery.streets.length > 0);
    find("title").textContent = document.title = data.title;
    this.controls();
    this.keys();
    new ResizeObserver(redraw).observe(stage);
    redraw();
  }

  controls() {
    const {find, clock} = this;
    const time = find("time"), speed = find("speed");
    Object.assign(time, {min: clock.begin, max: clock.end, step: clock.step, value: clock.time});
    time.addEventListener("input", () => { this.clock.set(Number(time.value)); this.redraw(); });
    for (const factor of kSpeeds) speed.add(new Option(`${factor}×`, factor));
    speed.value = "1";
    speed.addEventListener("change", () => { clock.speed = Number(speed.value); });
    const actions = {
      play: () => this.play(!clock.playing), back: () => this.move(-1), forward: () => this.move(1),
      fit: () => this.fit(), theme: () => this.theme.toggle(), deselect: () => this.select(null),
      follow: () => this.follow(!this.following), "zoom-in": () => this.zoom(1.5),
      "zoom-out": () => this.zoom(1 / 1.5)};
    for (const [id, action] of Object.entries(actions)) find(id).addEventListener("click", action);
    find("key").open = matchMedia("(min-width: 700px)").matches;
    find("find").addEventListener("change", (event) => this.find_id(event.target.value));
    const ids = new Set(this.panels.flatMap((panel) => [
      ...panel.recording.vehicles, ...panel.recording.persons]).map((track) => track.id));
    find("ids").append(...[...ids].map((id) => new Option("", id)));
  }

  // Boxes that switch layers on and off.
  show_layers(has_names) {
    this.find("names-box").hidden = !has_names;
    for (const name of Object.keys(this.layers)) {
      const box = this.find("show-" + name);
      box.checked = this.layers[name];
      box.addEventListener("change", () => {
        this.layers[name] = box.checked;
        this.legend.show_density(this.layers.density);
        this.redraw();
      });
    }
  }

  keys() {
    const actions = {
      " ": () => this.play(!this.clock.playing), ArrowLeft: () => this.move(-1),
      ArrowRight: () => this.move(1), Home: () => this.go(this.clock.begin),
      End: () => this.go(this.clock.end), f: () => this.fit(), d: () => this.theme.toggle(),
      "+": () => this.zoom(1.5), "-": () => this.zoom(1 / 1.5), Escape: () => this.select(null)};
    document.addEventListener("keydown", (event) => {
      const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
      // Buttons and boxes keep the keys that are theirs.
      const own = event.target.closest("input[type=search], select, summary")
        || (event.key === " " && event.target.closest("button, input[type=checkbox]"));
      if (!action || own || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      action();
    });
  }

  play(on) {
    this.clock.play(on);
    this.redraw();
  }

  move(steps) {
    this.clock.move(steps);
    this.redraw();
  }

  go(time) {
    this.clock.set(time);
    this.redraw();
  }

  zoom(factor) {
    this.camera.zoom(factor, 0, 0);
    this.redraw();
  }

  fit() {
    const {clientWidth, clientHeight} = this.panels[0].canvas;
    this.camera.fit(clientWidth, clientHeight);
    this.follow(false);
    this.redraw();
  }

  select(selected) {
    this.selected = selected;
    this.follow(false);
    this.details.select(selected);
    this.redraw();
  }

  // Takes a vehicle or person by its id, at the nearest time at which it is there.
  find_id(id) {
    for (const {recording} of this.panels) {
      const track = recording.by_id.get("vehicle " + id) || recording.by_id.get("person " + id);
      if (!track) continue;
      this.select({kind: track.kind, id});
      if (!recording.pose(track, recording.frame_at(this.clock.time))) {
        this.clock.set(recording.time_of(track.spans[0].first));
      }
      this.follow(true);
      this.find("nobody").hidden = true;
      return;
    }
    this.find("nobody").hidden = !id;
    this.find("nobody").textContent = `Nobody is called “${id}”.`;
  }

  follow(on) {
    this.following = on;
    this.find("follow").setAttribute("aria-pressed", String(on));
    if (on && this.camera.fitted) this.camera.zoom(Math.max(1, 25 / this.camera.scale), 0, 0);
    this.redraw();
  }

  repaint() {
    if (!this.legend) return;
    this.legend.draw();
    this.redraw();
  }

  redraw() {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame((now) => this.picture(now));
  }

  picture(now) {
    this.asked = false;
    const {clock} = this;
    const playing = clock.playing;
    const passed = playing && this.before !== undefined ? (now - this.before) / 1000 : 0;
    clock.advance(Math.min(passed, kLongestPause));
    this.before = playing ? now : undefined;
    const resized = this.panels.filter((panel) => panel.resize()).length > 0;
    if (resized && this.camera.fitted) this.fit();
    this.centre();
    for (const panel of this.panels) panel.draw(clock.time, this.selected);
    this.details.show(this.selected);
    this.show_clock();
    if (clock.playing) this.redraw();
  }

  centre() {
    if (!this.following || !this.selected) return;
    for (const {recording} of this.panels) {
      const track = recording.by_id.get(this.selected.kind + " " + this.selected.id);
      const pose = track && recording.pose(track, recording.frame_at(this.clock.time));
      if (!pose) continue;
      this.camera.move_to(pose.x, pose.y);
      return;
    }
  }

  show_clock() {
    const {clock, find} = this;
    find("time").value = clock.time;
    find("time").setAttribute("aria-valuetext", `${clock.time.toFixed(1)} seconds`);
    find("clock").textContent = `${clock.time.toFixed(1)} s`;
    const play = find("play");
    play.classList.toggle("playing", clock.playing);
    play.setAttribute("aria-label", clock.playing ? "Pause" : "Play");
  }

  // For films: only title, clock and panels are shown, at times that are asked for. Returns which
  // there are [s].
  film() {
    document.documentElement.dataset.film = "";
    this.find("title").after(this.find("clock"));
    return {begin: this.clock.time, end: this.clock.end};
  }

  async frame(time) {
    this.clock.set(time);
    this.picture(0);
    await new Promise(requestAnimationFrame);
  }

  // What is shown, for programs that look at the page.
  state() {
    const pose = ({track, x, y, heading, speed}) => ({id: track.id, x, y, heading, speed});
    return {
      time: this.clock.time, playing: this.clock.playing, selected: this.selected,
      scale: this.camera.scale, centre: [this.camera.x, this.camera.y],
      panels: this.panels.map((panel) => ({
        name: panel.recording.name, persons: panel.persons.map(pose),
        vehicles: panel.vehicles.map(pose), draw_times: panel.draw_times}))};
  }
}

async function begin() {
  const message = document.getElementById("message");
  try {
    const data = JSON.parse(document.getElementById("data").textContent);
    document.title = data.title;
    const recordings = [];
    for (const run of data.runs) recordings.push(await Recording.read(run));
    window.pedzone = new Animation(data, recordings);
    message.hidden = true;
  } catch (error) {
    message.textContent = typeof DecompressionStream === "undefined"
      ? "This browser is too old to show the animation: it needs one of 2023 or later."
      : `The animation cannot be shown: ${error.message}`;
    throw error;
  }
}

const pedzone_begun = begin();
