// Picks out whom a person sees, for one kind of vector. Included by one source file for each
// instruction set; everything is a template on the vector (see direction_kernel_impl.hpp).
//
// Left out is who cannot be touched before the horizon T: somebody no faster than V touches at some
// t ≤ T only if |p + v·t| ≤ R + V·t, and then |p + v·T| ≤ R + V·T. First, for all slots, R is more
// than any contact distance; how far apart two touch is asked for those that are left.
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
    Float heading_cos, heading_sin, field, reach2, radius, turned, speed2, horizon, farthest2, soon,
        soonest2, static_reach, straight, facing, broadest;

    Seer(const Sight& s, float broadest_other)
        : x(s.x),
          y(s.y),
          heading_cos(Float::all(s.heading_cos)),
          heading_sin(Float::all(s.heading_sin)),
          field(Float::all(s.field_cos * (s.field_cos < 0.0F ? -s.field_cos : s.field_cos))),
          reach2(Float::all(s.reach * s.reach)),
          radius(smaller(Float::all(s.radius), Float::all(s.shoulders.broadest))),
          turned(Float::all(s.turned_radius)),
          speed2(Float::all(s.speed * s.speed)),
          horizon(Float::all(s.horizon)),
          soon(Float::all(s.soon)),
          static_reach(Float::all(s.static_reach)),
          straight(Float::all(s.shoulders.straight)),
          facing(Float::all(s.shoulders.facing)),
          broadest(Float::all(s.shoulders.broadest)) {
      const float own = s.radius > s.turned_radius ? s.radius : s.turned_radius;
      const float most = own + broadest_other;  // more than any contact distance
      const float farthest = most + s.speed * s.horizon * (1.0F + kReachShare) + kReachMargin;
      const float soonest = most + s.speed * s.soon;
      soonest2 = Float::all(soonest * soonest);
      farthest2 = Float::all(farthest * farthest);
    }
  };

  static Seen see(const PersonSlots& slots, std::span<const SlotGroup> groups, const Sight& sight,
                  const SeenSpace& near, const SeenSpace& far, SlotGroup* met) {
    // Where shoulders do not depend on headings, nobody's heading is read.
    return sight.shoulders.facing == 0.0F ? see<false>(slots, groups, sight, near, far, met)
                                          : see<true>(slots, groups, sight, near, far, met);
  }

  template <bool kByFacing>
  static Seen see(const PersonSlots& slots, std::span<const SlotGroup> groups, const Sight& sight,
                  const SeenSpace& near_space, const SeenSpace& far_space, SlotGroup* met) {
    const Seer seer(sight, slots.broadest);
    const PersonSlots persons = slots;  // copies: nothing that is written can change them
    const SeenSpace near = near_space, far = far_space;
    Seen seen{0, 0, 0};
    for (const SlotGroup group : groups) {
      std::uint32_t picked = 0;
      for (std::uint32_t half = 0; half < kSlotGroup; half += kLanes) {
        const std::uint32_t used = group.used >> half & ((1U << kLanes) - 1U);
        picked |= spot<kByFacing>(persons, group.first + half, used, seer, near, far, seen) << half;
      }
      if (met != nullptr) met[seen.groups] = {group.first, picked};
      seen.groups += picked != 0;
    }
    make_discs<kByFacing>(near, seen.near, seer);
    make_discs<kByFacing>(far, seen.far, seer);
    return seen;
  }

  /// Adds those of the slots whom it sees and may touch to the near or far ones; returns which.
  template <bool kByFacing>
  static std::uint32_t spot(const PersonSlots& slots, std::size_t first, std::uint32_t used,
                            const Seer& s, const SeenSpace& near, const SeenSpace& far, Seen& n) {
    const Float x = Float::metres(slots.x + first, s.x);
    const Float y = Float::metres(slots.y + first, s.y);
    const Float d2 = x * x + y * y;
    // cos of the angle to the heading ≥ cos of the half field, both squared with their signs.
    const Float ahead = x * s.heading_cos + y * s.heading_sin;
    const Float seen = both(both(at_least(s.reach2, d2), more(d2, Float::all(0.0F))),
                            at_least(ahead * absolute(ahead), s.field * d2));
    const Float vx = Float::load(slots.vx + first), vy = Float::load(slots.vy + first);
    const Float fx = x + vx * s.horizon, fy = y + vy * s.horizon;
    const Float touchable = either(at_least(s.farthest2, fx * fx + fy * fy),
                                   more(Float::load(slots.speed2 + first), s.speed2));
    const Float sx = x + vx * s.soon, sy = y + vy * s.soon;
    const std::uint32_t lanes = bits(both(seen, touchable)) & used;
    const std::uint32_t close = bits(at_least(s.soonest2, sx * sx + sy * sy)) & lanes;
    const auto add = [&](std::uint32_t some, const SeenSpace& space, std::size_t& count) {
      const typename Float::Packer pack(some);
      pack.store(x, space.x + count);
      pack.store(y, space.y + count);
      pack.store(vx, space.vx + count);
      pack.store(vy, space.vy + count);
      pack.store(Float::load(slots.radius + first), space.radius + count);
      pack.store(Float::load(slots.turned_radius + first), space.turned + count);
      if constexpr (kByFacing) {
        pack.store(Float::load(slots.hx + first), space.hx + count);
        pack.store(Float::load(slots.hy + first), space.hy + count);
      }
      count += static_cast<std::size_t>(__builtin_popcount(some));
    };
    if (close != 0) add(close, near, n.near);
    add(lanes & ~close, far, n.far);
    return lanes;
  }

  /// Turns the n persons of a space into discs.
  template <bool kByFacing>
  static void make_discs(const SeenSpace& space, std::size_t n, const Seer& seer) {
    for (std::size_t j = n; j % kFarGroup != 0; ++j) {  // somebody far away: never touched
      space.x[j] = space.y[j] = kFarAway;
      space.vx[j] = space.vy[j] = space.radius[j] = space.turned[j] = 0.0F;
      if constexpr (kByFacing) space.hx[j] = space.hy[j] = 0.0F;
    }
    for (std::size_t j = 0; j < n; j += kFarGroup) {
      for (std::size_t i = j; i < j + kFarGroup; i += kLanes) {
        make_lanes<kByFacing>(space, i, seer);
      }
    }
  }

  template <bool kByFacing>
  static void make_lanes(const SeenSpace& space, std::size_t j, const Seer& s) {
    const Float x = Float::load(space.x + j), y = Float::load(space.y + j);
    const Float vx = Float::load(space.vx + j), vy = Float::load(space.vy + j);
    const Float wide = s.radius + smaller(Float::load(space.radius + j), s.broadest);
    const Float narrow = s.turned + Float::load(space.turned + j);
    Float root = s.straight;
    if constexpr (kByFacing) {
      root = root + s.facing * (Float::load(space.hx + j) * s.heading_cos +
                                Float::load(space.hy + j) * s.heading_sin);
    }
    const Float q = root * root;
    const Float contact = larger(narrow, narrow + q * (wide - narrow));
    const Float softness =
        Float::all(kTurnedSoftness) - q * Float::all(kTurnedSoftness - kSoftness);
    const Float d2 = x * x + y * y, v2 = vx * vx + vy * vy;
    const Float free =
        larger(d2 - contact * contact, larger(softness * d2, Float::all(kLeastDiscGap)));
    // Who stands too far away to count is touched by nobody: the root of −1.
    const Float still = contact + s.static_reach;
    const Float counts =
        either(at_least(v2, Float::all(kStaticSpeed * kStaticSpeed)), at_least(still * still, d2));
    const Float gamma = both(counts, Float::all(1.0F) / free);
    DiscGroup& g = space.discs[j / kObstacleGroup];
    const std::size_t i = j % kObstacleGroup;
    (gamma * x).store(g.px + i);
    (gamma * y).store(g.py + i);
    (gamma * (x * vx + y * vy)).store(g.q + i);
    either(gamma * (s.speed2 + v2), without(Float::all(1.0F), counts)).store(g.a + i);
    (Float::all(2.0F) * gamma * vx).store(g.wx + i);
    (Float::all(2.0F) * gamma * vy).store(g.wy + i);
  }
};

}  // namespace pedzone
