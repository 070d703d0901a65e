#include "model/vehicle_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pedzone {
namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();

/// [m] more than rounding, so that what could just be touched is not left out.
constexpr float kReachMargin = 0.1F;

struct Vec2f {
  float x, y;
};

Vec2f to_vehicle(const VehicleShape& s, float x, float y) {
  return {x * s.cos + y * s.sin, y * s.cos - x * s.sin};
}

Vec2f to_world(const VehicleShape& s, float x, float y) {
  return {x * s.cos - y * s.sin, y * s.cos + x * s.sin};
}

/// Distance from a point to the rectangle |x| ≤ half_length, |y| ≤ half_width.
float distance_to_rectangle(float x, float y, float half_length, float half_width) {
  const float dx = std::max(std::abs(x) - half_length, 0.0F);
  const float dy = std::max(std::abs(y) - half_width, 0.0F);
  return std::sqrt(dx * dx + dy * dy);
}

/// Times at which x0 + w·t lies in [−half, half], cut with [enter, leave].
void cut_slab(float x0, float w, float half, float& enter, float& leave) {
  if (w == 0.0F) {
    if (std::abs(x0) > half) enter = kNever;
    return;
  }
  const float a = (-half - x0) / w, b = (half - x0) / w;
  enter = std::max(enter, std::min(a, b));
  leave = std::min(leave, std::max(a, b));
}

/// Whether the ray from (x, y) along (wx, wy) meets the rectangle within `length`.
bool ray_meets(float x, float y, float wx, float wy, const VehicleShape& s, float length) {
  float enter = 0.0F, leave = length;
  cut_slab(x, wx, s.half_length, enter, leave);
  cut_slab(y, wy, s.half_width, enter, leave);
  return enter <= leave;
}

struct FaceFrame {
  float out, along;  ///< of the person: outside the face, along it from its middle
  float half_along;  ///< half the face's length
  float nx, ny;      ///< outward normal in the vehicle's frame
};

/// Front, rear, left and right side.
void faces_of(const VehicleView& v, FaceFrame (&faces)[4]) {
  const float hl = v.shape->half_length, hw = v.shape->half_width;
  faces[0] = {v.x - hl, v.y, hw, 1.0F, 0.0F};
  faces[1] = {-v.x - hl, -v.y, hw, -1.0F, 0.0F};
  faces[2] = {v.y - hw, -v.x, hl, 0.0F, 1.0F};
  faces[3] = {-v.y - hw, v.x, hl, 0.0F, -1.0F};
}

void add_face(const VehicleView& view, const FaceFrame& face, bool whole_line, FaceList& faces) {
  const VehicleShape& s = *view.shape;
  const Vec2f n = to_world(s, face.nx, face.ny);
  const float endless = 1e6F;  // [m] a person inside meets the nearest side wherever it goes
  const float half = whole_line ? endless : face.half_along;
  faces.add({.nx = n.x,
             .ny = n.y,
             .dx = -n.y,
             .dy = n.x,
             .vx = s.vx,
             .vy = s.vy,
             .gap = face.out - view.contact,
             .x = face.along,
             .half_length = half});
}

}  // namespace

float loudness_of(float speed, bool electric) {
  constexpr float kTyresLikeEngine = 4.2F;  // [m/s]
  const float tyres = speed / kTyresLikeEngine;
  return std::max(electric ? 0.5F : 1.0F, tyres * std::sqrt(tyres));
}

VehicleShape shape_of(const VehicleState& vehicle, const LatticeOrigin& origin) {
  VehicleShape s;
  s.centre = to_lattice(vehicle.centre.x(), vehicle.centre.y(), origin);
  s.cos = static_cast<float>(std::cos(vehicle.heading));
  s.sin = static_cast<float>(std::sin(vehicle.heading));
  s.half_length = static_cast<float>(vehicle.length / 2.0);
  s.half_width = static_cast<float>(vehicle.width / 2.0);
  s.reach = std::sqrt(s.half_length * s.half_length + s.half_width * s.half_width);
  s.speed = static_cast<float>(vehicle.velocity.norm());
  s.loudness = loudness_of(s.speed, vehicle.electric);
  s.horn = vehicle.horn;
  s.invites = vehicle.invites;
  if (s.moving()) {
    s.vx = static_cast<float>(vehicle.velocity.x());
    s.vy = static_cast<float>(vehicle.velocity.y());
  }
  return s;
}

