"use strict";
// The legend: what occurs in the recordings, drawn as in the panels.

class Looks {
  constructor(recordings) {
    const profiles = new Set(), groups = new Set(), motions = new Set(), activities = new Set();
    const bodies = new Map();
    for (const recording of recordings) {
      for (const person of recording.persons) {
        profiles.add(person.profile);
        if (!bodies.has(person.profile)) bodies.set(person.profile, person);
        if (person.group) groups.add(person.group);
        this.stands ||= recording.stands_long(person);
        for (const [, motion, activity] of person.changes) {
          motions.add(recording.motions[motion]);
          activities.add(recording.activities[activity]);
        }
      }
    }
    const order = Object.keys(kShapeOf);
    const place = (profile) => (order.includes(profile) ? order.indexOf(profile) : order.length);
    this.profiles = [...profiles].sort((a, b) => place(a) - place(b) || (a < b ? -1 : 1));
    this.own_profiles = this.profiles.filter((profile) => !order.includes(profile));
    this.bodies = bodies;
    this.rings = new Map([...groups].map((group, i) => [group, i % kGroupColours]));
    this.motions = ["walking", "waiting", "standing", kBySumo].filter((name) => motions.has(name));
    this.activities = recordings[0].activities.filter(
      (name) => name !== "none" && activities.has(name));
  }

  shape(profile) { return shape_of(profile, this.own_profiles); }
  ring(group) { return group ? this.rings.get(group) : -1; }
}

const kSwatch = {width: 40, height: 26, scale: 26}; // [pixels], [pixels/m]

class Legend {
  constructor(place, theme, looks, scenery, has_vehicles, levels) {
    Object.assign(this, {place, theme, looks, swatches: []});
    const person = {heading: 0, standing: -1, shape: kShapes.circle, along: 7, across: 7,
                    colour: "walker", ring: -1, hollow: false, waiting: false, letter: ""};
    this.section("Who", looks.profiles.length < 2 && !looks.profiles[0] ? [] : looks.profiles.map(
      (profile) => {
        const shape = looks.shape(profile);
        const size = extent(looks.bodies.get(profile), shape, kSwatch.scale);
        const fit = Math.min(1, 14 / size[0], 11 / size[1]);
        return [profile || "no profile",
                {...person, shape, along: fit * size[0], across: fit * size[1]}];
      }));
    this.section("Does", [
      ...looks.motions.map((name) => [
        name, {...person, hollow: name !== "walking" && name !== kBySumo,
               waiting: name === "waiting", pale: name === kBySumo}]),
      ...looks.activities.map((name) => [
        name, {...person, ...activity_look(name), along: 9, across: 9}]),
    ]);
    this.section("Stands", looks.stands ? kStanding.map(
      ({text}, standing) => [text, {...person, standing, along: 5, across: 5}]) : []);
    this.section("Where", [
      ...(looks.rings.size ? [["group", {...person, ring: 0, along: 6, across: 6}]] : []),
      ...(has_vehicles ? [["vehicle",
        (context) => draw_vehicle(context, theme, 20, 13, 0, 32, 15, kSwatch.scale)]] : []),
      ...(scenery.zone.length ? [["shared space",
        (context) => this.box(context, "zone", "zone-edge")]] : []),
      ...(scenery.obstacles.length ? [["obstacle",
        (context) => this.box(context, "obstacle", "obstacle-edge")]] : []),
      ...(scenery.roads.length ? [["road", (context) => this.box(context, "road", "road")]] : []),
      ...(scenery.waypoints.length ? [["waypoint", (context) => this.star(context)]] : []),
    ]);
    this.density = this.section("Persons per m²", levels.map(({text, colour}) => [
      text, (context) => {
        context.fillStyle = colour;
        context.globalAlpha = kDensityAlpha;
        context.fillRect(5, 5, 30, 16);
      }]));
    this.show_density(false);
    this.draw();
  }

  show_density(on) {
    for (const part of this.density) part.hidden = !on;
  }

  section(title, entries) {
    if (!entries.length) return;
    const heading = document.createElement("h3"), list = document.createElement("ul");
    heading.textContent = title;
    for (const [name, drawn] of entries) {
      const item = document.createElement("li"), canvas = document.createElement("canvas");
      const label = document.createElement("span");
      canvas.setAttribute("aria-hidden", "true");
      label.textContent = name;
      item.append(canvas, label);
      list.append(item);
      this.swatches.push([canvas, drawn]);
    }
    this.place.append(heading, list);
    return [heading, list];
  }

  draw() {
    const ratio = Math.min(devicePixelRatio || 1, 2);
    for (const [canvas, drawn] of this.swatches) {
      canvas.width = kSwatch.width * ratio;
      canvas.height = kSwatch.height * ratio;
      const context = canvas.getContext("2d");
      context.scale(ratio, ratio);
      context.lineJoin = context.lineCap = "round";
      if (typeof drawn === "function") drawn(context);
      else this.person(context, {...drawn, x: kSwatch.width / 2 - 3, y: kSwatch.height / 2});
    }
  }

  person(context, figure) {
    if (figure.standing >= 0) draw_halo(context, this.theme, figure);
    context.globalAlpha = figure.pale ? kPale : 1;
    draw_person(context, this.theme, figure);
    context.globalAlpha = 1;
    draw_letter(context, this.theme, figure);
  }

  box(context, fill, line) {
    context.fillStyle = this.theme.colour(fill);
    context.fillRect(5, 5, 30, 16);
    context.strokeStyle = this.theme.colour(line);
    context.lineWidth = 1.5;
    context.strokeRect(5, 5, 30, 16);
  }

  star(context) {
    context.translate(20, 13);
    context.scale(1, -1);
    draw_star(context, 0, 0, 9);
    context.fillStyle = this.theme.colour("waypoint");
    context.fill();
  }
}
