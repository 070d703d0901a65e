// Picks out whom a person sees, for one kind of vector. Included by one source file for each
// instruction set; everything is a template on the vector (see direction_kernel_impl.hpp).
//
// Left out is who cannot be touched before the horizon T: somebody no faster than V touches at some
// t ≤ T only if |p + v·t| ≤ R + V·t, and then |p + v·T| ≤ R + V·T.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "model/direction_kernel.hpp"
#include "world/speeds.hpp"

namespace pedzone {

template <class Float>
struct SightImpl {
  static constexpr std::size_t kLanes = Float::kLanes;

  /// [m] plus a share of the distance seen: protects from rounding, where near-grazing contacts
  /// lose half of their digits (3e-4 of the time to contact).
  static constexpr float kReachMargin = 0.01F, kReachShare = 0.001F;
  /// [m] somebody there is touched by nobody.
  static constexpr float kFarAway = 1e6F;

  /// What `see` compares with, in vectors.
  struct Seer {
    std::int32_t x, y;
    Float heading_cos, heading_sin, field, reach2, near2, radius, turned, speed2, horizon, walk,
        static_reach, straight, facing, broadest;

    explicit Seer(const Sight& s)
        : x(s.x),
          y(s.y),
          heading_cos(Float::all(s.heading_cos)),
          heading_sin(Float::all(s.heading_sin)),
          field(Float::all(s.field_cos * (s.field_cos < 0.0F ? -s.field_cos : s.field_cos))),
          reach2(Float::all(s.reach * s.reach)),
          near2(Float::all(s.near * s.near)),
          radius(smaller(Float::all(s.radius), Float::all(s.shoulders.broadest))),
          turned(Float::all(s.turned_radius)),
          speed2(Float::all(s.speed * s.speed)),
          horizon(Float::all(s.horizon)),
          walk(Float::all(s.speed * s.horizon * (1.0F + kReachShare) + kReachMargin)),
          static_reach(Float::all(s.static_reach)),
          straight(Float::all(s.shoulders.straight)),
          facing(Float::all(s.shoulders.facing)),
          broadest(Float::all(s.shoulders.broadest)) {}
  };

  static Seen see(const PersonSlots& slots, std::span<const SlotGroup> groups, const Sight& sight,
                  const SeenSpace& near, const SeenSpace& far, SlotGroup* met) {
    const Seer seer(sight);
    const PersonSlots persons = slots;
    const SeenSpace near_space = near, far_space = far;
    Seen seen{0, 0, 0};
    for (const SlotGroup group : groups) {
      std::uint32_t picked = 0;
      for (std::uint32_t half = 0; half < kSlotGroup; half += kLanes) {
        const std::uint32_t used = group.used >> half & ((1U << kLanes) - 1U);
        picked |= see_lanes(persons, group.first + half, used, seer, near_space, far_space, seen)
                  << half;
      }
      if (met != nullptr) met[seen.groups] = {group.first, picked};
      seen.groups += picked != 0;
    }
    finish_discs(near_space, seen.near, seer.speed2);
    finish_discs(far_space, seen.far, seer.speed2);
    return seen;
  }

  static std::uint32_t see_lanes(const PersonSlots& slots, std::size_t first, std::uint32_t used,
                                 const Seer& s, const SeenSpace& near, const SeenSpace& far,
                                 Seen& n) {
    Spotted p;
    p.x = Float::metres(slots.x + first, s.x);
    p.y = Float::metres(slots.y + first, s.y);
    const Float d2 = p.x * p.x + p.y * p.y;
    // cos of the angle to the heading ≥ cos of the half field, both squared with their signs.
    const Float ahead = p.x * s.heading_cos + p.y * s.heading_sin;
    const Float seen = both(both(at_least(s.reach2, d2), more(d2, Float::all(0.0F))),
                            at_least(ahead * absolute(ahead), s.field * d2));

    p.vx = Float::load(slots.vx + first);
    p.vy = Float::load(slots.vy + first);
    const Float wide = s.radius + smaller(Float::load(slots.radius + first), s.broadest);
    const Float narrow = s.turned + Float::load(slots.turned_radius + first);
    const Float alike = Float::load(slots.hx + first) * s.heading_cos +
                        Float::load(slots.hy + first) * s.heading_sin;
    const Float root = s.straight + s.facing * alike, q = root * root;
    const Float contact = larger(narrow, narrow + q * (wide - narrow));
    const Float v2 = Float::load(slots.speed2 + first);
    const Float fx = p.x + p.vx * s.horizon, fy = p.y + p.vy * s.horizon;
    const Float farthest = contact + s.walk, still = contact + s.static_reach;
    const Float touchable =
        either(at_least(farthest * farthest, fx * fx + fy * fy), more(v2, s.speed2));
    const Float counts =
        either(at_least(v2, Float::all(kStaticSpeed * kStaticSpeed)), at_least(still * still, d2));

    const Float softness =
        Float::all(kTurnedSoftness) - q * Float::all(kTurnedSoftness - kSoftness);
    p.free = larger(d2 - contact * contact, larger(softness * d2, Float::all(kLeastDiscGap)));

    const std::uint32_t lanes = bits(both(both(seen, touchable), counts)) & used;
    const std::uint32_t close = bits(at_least(s.near2, d2)) & lanes;
    if (close != 0) n.near += p.store(close, near, n.near);
    n.far += p.store(lanes & ~close, far, n.far);
    return lanes;
  }

  /// Persons picked out.
  struct Spotted {
    Float x, y, vx, vy, free;

    std::size_t store(std::uint32_t lanes, const SeenSpace& space, std::size_t n) const {
      const typename Float::Packer pack(lanes);
      pack.store(x, space.x + n);
      pack.store(y, space.y + n);
      pack.store(vx, space.vx + n);
      pack.store(vy, space.vy + n);
      pack.store(free, space.free + n);
      return static_cast<std::size_t>(__builtin_popcount(lanes));
    }
  };

  /// Turns the n persons of a space into discs.
  static void finish_discs(const SeenSpace& space, std::size_t n, Float speed2) {
    for (std::size_t j = n; j % kFarGroup != 0; ++j) {  // somebody far away: never touched
      space.x[j] = space.y[j] = kFarAway;
      space.vx[j] = space.vy[j] = 0.0F;
      space.free[j] = kFarAway * kFarAway;
    }
    for (std::size_t j = 0; j < n; j += kFarGroup) {
      for (std::size_t i = j; i < j + kFarGroup; i += kLanes) finish_lanes(space, i, speed2);
    }
  }

  static void finish_lanes(const SeenSpace& space, std::size_t j, Float speed2) {
    const Float x = Float::load(space.x + j), y = Float::load(space.y + j);
    const Float vx = Float::load(space.vx + j), vy = Float::load(space.vy + j);
    const Float gamma = Float::all(1.0F) / Float::load(space.free + j);
    DiscGroup& g = space.discs[j / kObstacleGroup];
    const std::size_t i = j % kObstacleGroup;
    (gamma * x).store(g.px + i);
    (gamma * y).store(g.py + i);
    (gamma * (x * vx + y * vy)).store(g.q + i);
    (gamma * (speed2 + (vx * vx + vy * vy))).store(g.a + i);
    (Float::all(2.0F) * gamma * vx).store(g.wx + i);
    (Float::all(2.0F) * gamma * vy).store(g.wy + i);
  }
};

}  // namespace pedzone