void expect_gain(VehicleShape& shape, double gain) {
  if (!shape.moving() || !(gain > 0.0)) return;
  const float expected = shape.speed + static_cast<float>(gain);
  shape.vx *= expected / shape.speed;
  shape.vy *= expected / shape.speed;
  shape.speed = expected;
}

VehicleView view_of(const VehicleShape& shape, const Walker& person) {
  VehicleView view;
  view.shape = &shape;
  const Vec2f q = to_vehicle(shape, lattice_difference(person.at.x, shape.centre.x),
                             lattice_difference(person.at.y, shape.centre.y));
  view.x = q.x;
  view.y = q.y;
  view.distance = distance_to_rectangle(q.x, q.y, shape.half_length, shape.half_width);
  // The room people keep shrinks with what there is: somebody squeezed between a vehicle and a
  // wall still tells directions that lead away from those that lead under it.
  const float clearance = std::max(view.distance - person.radius, 0.0F);
  const float room = std::min(shape.moving() ? kVehicleRoom : kParkedRoom, clearance / 2.0F);
  view.contact = std::max(std::min(person.radius + room, view.distance - kSkin), 0.0F);
  return view;
}

bool heard(const VehicleView& view, const Senses& senses) {
  const VehicleShape& s = *view.shape;
  if (s.horn && view.distance <= kHornReach) return true;
  return s.moving() && view.distance <= senses.hearing * s.loudness;
}

Awareness awareness(const VehicleView& view, const Walker& person, const Senses& senses) {
  const float sight = view.shape->moving() ? senses.vehicle_sight : senses.sight;
  if (view.distance > sight) return heard(view, senses) ? Awareness::kHeard : Awareness::kNone;
  if (!view.shape->moving() || view.distance == 0.0F) return Awareness::kSeen;

  // The rectangle meets the cone of view when one of its corners lies inside or one of the cone's
  // borders runs through it.
  const VehicleShape& s = *view.shape;
  const Vec2f h = to_vehicle(s, person.heading_cos, person.heading_sin);
  // All of it lies behind a person who sees no farther round than to its sides.
  const bool behind = h.x * view.x + h.y * view.y > s.reach + kReachMargin;
  if (behind && senses.field_cos >= 0.0F) {
    return heard(view, senses) ? Awareness::kHeard : Awareness::kNone;
  }
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      const float cx = sx * s.half_length - view.x, cy = sy * s.half_width - view.y;
      if (cx * h.x + cy * h.y >= senses.field_cos * std::sqrt(cx * cx + cy * cy)) {
        return Awareness::kSeen;
      }
    }
  }
  for (const float side : {-1.0F, 1.0F}) {
    const float rx = h.x * senses.field_cos - h.y * senses.field_sin * side;
    const float ry = h.y * senses.field_cos + h.x * senses.field_sin * side;
    if (ray_meets(view.x, view.y, rx, ry, s, sight)) return Awareness::kSeen;
  }
  return heard(view, senses) ? Awareness::kHeard : Awareness::kNone;
}

bool touchable(const VehicleView& view, const Walker& person, float horizon) {
  // First time at which the circle round the vehicle meets all that the person can have reached:
  // |p + v·t| = R + V·t.
  const VehicleShape& s = *view.shape;
  const Vec2f v = to_vehicle(s, s.vx, s.vy);
  const float reach = s.reach + view.contact + kReachMargin;
  const float a = s.speed * s.speed - person.speed * person.speed;
  const float b = -(view.x * v.x + view.y * v.y) - reach * person.speed;
  const float c = view.x * view.x + view.y * view.y - reach * reach;
  if (c <= 0.0F) return true;
  const float square = b * b - a * c;
  if (square < 0.0F) return false;
  const float closing = std::sqrt(square) - b;
  return closing > 0.0F && c <= horizon * closing;
}

