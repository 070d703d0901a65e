// The discomfort of a vehicle in each direction, for one kind of vector. Included by one source
// file for each instruction set; everything is a template on the vector
// (direction_kernel_impl.hpp).
//
// The signed distance to a rectangle is convex along a line. Its least value on the way is at the
// way's begin, its end, where it passes a corner, or in the middle of where it crosses the
// rectangle (exact outside; inside, the depth there stands for the greatest one).
#pragma once

#include <cstddef>
#include <cstdint>

#include "model/direction_kernel.hpp"

namespace pedzone {

template <class Float>
struct DiscomfortImpl {
  static constexpr std::size_t kLanes = Float::kLanes;
  /// Protects from dividing by zero: [m] a way so short in one axis counts as none.
  static constexpr float kLeast = 1e-12F;
  static constexpr std::uint32_t kAll = (1U << kLanes) - 1;

  static Float all(float x) { return Float::all(x); }
  static Float within(Float x, Float least, Float most) { return smaller(larger(x, least), most); }

  /// The person's way in the vehicle's frame: from (x, y) by (ux, uy).
  struct Way {
    Float x, y, ux, uy;
    Float half_length, half_width;
  };

  /// Square of the distance outside the rectangle [m²] at share t of the way; 0 inside.
  static Float outside2(const Way& w, Float t) {
    const Float dx = larger(absolute(w.x + t * w.ux) - w.half_length, all(0.0F));
    const Float dy = larger(absolute(w.y + t * w.uy) - w.half_width, all(0.0F));
    return dx * dx + dy * dy;
  }

  /// Depth inside the rectangle [m] at share t of the way; negative outside.
  static Float depth(const Way& w, Float t) {
    return smaller(w.half_length - absolute(w.x + t * w.ux),
                   w.half_width - absolute(w.y + t * w.uy));
  }

  /// Shares of the way between which |x| ≤ half; a vector without length keeps a tiny one.
  struct Span {
    Float enter, leave;
  };
  static Span slab(Float x, Float u, Float half) {
    // Away from zero; on which side does not matter, since neither end is then within the way.
    const Float inverse =
        all(1.0F) / (u + both(at_least(all(kLeast), absolute(u)), all(2.0F * kLeast)));
    const Float a = (all(0.0F) - half - x) * inverse, b = (half - x) * inverse;
    return {smaller(a, b), larger(a, b)};
  }

  /// h of a way that may come near; `inverse`: 1 over the square of its length. A line that misses
  /// the rectangle has its least distance where it passes one corner: the farthest one on its side.
  static Float of_way(const Way& w, Float inverse, float of_margin) {
    const Float zero = all(0.0F), one = all(1.0F);
    const Float side = w.ux * w.y - w.uy * w.x;
    const Float to_x = signed_as(w.half_length, zero - side * w.uy) - w.x;
    const Float to_y = signed_as(w.half_width, side * w.ux) - w.y;
    const Float corner = within((to_x * w.ux + to_y * w.uy) * inverse, zero, one);
    Float least2 = smaller(outside2(w, corner), smaller(outside2(w, zero), outside2(w, one)));
    Float deep = zero;
    const Float extent = w.half_length * absolute(w.uy) + w.half_width * absolute(w.ux);
    const Float misses = more(absolute(side), extent);
    if (bits(misses) != kAll) {
      const Span along = slab(w.x, w.ux, w.half_length), across = slab(w.y, w.uy, w.half_width);
      const Float enter = within(larger(along.enter, across.enter), zero, one);
      const Float leave = within(smaller(along.leave, across.leave), zero, one);
      const Float middle = all(0.5F) * (enter + leave);
      least2 = smaller(either(misses, outside2(w, middle)), least2);
      deep = larger(depth(w, middle), larger(depth(w, zero), depth(w, one)));
      deep = larger(either(misses, deep), zero);
    }
    const Float share = larger(one - sqrt(least2) * all(of_margin), zero);
    return share * share + deep * all(0.5F * of_margin);
  }

  /// Raises `worst` to the way's h where it `counts`. Most ways come nowhere near the circle around
  /// the rectangle and its margin. (What a lane gets must not depend on its neighbours: vectors of
  /// all lengths give the same bits.)
  static void raise(const Way& w, const VehicleFelt& v, Float counts, Float& worst) {
    const Float zero = all(0.0F);
    const Float inverse = all(1.0F) / larger(w.ux * w.ux + w.uy * w.uy, all(kLeast));
    const Float t = within((zero - w.x * w.ux - w.y * w.uy) * inverse, zero, all(1.0F));
    const Float x = w.x + t * w.ux, y = w.y + t * w.uy;
    const Float near = both(counts, more(all(v.reach * v.reach), x * x + y * y));
    if (bits(near) != 0) worst = larger(both(near, of_way(w, inverse, 1.0F / v.margin)), worst);
  }

  static void discomfort(const DirectionTask& task, const VehicleFelt& v, const PacedWalk& walk,
                         std::size_t first, std::size_t count, float* out) {
    const float speed = walk.share * task.speed;
    // All in the vehicle's frame: the person's heading, its present velocity, and how it moves
    // while it stands [m/s].
    const float hc = speed * (task.heading_cos * v.cos + task.heading_sin * v.sin);
    const float hs = speed * (task.heading_sin * v.cos - task.heading_cos * v.sin);
    const float present_x = walk.vx * v.cos + walk.vy * v.sin;
    const float present_y = walk.vy * v.cos - walk.vx * v.sin;
    const Float drive_x = all(-v.vx * v.cos - v.vy * v.sin);
    const Float drive_y = all(v.vx * v.sin - v.vy * v.cos);
    const Float start_x = all(v.x + walk.glide * present_x);
    const Float start_y = all(v.y + walk.glide * present_y);
    const Float time = all(walk.time), glide = all(walk.glide);
    const Float slower = all(1.0F / walk.share);
    for (std::size_t k = first; k < first + count; k += kLanes) {
      const Float oc = Float::load(task.candidates.cosine + k);
      const Float os = Float::load(task.candidates.sine + k);
      const Float ex = all(hc) * oc - all(hs) * os, ey = all(hs) * oc + all(hc) * os;  // wanted
      // How long it walks: not a number, all the time, where it does not walk from before a wall.
      const Float walks = smaller(Float::load(walk.stop + k) * slower, time);
      const Way way{start_x - ex * glide,   start_y - ey * glide, (ex + drive_x) * walks,
                    (ey + drive_y) * walks, all(v.half_length),   all(v.half_width)};
      Float worst = Float::load(out + k);
      raise(way, v, at_least(time, walks), worst);
      const Float waits_there = more(time, walks);
      if (bits(waits_there) != 0) {
        const Float stands = time - walks;
        const Way waits{way.x + way.ux,   way.y + way.uy,  drive_x * stands,
                        drive_y * stands, way.half_length, way.half_width};
        raise(waits, v, waits_there, worst);
      }
      worst.store(out + k);
    }
  }
};

}  // namespace pedzone
