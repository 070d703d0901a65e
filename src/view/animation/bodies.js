"use strict";
// Persons and vehicles as drawn. A person's shape says who it is, its colour and letter what it
// does beside walking, filled or hollow whether it walks, its ring and the lines to others its
// group.

const kLeastRadius = 3.2;   // [pixels] nobody is drawn smaller ...
const kFarRadius = 2;       // [pixels] ... but from afar: symbols would cover the map
const kNearScale = 1.5;     // [pixels/m] nearer is not afar
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
  pram: {stretch: true, parts: [[[-1, -0.5], [-0.75, -0.85], [-0.4, -0.85], [-0.2, -0.5],
                                 [-0.2, 0.5], [-0.4, 0.85], [-0.75, 0.85], [-1, 0.5]],
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

// [pixels] the least radius of a body for a camera's scale [pixels/m].
function least_radius(scale) {
  return kFarRadius + (kLeastRadius - kFarRadius) * Math.min(1, scale / kNearScale);
}

// Half the length and width of a body in pixels, never too small to be seen.
function extent(track, shape, scale) {
  const length = shape.stretch ? track.length / 2 : track.radius;
  const width = shape.stretch ? track.width / 2 : track.radius;
  const grown = Math.max(1, least_radius(scale) / (Math.min(length, width) * scale));
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

// A figure is {x, y, heading, along, across, shape, colour, hollow, waiting, ring, letter}. Areas
// are filled one upon the other, outlines too: strokes take many times as long.
function draw_person(context, theme, figure) {
  const {x, y, heading, along, across, shape, colour, hollow, waiting, ring} = figure;
  const least = Math.min(along, across), small = least < kMarkRadius;
  const disc = (radius, name) => {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = theme.colour(name);
    context.fill();
  };
  const body = (grown, name) => {
    context.beginPath();
    trace(context, shape, x, y, heading, along + grown, across + grown);
    context.fillStyle = theme.colour(name);
    context.fill();
  };
  if (ring >= 0) {
    const radius = Math.sqrt(along * across);
    disc(radius + (small ? 2.4 : 4), "group-" + ring);
    disc(radius + (small ? 1.1 : 2), "outline");
  }
  draw_nose(context, theme, figure);
  if (!hollow) {
    if (!small && !shape.stretch) body(0.8, "outline");
    body(0, colour);
  } else if (shape.stretch) {
    body(0, "hollow");
    context.lineWidth = Math.min(2, 0.4 * least);
    context.strokeStyle = theme.colour(colour);
    context.stroke();
  } else {
    body(0, colour);
    body(-Math.min(2, 0.4 * least), "hollow");
  }
  if (waiting && !small) disc(0.4 * least, "ink");
}

function draw_nose(context, theme, {x, y, heading, along, across, shape}) {
  const least = (shape.stretch ? 0.6 : 1) * Math.min(along, across);
  const c = Math.cos(heading), s = -Math.sin(heading);
  const place = (ahead, left) => [x + c * ahead + s * left, y + s * ahead - c * left];
  context.beginPath();
  context.moveTo(...place(along + 1.1 * least, 0));
  context.lineTo(...place(0.6 * along, 0.55 * least));
  context.lineTo(...place(0.6 * along, -0.55 * least));
  context.fillStyle = theme.colour("nose");
  context.fill();
}

// Behind those who stand for long: a jam catches the eye from afar. Unlike a group's ring it is
// wide and lets the ground through.
function draw_halo(context, theme, {x, y, along, across, standing}) {
  const {colour, halo} = kStanding[standing];
  const radius = Math.sqrt(along * across) + halo;
  context.globalAlpha = 0.55;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = theme.colour(colour);
  context.fill();
  context.globalAlpha = 1;
}

// The letter of what a person does, where there is room for it.
function draw_letter(context, theme, {x, y, along, across, colour, hollow, letter}) {
  if (!letter || Math.max(along, across) < kLetterRadius) return;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const size = Math.round(1.25 * Math.max(Math.min(along, across), kLetterRadius));
  context.font = `700 ${size}px system-ui, sans-serif`;
  context.fillStyle = theme.colour(hollow ? "ink" : "on-" + colour);
  context.fillText(letter, x, y + 0.5);
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

// A vehicle's rectangle with a windscreen and bevelled front, (x, y) its middle in pixels; of one
// that bends, a part behind its first has neither. `scale`: the camera's [pixels/m].
function draw_vehicle(context, theme, x, y, heading, length, width, scale, first = true) {
  const grown = Math.max(1, 2 * least_radius(scale) / width);
  const a = length / 2 * grown, b = width / 2 * grown, bevel = first ? Math.min(0.35 * b, 0.25 * a) : 0;
  const shape = (points) => {
    context.beginPath();
    points.forEach(([px, py], i) => (i ? context.lineTo(px, py) : context.moveTo(px, py)));
    context.closePath();
  };
  context.save();
  context.translate(x, y);
  context.rotate(-heading);
  shape([[-a, -b], [a - bevel, -b], [a, -b + bevel], [a, b - bevel], [a - bevel, b], [-a, b]]);
  context.fillStyle = theme.colour("vehicle");
  context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = theme.colour("vehicle-outline");
  context.stroke();
  if (first) {
    shape([[0.42 * a, -0.78 * b], [0.68 * a, -0.62 * b], [0.68 * a, 0.62 * b],
           [0.42 * a, 0.78 * b]]);
    context.fillStyle = theme.colour("vehicle-outline");
    context.fill();
  }
  context.restore();
}