void add_vehicle(const VehicleView& view, const Walker& person, DiscList& discs, FaceList& faces) {
  const VehicleShape& s = *view.shape;
  discs.reserve(discs.size + 4);
  faces.reserve(faces.size + 4);
  FaceFrame frames[4];
  faces_of(view, frames);
  if (view.distance == 0.0F) {
    // Inside the rectangle: only directions that lead out through the nearest side are free.
    const auto nearest =
        std::max_element(std::begin(frames), std::end(frames),
                         [](const FaceFrame& a, const FaceFrame& b) { return a.out < b.out; });
    add_face(view, *nearest, true, faces);
    return;
  }
  for (const FaceFrame& face : frames) {
    if (face.out > 0.0F) add_face(view, face, false, faces);
  }
  for (const float sx : {-1.0F, 1.0F}) {
    for (const float sy : {-1.0F, 1.0F}) {
      // The corner opposite to the person is hidden behind the other three.
      if (sx * view.x < -s.half_length && sy * view.y < -s.half_width) continue;
      const Vec2f p = to_world(s, sx * s.half_length - view.x, sy * s.half_width - view.y);
      discs.add(p.x, p.y, s.vx, s.vy, view.contact, person.speed * person.speed);
    }
  }
}

float time_to_touch(const VehicleView& view, const Walker& person, const AssumedWalk& walk,
                    float from) {
  const VehicleShape& s = *view.shape;
  const Vec2f step = to_vehicle(s, walk.dx, walk.dy);
  const float x = view.x + step.x, y = view.y + step.y;
  const Vec2f w = to_vehicle(s, walk.vx - s.vx, walk.vy - s.vy);
  // The body as a square: sooner than the disc at corners, which is the careful side.
  const float room = std::max(view.contact, std::min(person.radius, view.distance));
  float enter = from, leave = kNever;
  cut_slab(x, w.x, s.half_length + room, enter, leave);
  cut_slab(y, w.y, s.half_width + room, enter, leave);
  return enter <= leave ? enter : kNever;
}

float time_to_leave_its_way(const VehicleView& view, float vx, float vy) {
  const VehicleShape& s = *view.shape;
  const float sideways = to_vehicle(s, vx - s.vx, vy - s.vy).y;
  const float side = (sideways == 0.0F ? view.y : sideways) < 0.0F ? -1.0F : 1.0F;
  const float way = s.half_width + view.contact - side * view.y;
  if (way <= 0.0F) return 0.0F;
  return sideways == 0.0F ? kNever : way / (side * sideways);
}

float cosine_to(const VehicleShape& vehicle, const Walker& person) {
  const float along = vehicle.vx * person.heading_cos + vehicle.vy * person.heading_sin;
  return along / vehicle.speed;
}

bool has_passed(const VehicleView& view) {
  const VehicleShape& s = *view.shape;
  const float forward = to_vehicle(s, s.vx, s.vy).x >= 0.0F ? 1.0F : -1.0F;
  return forward * view.x < -s.half_length;
}

// A vehicle moves along its own axis (reversing: against it), so its swept area is the rectangle
// stretched that way; `forward` is the side of its leading end.
float distance_in_its_way(const VehicleView& view, const Walker& person, float margin) {
  const VehicleShape& s = *view.shape;
  const float forward = to_vehicle(s, s.vx, s.vy).x >= 0.0F ? 1.0F : -1.0F;
  const float room = person.radius + margin;
  if (std::abs(view.y) > s.half_width + room) return kNotInItsWay;
  if (forward * view.x < -(s.half_length + room)) return kNotInItsWay;
  return std::max(forward * view.x - (s.half_length + room), 0.0F);
}

bool crosses_way(const VehicleView& view, const Walker& person, float ex, float ey, float distance,
                 float time) {
  const VehicleShape& s = *view.shape;
  const Vec2f v = to_vehicle(s, s.vx, s.vy);
  const Vec2f e = to_vehicle(s, ex, ey);
  const float forward = v.x >= 0.0F ? 1.0F : -1.0F;
  const float near = s.half_length, far = near + person.radius + std::abs(v.x) * time;
  const float middle = (near + far) / 2.0F, half = (far - near) / 2.0F;
  float enter = 0.0F, leave = distance;
  cut_slab(forward * view.x - middle, forward * e.x, half, enter, leave);
  cut_slab(view.y, e.y, s.half_width + person.radius, enter, leave);
  return enter <= leave;
}

}  // namespace pedzone
