"use strict";
// What part of the plane the panels show. All panels share one, so that they compare.

const kLeastScale = 0.05, kMostScale = 400; // [pixels/m]
const kCaption = 44; // [pixels] above and below what is shown, for the panel's name

class Camera {
  constructor(box) {
    this.box = box; // [m] what there is to see: [west, south, east, north]
    this.x = (box[0] + box[2]) / 2;
    this.y = (box[1] + box[3]) / 2;
    this.scale = 1; // [pixels/m]
    this.fitted = true;
    this.version = 0;
  }

  // Shows everything in panels of that size [pixels].
  fit(width, height) {
    const [west, south, east, north] = this.box;
    this.x = (west + east) / 2;
    this.y = (south + north) / 2;
    this.scale = Math.min(width / (east - west),
                          Math.max(height - 2 * kCaption, height / 2) / (north - south));
    this.scale = Math.min(Math.max(this.scale, kLeastScale), kMostScale);
    this.fitted = true;
    ++this.version;
  }

  move_to(x, y) {
    this.x = x;
    this.y = y;
    this.fitted = false;
    ++this.version;
  }

  pan(dx, dy) { this.move_to(this.x - dx / this.scale, this.y + dy / this.scale); }

  // Keeps what is (dx, dy) pixels from the middle where it is.
  zoom(factor, dx, dy) {
    const scale = Math.min(Math.max(this.scale * factor, kLeastScale), kMostScale);
    const shift = 1 / this.scale - 1 / scale;
    this.scale = scale;
    this.move_to(this.x + dx * shift, this.y - dy * shift);
  }
}
