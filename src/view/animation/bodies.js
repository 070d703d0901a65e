"use strict";
// Persons and vehicles as drawn. A person's shape says who it is, its colour and letter what it does
// beside walking, filled or hollow whether it walks, its ring and the lines to others its group.

const kLeastRadius = 3.2;   // [pixels] nobody is drawn smaller
const kLetterRadius = 7;    // [pixels] from here on letters are drawn ...
const kMarkRadius = 4.5;    // [pixels] ... and what else would only clutter a small figure
const kMostLink = 8;        // [m] members farther from their group's middle are not linked

function regular(corners, turn) {
  return Array.from({length: corners}, (_, i) => {
    const angle = turn + 2 * Math.PI * i / corners;
    return [1.12 * Math.cos(angle), 1.12 * Math.sin(angle)];
  });
}

// Polygons ahead along x, as large as half the body; null: a circle. `stretch`: as long and wide as
// the body, else as its disc.
const kShapes = {
  circle: {parts: [null]},
  triangle: {parts: [regular(3, 0)]},
  diamond: {parts: [regular(4, 0)]},
  pentagon: {parts: [regular(5, 0)]},
  hexagon: {parts: [regular(6, 0)]},
  square: {parts: [regular(4, Math.PI / 4)]},
  half: {parts: [[[-0.75, -1], [0.1, -1], [0.75, -0.72], [1, -0.25], [1, 0.25], [0.75, 0.72],
                  [0.1, 1], [-0.75, 1]]]},
  chair: {stretch: true, parts: [[[-0.8, -0.62], [0.5, -0.62], [1, -0.4], [1, 0.4], [0.5, 0.62],
                                  [-0.8, 0.62]],
                                 [[-1, -1], [0.35, -1], [0.35, -0.75], [-1, -0.75]],
                                 [[-1, 1], [-1, 0.75], [0.35, 0.75], [0.35, 1]]]},
  pram: {stretch: true, parts: [[[-1, -0.5], [-0.75, -0.85], [-0.4, -0.85], [-0.2, -0.5], [-0.2, 0.5],
                                 [-0.4, 0.85], [-0.75, 0.85], [-1, 0.5]],
                                [[0.05, -1], [1, -1], [1, 1], [0.05, 1]]]},
  bicycle: {stretch: true, parts: [[[-0.3, -0.2], [-0.15, -0.4], [0.1, -0.4], [0.25, -0.2],
                                    [0.25, 0.85], [0.1, 1], [-0.15, 1], [-0.3, 0.85]],
                                   [[-1, -0.95], [1, -0.95], [1, -0.6], [-1, -0.6]]]},
};

const kShapeOf = {
  "": "circle", infant: "triangle", child: "diamond", preteen: "pentagon", teenager: "hexagon",
  adult: "circle", "middle-aged": "half", senior: "square", wheelchair: "chair", pram: "pram",
  cyclist: "bicycle",
};
const kOtherShapes = ["hexagon", "pentagon", "diamond", "triangle", "square", "half"];

// Profiles that the user made take the plain shapes in turn.
function shape_of(profile, own_profiles) {
  const known = Object.hasOwn(kShapeOf, profile) && kShapeOf[profile];
  return kShapes[known || kOtherShapes[own_profiles.indexOf(profile) % kOtherShapes.length]];
}

// Half the length and width of a body in pixels, never too small to be seen.
function extent(track, shape, scale) {
  const length = shape.stretch ? track.length / 2 : track.radius;
  const width = shape.stretch ? track.width / 2 : track.radius;
  const grown = Math.max(1, kLeastRadius / (Math.min(length, width) * scale));
  return [length * scale * grown, width * scale * grown];
}

// Adds the outline of a body at (x, y) pixels to the context's path.
function trace(context, shape, x, y, heading, along, across) {
  const c = Math.cos(heading), s = -Math.sin(heading); // the picture's y points down
  for (const part of shape.parts) {
    if (part === null) {
      context.moveTo(x + along, y);
      context.arc(x, y, along, 0, 2 * Math.PI);
      continue;
    }
    for (let i = 0; i < part.length; ++i) {
      const a = part[i][0] * along, b = -part[i][1] * across;
      const px = x + c * a - s * b, py = y + s * a + c * b;
      if (i === 0) context.moveTo(px, py); else context.lineTo(px, py);
    }
    context.closePath();
  }
}

