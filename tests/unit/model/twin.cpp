#include "twin.hpp"

#include <cmath>

#include "model/fixed_point.hpp"

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

float larger(float a, float b) { return a > b ? a : b; }  // b where a is not a number

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

/// Everybody in view, without asking who could be touched, all in the far space.
Seen see(const PersonSlots& slots, const SlotGroup* groups, std::size_t count, const Sight& s,
         const SeenSpace&, const SeenSpace& far) {
  std::size_t n = 0;
  for (std::size_t g = 0; g < count; ++g) {
    for (std::uint32_t i = 0; i < kSlotGroup; ++i) {
      if ((groups[g].used >> i & 1U) == 0) continue;
      const std::size_t j = groups[g].first + i;
      const float x = lattice_difference(slots.x[j], s.x), y = lattice_difference(slots.y[j], s.y);
      const float d2 = x * x + y * y;
      if (d2 > s.reach * s.reach || d2 == 0.0F) continue;
      const float ahead = x * s.heading_cos + y * s.heading_sin;
      if (ahead * std::abs(ahead) < s.field_cos * std::abs(s.field_cos) * d2) continue;
      const float vx = slots.vx[j], vy = slots.vy[j], v2 = vx * vx + vy * vy;
      const float contact = s.radius + slots.radius[j], still = contact + s.static_reach;
      if (v2 < kStandingSpeed * kStandingSpeed && d2 > still * still) continue;
      const float soft = larger(kSoftness * d2, kLeastDiscGap);
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
  return {0, n};
}

DirectionChoice choose(const DirectionTask& task, std::size_t first, std::size_t count,
                       DirectionChoice best) {
  const CandidateView& c = task.candidates;
  const float gc = task.goal_cos * (2.0F * task.horizon);
  const float gs = task.goal_sin * (2.0F * task.horizon);
  for (std::size_t k = first; k < first + count; ++k) {
    if (task.excluded[k] != 0.0F) continue;
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
    const DirectionChoice choice{static_cast<std::uint32_t>(k), t, t * (t - d), d};
    if (best.index == kNoDirection || better(choice, best)) best = choice;
  }
  return best;
}

void times_of(const DirectionTask& task, const DiscView& discs, const FaceView& faces, float* out) {
  for (std::size_t k = 0; k < task.candidates.padded; ++k) {
    const Velocity e = velocity(task, k);
    out[k] = 1.0F / with_faces(faces, e, with_discs(discs, e, 1.0F / task.horizon));
  }
}

}  // namespace

const DirectionKernel& twin_kernel() {
  static constexpr DirectionKernel kTwin{"twin", see, choose, times_of};
  return kTwin;
}

}  // namespace pedzone::test
