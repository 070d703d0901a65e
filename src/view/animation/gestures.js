"use strict";
// Drag, wheel, pinch and click on a panel's canvas.

const kClickReach = 6; // [pixels] a press that moves farther is a drag

class Gestures {
  constructor(canvas, camera, {changed, clicked}) {
    Object.assign(this, {canvas, camera, changed, clicked});
    this.fingers = new Map();
    this.moved = 0;
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    for (const end of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(end, (event) => this.up(event));
    }
    canvas.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
  }

  place(event) {
    const box = this.canvas.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  }

  // From the middle of the canvas.
  off_middle({x, y}) { return [x - this.canvas.clientWidth / 2, y - this.canvas.clientHeight / 2]; }

  down(event) {
    if (event.button !== 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    if (this.fingers.size === 0) this.moved = 0;
    this.fingers.set(event.pointerId, this.place(event));
  }

  // Middle of the fingers and their distance.
  grip() {
    const [a, b = a] = this.fingers.values();
    return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y)};
  }

  move(event) {
    if (!this.fingers.has(event.pointerId)) return;
    const before = this.grip();
    this.fingers.set(event.pointerId, this.place(event));
    const now = this.grip();
    const dx = now.x - before.x, dy = now.y - before.y;
    this.moved += Math.hypot(dx, dy) + Math.abs(now.apart - before.apart);
    if (this.moved <= kClickReach) return;
    this.camera.pan(dx, dy);
    if (before.apart > 0 && now.apart > 0) {
      this.camera.zoom(now.apart / before.apart, ...this.off_middle(now));
    }
    this.changed();
  }

  up(event) {
    const last = this.fingers.size === 1 && this.fingers.has(event.pointerId);
    this.fingers.delete(event.pointerId);
    if (last && event.type === "pointerup" && this.moved <= kClickReach) {
      this.clicked(this.place(event));
    }
  }

  wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    const factor = Math.exp(-0.0015 * lines * event.deltaY);
    this.camera.zoom(factor, ...this.off_middle(this.place(event)));
    this.changed();
  }
}