// Draws figures {x, y, heading, along, across, shape, colour, hollow, waiting, ring, letter}: all of
// one colour at once, which is many times faster than one by one.
function draw_persons(context, theme, figures) {
  draw_rings(context, theme, figures);
  draw_headings(context, theme, figures);
  const looks = new Map();
  for (const figure of figures) {
    const look = figure.colour + (figure.hollow ? " hollow" : "");
    if (!looks.has(look)) looks.set(look, []);
    looks.get(look).push(figure);
  }
  for (const alike of looks.values()) {
    context.beginPath();
    for (const {shape, x, y, heading, along, across} of alike) {
      trace(context, shape, x, y, heading, along, across);
    }
    const colour = theme.colour(alike[0].colour);
    context.fillStyle = alike[0].hollow ? theme.colour("hollow") : colour;
    context.fill("nonzero");
    context.lineWidth = alike[0].hollow ? Math.min(2, 0.45 * alike[0].along) : 1;
    context.strokeStyle = alike[0].hollow ? colour : theme.colour("outline");
    context.stroke();
  }
  draw_marks(context, theme, figures);
}

function draw_headings(context, theme, figures) {
  context.beginPath();
  for (const {x, y, heading, along, across} of figures) {
    const reach = along + 0.9 * Math.min(along, across);
    const c = Math.cos(heading), s = -Math.sin(heading);
    context.moveTo(x + c * along, y + s * along);
    context.lineTo(x + c * reach, y + s * reach);
  }
  context.lineWidth = 1.6;
  context.strokeStyle = theme.colour("ink");
  context.stroke();
}

function draw_rings(context, theme, figures) {
  for (let ring = 0; ring < kGroupColours; ++ring) {
    context.beginPath();
    let small = false;
    for (const {x, y, along, across, ring: own} of figures) {
      if (own !== ring) continue;
      const size = Math.sqrt(along * across);
      small = size < kMarkRadius;
      const radius = size + (small ? 1.5 : 3);
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.lineWidth = small ? 1.3 : 2;
    context.strokeStyle = theme.colour("group-" + ring);
    context.stroke();
  }
}

// A dot in whoever waits; the pastime's letter where there is room for it.
function draw_marks(context, theme, figures) {
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const {x, y, along, across, colour, hollow, waiting, letter} of figures) {
    const size = Math.min(along, across);
    context.fillStyle = theme.colour(hollow ? "ink" : "on-" + colour);
    if (letter && Math.max(along, across) >= kLetterRadius) {
      context.font = `700 ${Math.round(1.25 * Math.max(size, kLetterRadius))}px system-ui, sans-serif`;
      context.fillText(letter, x, y + 0.5);
    } else if (waiting && size >= kMarkRadius) {
      context.beginPath();
      context.arc(x, y, 0.4 * size, 0, 2 * Math.PI);
      context.fill();
    }
  }
}

// Straight lines from the members of a group that are near each other to their middle.
function draw_links(context, theme, members_by_group) {
  context.lineWidth = 1.5;
  context.globalAlpha = 0.6;
  for (const {ring, members, reach} of members_by_group) {
    const x = members.reduce((sum, one) => sum + one.x, 0) / members.length;
    const y = members.reduce((sum, one) => sum + one.y, 0) / members.length;
    context.beginPath();
    for (const one of members) {
      if (Math.hypot(one.x - x, one.y - y) > reach) continue;
      context.moveTo(x, y);
      context.lineTo(one.x, one.y);
    }
    context.strokeStyle = theme.colour("group-" + ring);
    context.stroke();
  }
  context.globalAlpha = 1;
}

// A vehicle's rectangle with a windscreen and bevelled front, (x, y) its middle in pixels.
function draw_vehicle(context, theme, x, y, heading, length, width) {
  const grown = Math.max(1, 2 * kLeastRadius / (width / 2) / 2);
  const a = length / 2 * grown, b = width / 2 * grown, bevel = Math.min(0.35 * b, 0.25 * a);
  const part = (points) => {
    context.beginPath();
    points.forEach(([px, py], i) => (i ? context.lineTo(px, py) : context.moveTo(px, py)));
    context.closePath();
  };
  context.save();
  context.translate(x, y);
  context.rotate(-heading);
  part([[-a, -b], [a - bevel, -b], [a, -b + bevel], [a, b - bevel], [a - bevel, b], [-a, b]]);
  context.fillStyle = theme.colour("vehicle");
  context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = theme.colour("vehicle-outline");
  context.stroke();
  part([[0.42 * a, -0.78 * b], [0.68 * a, -0.62 * b], [0.68 * a, 0.62 * b], [0.42 * a, 0.78 * b]]);
  context.fillStyle = theme.colour("vehicle-outline");
  context.fill();
  context.restore();
}
