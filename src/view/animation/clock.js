"use strict";
// The one clock of all panels.

const kSpeeds = [0.25, 0.5, 1, 2, 4, 8, 16, 50];

class Clock {
  constructor(begin, end, step) {
    Object.assign(this, {begin, end, step, time: begin, speed: 1, playing: false});
  }

  set(time) { this.time = Math.min(Math.max(time, this.begin), this.end); }

  play(on) {
    if (on && this.time >= this.end) this.time = this.begin;
    this.playing = on;
  }

  // By whole steps from the beginning, so that steps hit frames.
  move(steps) {
    this.playing = false;
    const at = (this.time - this.begin) / this.step;
    const nearest = Math.round(at);
    const on = Math.abs(at - nearest) < 1e-6 ? nearest : steps > 0 ? Math.floor(at) : Math.ceil(at);
    this.set(this.begin + (on + steps) * this.step);
  }

  // `passed`: [s] real time since the last picture.
  advance(passed) {
    if (!this.playing) return;
    this.set(this.time + passed * this.speed);
    if (this.time >= this.end) this.playing = false;
  }
}
