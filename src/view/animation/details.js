"use strict";
// The numbers of the person or vehicle that is selected, one column a run.

class Details {
  constructor(panels) {
    this.panels = panels;
    this.place = document.getElementById("details");
    this.rows = document.getElementById("details-rows");
    this.head = document.getElementById("details-head");
    this.cells = new Map();
  }

  // Another one, or nobody.
  select(selected) {
    this.place.hidden = !selected;
    this.rows.replaceChildren();
    this.head.replaceChildren();
    this.cells.clear();
    if (!selected) return;
    document.getElementById("details-id").textContent = selected.id;
    if (this.panels.length > 1) {
      const row = document.createElement("tr");
      row.append(document.createElement("td"), ...this.panels.map((panel) => {
        const cell = document.createElement("th");
        cell.textContent = panel.recording.name;
        return cell;
      }));
      this.head.append(row);
    }
  }

  show(selected) {
    if (!selected) return;
    this.panels.forEach((panel, column) => {
      const track = panel.recording.by_id.get(selected.kind + " " + selected.id);
      const facts = Details.facts(panel, track, panel.pose_of(selected));
      for (const [name, value] of facts) this.put(name, column, value);
    });
  }

  put(name, column, value) {
    if (!this.cells.has(name)) {
      const row = document.createElement("tr"), heading = document.createElement("th");
      heading.scope = "row";
      heading.textContent = name;
      const cells = this.panels.map(() => document.createElement("td"));
      row.append(heading, ...cells);
      this.rows.append(row);
      this.cells.set(name, cells);
    }
    const cell = this.cells.get(name)[column];
    if (cell.textContent !== value) cell.textContent = value;
  }

  static facts(panel, track, pose) {
    if (!track) return [["Is", "not in this run"]];
    const facts = [];
    if (track.kind === "vehicle") facts.push(["Type", track.type]);
    if (track.profile) facts.push(["Profile", track.profile]);
    if (track.group) facts.push(["Group", track.group]);
    const missing = pose ? null : "not there now";
    if (track.kind === "person") facts.push(["Does", missing || Details.doing(panel, pose)]);
    facts.push(["Speed", missing ? "–" : `${pose.speed.toFixed(2)} m/s`]);
    if (track.kind === "person") {
      const [name, room] = missing ? ["–", null] : Details.nearest_vehicle(panel, pose);
      facts.push(["Clearance", room === null ? "–" : `${room.toFixed(2)} m`],
                 ["to vehicle", name]);
    }
    facts.push(["Place", missing ? "–" : `${pose.x.toFixed(1)}, ${pose.y.toFixed(1)} m`]);
    facts.push(["Size", track.kind === "person" ? `${(2 * track.radius).toFixed(2)} m across`
      : `${track.length.toFixed(2)} × ${track.width.toFixed(2)} m`]);
    return facts;
  }

  static doing(panel, pose) {
    const {motion, activity} = panel.recording.doing(pose);
    return activity === "none" ? motion : `${motion}, ${activity}`;
  }

  static nearest_vehicle(panel, pose) {
    let name = "–", least = null;
    for (const vehicle of panel.vehicles) {
      const room = clearance(pose, vehicle);
      if (least === null || room < least) [name, least] = [vehicle.track.id, room];
    }
    return [name, least];
  }
}
