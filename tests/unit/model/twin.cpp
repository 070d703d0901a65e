#include "twin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/fixed_point.hpp"
#include "world/speeds.hpp"

namespace pedzone::test {
namespace {

struct Velocity {
  float x, y;
};

Velocity velocity(const DirectionTask& task, std::size_t k) {
  const float hc = task.heading_cos * task.speed, hs = task.heading_sin * task.speed;
  const float oc = task.candidates.cosine[k], os = task.candidates.sine[k];
  return {hc * oc - hs * os, hs * oc + hc * os};
}

// b where a is not a number.
float larger(float a, float b) { return a > b ? a : b; }
float smaller(float a, float b) { return a < b ? a : b; }

float with_discs(const DiscView& discs, Velocity e, float u) {
  for (std::size_t j = 0; j < discs.size; ++j) {
    const DiscGroup& d = discs.groups[j / kObstacleGroup];
    const std::size_t i = j % kObstacleGroup;
    const float beta = d.px[i] * e.x + d.py[i] * e.y - d.q[i];
    const float alpha = d.a[i] - (d.wx[i] * e.x + d.wy[i] * e.y);
    u = larger(beta + std::sqrt(beta * beta - alpha), u);
  }
  return u;
}

float with_faces(const FaceView& faces, Velocity e, float u) {
  for (std::size_t j = 0; j < faces.size; ++j) {
    const FaceGroup& f = faces.groups[j / kObstacleGroup];
    const std::size_t i = j % kObstacleGroup;
    const float contact = f.nv[i] - (f.nx[i] * e.x + f.ny[i] * e.y);
    const float along = f.x[i] * contact + (f.dx[i] * e.x + f.dy[i] * e.y - f.dv[i]);
    if (f.half_length[i] * contact >= std::abs(along)) u = larger(contact, u);
  }
  return u;
}

/// Everybody in view, without asking who could be touched, all in the far space; no group is left
/// out of those met.
Seen see(const PersonSlots& slots, std::span<const SlotGroup> groups, const Sight& s,
         const SeenSpace&, const SeenSpace& far, SlotGroup* met) {
  if (met != nullptr) std::ranges::copy(groups, met);
  std::size_t n = 0;
  for (const SlotGroup& group : groups) {
    for (std::uint32_t i = 0; i < kSlotGroup; ++i) {
      if ((group.used >> i & 1U) == 0) continue;
      const std::size_t j = group.first + i;
      const float x = lattice_difference(slots.x[j], s.x), y = lattice_difference(slots.y[j], s.y);
      const float d2 = x * x + y * y;
      if (d2 > s.reach * s.reach || d2 == 0.0F) continue;
      const float ahead = x * s.heading_cos + y * s.heading_sin;
      if (ahead * std::abs(ahead) < s.field_cos * std::abs(s.field_cos) * d2) continue;
      const float vx = slots.vx[j], vy = slots.vy[j], v2 = vx * vx + vy * vy;
      const float wide =
          smaller(s.radius, s.shoulders.broadest) + smaller(slots.radius[j], s.shoulders.broadest);
      const float narrow = s.turned_radius + slots.turned_radius[j];
      const float alike = slots.hx[j] * s.heading_cos + slots.hy[j] * s.heading_sin;
      const float root = s.shoulders.straight + s.shoulders.facing * alike;
      const float straight = root * root;
      const float contact = larger(narrow, narrow + straight * (wide - narrow));
      const float still = contact + s.static_reach;
      if (v2 < kStaticSpeed * kStaticSpeed && d2 > still * still) continue;
      const float soft =
          larger((kTurnedSoftness - straight * (kTurnedSoftness - kSoftness)) * d2, kLeastDiscGap);
      const float gamma = 1.0F / larger(d2 - contact * contact, soft);
      DiscGroup& out = far.discs[n / kObstacleGroup];
      const std::size_t k = n++ % kObstacleGroup;
      out.px[k] = gamma * x;
      out.py[k] = gamma * y;
      out.q[k] = gamma * (x * vx + y * vy);
      out.a[k] = gamma * (s.speed * s.speed + v2);
      out.wx[k] = 2.0F * gamma * vx;
      out.wy[k] = 2.0F * gamma * vy;
    }
  }
  return {0, n, groups.size()};
}

DirectionChoice choose(const DirectionTask& task, std::size_t first, std::size_t count,
                       DirectionChoice best) {
  const CandidateView& c = task.candidates;
  const float gc = task.goal_cos * (2.0F * task.horizon);
  const float gs = task.goal_sin * (2.0F * task.horizon);
  for (std::size_t k = first; k < first + count; ++k) {
    if (std::isinf(task.cost[k])) continue;
    const Velocity e = velocity(task, k);
    float u = 1.0F / task.horizon;
    u = with_discs(task.near_discs, e, u);
    u = with_discs(task.far_discs, e, u);
    u = with_discs(task.vehicle_discs, e, u);
    u = with_faces(task.vehicle_faces, e, u);
    const float still = with_faces(task.still_faces, e, with_discs(task.still_discs, e, 0.0F));
    if (still >= 1.0F / task.static_horizon) u = larger(still, u);
    const float t = 1.0F / u;
    const float d = task.half_angle ? std::abs(gc * c.half_cosine[k] + gs * c.half_sine[k])
                                    : gc * c.cosine[k] + gs * c.sine[k];
    const DirectionChoice choice{static_cast<std::uint32_t>(k), t, t * (t - d) + task.cost[k], d};
    if (best.index == kNoDirection || better(choice, best)) best = choice;
  }
  return best;
}

/// Asks for all prices, then tries everything: it needs no direction to begin with.
DirectionChoice choose_priced(const DirectionTask& task, const DirectionPrices& prices,
                              DirectionChoice /*known*/) {
  for (std::size_t k = 0; k < task.candidates.padded; k += kDirectionGroup) {
    prices.ask(prices.asker, k, std::numeric_limits<float>::infinity());
  }
  DirectionTask priced = task;
  priced.cost = prices.cost;
  DirectionChoice none;
  none.index = kNoDirection;
  return choose(priced, 0, task.candidates.padded, none);
}

void times_of(const DirectionTask& task, const DiscView& discs, const FaceView& faces,
              std::size_t first, std::size_t count, float* out) {
  for (std::size_t k = first; k < first + count; ++k) {
    const Velocity e = velocity(task, k);
    out[k] = 1.0F / with_faces(faces, e, with_discs(discs, e, 1.0F / task.horizon));
  }
}

/// Distance outside (squared) and depth inside of the rectangle at one point of the way.
struct Place {
  float outside2, depth;
};

Place place(const VehicleFelt& v, Velocity way, float t) {
  const float x = std::abs(v.x + t * way.x) - v.half_length;
  const float y = std::abs(v.y + t * way.y) - v.half_width;
  const float dx = larger(x, 0.0F), dy = larger(y, 0.0F);
  return {dx * dx + dy * dy, std::min(-x, -y)};
}

float at_worst(const VehicleFelt& v, Velocity way) {
  const float inverse = 1.0F / larger(way.x * way.x + way.y * way.y, 1e-12F);
  const float nearest = std::clamp((0.0F - v.x * way.x - v.y * way.y) * inverse, 0.0F, 1.0F);
  const float near_x = v.x + nearest * way.x, near_y = v.y + nearest * way.y;
  if (near_x * near_x + near_y * near_y >= v.reach * v.reach) return 0.0F;
  const Place begin = place(v, way, 0.0F), end = place(v, way, 1.0F);
  // The corner farthest out on the side where the line passes the centre.
  const float side = way.x * v.y - way.y * v.x;
  const float corner_x = std::copysign(v.half_length, 0.0F - side * way.y) - v.x;
  const float corner_y = std::copysign(v.half_width, side * way.x) - v.y;
  const float passed = std::clamp((corner_x * way.x + corner_y * way.y) * inverse, 0.0F, 1.0F);
  float outside2 = std::min({begin.outside2, end.outside2, place(v, way, passed).outside2});
  float depth = 0.0F;
  if (std::abs(side) <= v.half_length * std::abs(way.y) + v.half_width * std::abs(way.x)) {
    const auto span = [](float from, float way_along, float half) {
      const float slope = 1.0F / (std::abs(way_along) <= 1e-12F ? way_along + 2e-12F : way_along);
      const float a = (0.0F - half - from) * slope, b = (half - from) * slope;
      return std::pair(std::min(a, b), std::max(a, b));
    };
    const auto along = span(v.x, way.x, v.half_length), across = span(v.y, way.y, v.half_width);
    const float enter = std::clamp(std::max(along.first, across.first), 0.0F, 1.0F);
    const float leave = std::clamp(std::min(along.second, across.second), 0.0F, 1.0F);
    const Place middle = place(v, way, 0.5F * (enter + leave));
    outside2 = std::min(outside2, middle.outside2);
    depth = std::max({middle.depth, begin.depth, end.depth, 0.0F});
  }
  const float of_margin = 1.0F / v.margin;
  const float share = larger(1.0F - std::sqrt(outside2) * of_margin, 0.0F);
  return share * share + depth * (0.5F * of_margin);
}

void discomfort(const DirectionTask& task, const VehicleFelt& v, const PacedWalk& walk,
                std::size_t first, std::size_t count, float* out) {
  const float speed = walk.share * task.speed;
  const float hc = speed * (task.heading_cos * v.cos + task.heading_sin * v.sin);
  const float hs = speed * (task.heading_sin * v.cos - task.heading_cos * v.sin);
  const Velocity drive{0.0F - v.vx * v.cos - v.vy * v.sin, v.vx * v.sin - v.vy * v.cos};
  for (std::size_t k = first; k < first + count; ++k) {
    const float oc = task.candidates.cosine[k], os = task.candidates.sine[k];
    const float ex = hc * oc - hs * os, ey = hs * oc + hc * os;
    VehicleFelt begin = v;
    begin.x = v.x + walk.glide * (walk.vx * v.cos + walk.vy * v.sin) - ex * walk.glide;
    begin.y = v.y + walk.glide * (walk.vy * v.cos - walk.vx * v.sin) - ey * walk.glide;
    const float walks = smaller(walk.stop[k] * (1.0F / walk.share), walk.time);
    const Velocity way{(ex + drive.x) * walks, (ey + drive.y) * walks};
    out[k] = std::max(out[k], at_worst(begin, way));
    const float stands = walk.time - walks;
    if (stands <= 0.0F) continue;
    VehicleFelt later = begin;
    later.x += way.x;
    later.y += way.y;
    out[k] = std::max(out[k], at_worst(later, {drive.x * stands, drive.y * stands}));
  }
}

}  // namespace

const DirectionKernel& twin_kernel() {
  static constexpr DirectionKernel kTwin{"twin", see, choose, choose_priced, times_of, discomfort};
  return kTwin;
}

}  // namespace pedzone::test
