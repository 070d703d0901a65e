"use strict";
// Light and dark: the colours stand in the style sheet; the canvas takes them from there.

class Theme {
  constructor(root, changed) {
    this.root = root;
    this.changed = changed;
    const system = matchMedia("(prefers-color-scheme: dark)");
    system.addEventListener("change", () => this.set(system.matches));
    this.set(system.matches);
  }

  set(dark) {
    this.dark = dark;
    this.root.dataset.theme = dark ? "dark" : "light";
    this.style = getComputedStyle(this.root);
    this.known = new Map();
    this.changed();
  }

  toggle() { this.set(!this.dark); }

  colour(name) {
    if (!this.known.has(name)) {
      this.known.set(name, this.style.getPropertyValue("--" + name).trim());
    }
    return this.known.get(name);
  }
}

const kStandsOnPurpose = new Set(["sitting", "chatting", "looking"]);

// Halos of those who have stood for so long, the longest last. Size tells them apart, too.
const kStanding = [
  {least: 10, colour: "stands-10", halo: 4, text: "for 10 s"},
  {least: 30, colour: "stands-30", halo: 6, text: "for 30 s"},
  {least: 60, colour: "stands-60", halo: 8, text: "for 1 min or longer"},
];
const kCounted = kStanding[1]; // of whom the caption tells

const kGroupColours = 6;

// Colour and letter of an activity. The style sheet has a colour of its name.
function activity_look(activity) {
  if (activity === "none") return {colour: "walker", letter: ""};
  return {colour: activity, letter: activity[0].toUpperCase()};
}
