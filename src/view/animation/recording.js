"use strict";
// A run: who is where at a time.

const kPerMetre = 100;   // lengths are in cm, speeds in cm/s
const kPerTurn = 720;    // headings are in half degrees counter-clockwise from east
const kPerSecond = 1000; // times are in ms from the first one
const kStillReach = 0.5; // [m] who keeps within it stands: people in a jam shuffle

// One person or vehicle: runs of consecutive frames, each a run of consecutive samples.
class Track {
  constructor(info, kind, number) {
    Object.assign(this, info);
    this.kind = kind;
    this.number = number;
    this.at = 0; // the span that was asked for last
  }

  // Number of the sample at a frame; -1 where there is none.
  sample(frame) {
    for (let tries = 0; tries < this.spans.length; ++tries) {
      const {first, count, sample} = this.spans[this.at];
      if (frame >= first && frame < first + count) return sample + frame - first;
      this.at = (this.at + 1) % this.spans.length;
    }
    return -1;
  }

  // What a person does at a sample: numbers of a motion and an activity.
  doing(sample) {
    let low = 0, high = this.changes.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.changes[middle][0] <= sample) low = middle; else high = middle - 1;
    }
    return this.changes[low];
  }
}

// For each sample the first one since which it has kept within reach.
function still_since(x, y, persons) {
  const since = new Int32Array(x.length), reach = kStillReach * kPerMetre;
  for (const {spans} of persons) {
    for (const {sample, count} of spans) {
      let first = sample;
      for (let i = sample; i < sample + count; ++i) {
        while (Math.hypot(x[i] - x[first], y[i] - y[first]) > reach) ++first;
        since[i] = first;
      }
    }
  }
  return since;
}

class Recording {
  static async read(data) {
    const recording = new Recording();
    const [times, x, y, heading, speed] = await Promise.all([
      unpacked(data.times, data.frames), unpacked(data.x, data.samples),
      unpacked(data.y, data.samples), unpacked(data.heading, data.samples),
      unpacked(data.speed, data.samples)]);
    sum_twice(times, 0, times.length);
    Object.assign(recording, {name: data.name, begin: data.begin, times, x, y, heading, speed});
    recording.motions = data.motions;
    recording.activities = data.activities;
    let sample = 0;
    const track = (kind) => (info, number) => {
      const made = new Track(info, kind, number);
      const begin = sample;
      made.spans = info.spans.map(([first, count]) => {
        const span = {first, count, sample};
        for (const column of [x, y]) sum_twice(column, sample, count);
        for (const column of [heading, speed]) sum_once(column, sample, count);
        sample += count;
        return span;
      });
      made.changes = (info.changes || []).map(([from, ...doing]) => [begin + from, ...doing]);
      return made;
    };
    recording.persons = data.persons.map(track("person"));
    recording.vehicles = data.vehicles.map(track("vehicle"));
    recording.since = still_since(x, y, recording.persons);
    recording.by_id = new Map();
    for (const one of [...recording.vehicles, ...recording.persons]) {
      recording.by_id.set(one.kind + " " + one.id, one);
    }
    return recording;
  }

  // [s] of a frame.
  time_of(frame) { return this.begin + this.times[frame] / kPerSecond; }
  // [s] when the first person is there.
  first_person() {
    const firsts = this.persons.map((one) => one.spans[0].first);
    return this.time_of(firsts.length ? firsts.reduce((a, b) => Math.min(a, b)) : 0);
  }
  get end() { return this.time_of(this.times.length - 1); }

  // The frame at or before a time [s], and how far on it is to the next, [0, 1).
  frame_at(time) {
    const sought = (time - this.begin) * kPerSecond;
    let low = 0, high = this.times.length - 1;
    if (sought >= this.times[high]) return {frame: high, share: 0, over: sought > this.times[high]};
    while (low + 1 < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= sought) low = middle; else high = middle;
    }
    const share = (sought - this.times[low]) / (this.times[high] - this.times[low]);
    return {frame: low, share: Math.max(0, share), over: sought < this.times[0]};
  }

  // Where one is at a time; null where it is not there. Even motion between two frames.
  pose(track, {frame, share, over}) {
    const i = over ? -1 : track.sample(frame);
    if (i < 0) return null;
    const begin = track.spans[track.at].sample;
    const j = share > 0 ? track.sample(frame + 1) : i;
    if (j < 0) return null;
    const mix = (column) => column[i] + share * (column[j] - column[i]);
    let turn = (this.heading[j] - this.heading[i]) % kPerTurn;
    if (turn > kPerTurn / 2) turn -= kPerTurn;
    if (turn < -kPerTurn / 2) turn += kPerTurn;
    return {
      track, sample: i, frame, begin,
      x: mix(this.x) / kPerMetre, y: mix(this.y) / kPerMetre,
      heading: 2 * Math.PI * (this.heading[i] + share * turn) / kPerTurn,
      speed: mix(this.speed) / kPerMetre,
    };
  }

  poses(tracks, time) {
    const moment = this.frame_at(time);
    const found = [];
    for (const track of tracks) {
      const pose = this.pose(track, moment);
      if (pose) found.push(pose);
    }
    return found;
  }

  // [s] how long a person has stood at that pose. Who sits, chats or looks does so on purpose.
  stood(pose, time) {
    if (kStandsOnPurpose.has(this.doing(pose).activity)) return 0;
    const first = pose.frame - (pose.sample - this.since[pose.sample]);
    return Math.max(0, time - this.time_of(first));
  }

  // Whether somebody ever stands so long that it is shown.
  stands_long(track) {
    return track.spans.some(({first, sample, count}) => {
      for (let i = sample; i < sample + count; ++i) {
        const from = first + this.since[i] - sample, to = first + i - sample;
        if (this.time_of(to) - this.time_of(from) < kStanding[0].least) continue;
        const [, , activity] = track.doing(i);
        if (!kStandsOnPurpose.has(this.activities[activity])) return true;
      }
      return false;
    });
  }

  // Names of what a person does at that pose.
  doing(pose) {
    const [, motion, activity] = pose.track.doing(pose.sample);
    return {motion: this.motions[motion], activity: this.activities[activity]};
  }
}

// Room [m] between a person's disc and a vehicle's rectangle; negative where they overlap.
function clearance(person, vehicle) {
  const dx = person.x - vehicle.x, dy = person.y - vehicle.y;
  const c = Math.cos(vehicle.heading), s = Math.sin(vehicle.heading);
  const ahead = Math.abs(c * dx + s * dy) - vehicle.track.length / 2;
  const aside = Math.abs(c * dy - s * dx) - vehicle.track.width / 2;
  const outside = Math.hypot(Math.max(ahead, 0), Math.max(aside, 0));
  return outside + Math.min(Math.max(ahead, aside), 0) - person.track.radius;
}
