// The discomfort of a vehicle in each direction, for one kind of vector. Included by one source
// file for each instruction set; everything is a template on the vector
// (direction_kernel_impl.hpp).
//
// The signed distance to a rectangle is convex along a line. Its least value on the way is at the
// way's begin, its end, where it passes a corner, or in the middle of where it crosses the
// rectangle (exact outside; inside, the depth there stands for the greatest one).
#pragma once

#include <cstddef>

#include "model/direction_kernel.hpp"

namespace pedzone {

template <class Float>
struct DiscomfortImpl {
  static constexpr std::size_t kLanes = Float::kLanes;
  /// Protects from dividing by zero: [m] a way so short in one axis counts as none.
  static constexpr float kLeast = 1e-12F;

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
    // Away from zero on the side of its own sign; which one for zero itself does not matter.
    const Float inverse = u / larger(u * u, all(kLeast));
    const Float a = (all(0.0F) - half - x) * inverse, b = (half - x) * inverse;
    return {smaller(a, b), larger(a, b)};
  }

  static Float of_way(const Way& w, Float margin) {
    const Float zero = all(0.0F), one = all(1.0F);
    Float least2 = smaller(outside2(w, zero), outside2(w, one));
    const Float inverse = one / larger(w.ux * w.ux + w.uy * w.uy, all(kLeast));
    for (const float sx : {-1.0F, 1.0F}) {
      for (const float sy : {-1.0F, 1.0F}) {
        const Float to_x = all(sx) * w.half_length - w.x, to_y = all(sy) * w.half_width - w.y;
        const Float t = within((to_x * w.ux + to_y * w.uy) * inverse, zero, one);
        least2 = smaller(outside2(w, t), least2);
      }
    }
    const Span along = slab(w.x, w.ux, w.half_length), across = slab(w.y, w.uy, w.half_width);
    const Float enter = within(larger(along.enter, across.enter), zero, one);
    const Float leave = within(smaller(along.leave, across.leave), zero, one);
    const Float middle = all(0.5F) * (enter + leave);
    least2 = smaller(outside2(w, middle), least2);
    const Float deep = larger(depth(w, middle), larger(depth(w, zero), depth(w, one)));
    const Float share = larger(one - sqrt(least2) / margin, zero);
    return share * share + larger(deep, zero) * (all(0.5F) / margin);
  }

  /// In the vehicle's frame.
  static void turn(const Annoyance& v, Float x, Float y, Float& ahead, Float& left) {
    ahead = x * all(v.cos) + y * all(v.sin);
    left = y * all(v.cos) - x * all(v.sin);
  }

  static void discomfort(const DirectionTask& task, const Annoyance& v, const Stroll& stroll,
                         std::size_t first, std::size_t count, float* out) {
    const float speed = stroll.share * task.speed;
    const Float hc = all(task.heading_cos * speed), hs = all(task.heading_sin * speed);
    const Float time = all(stroll.time), margin = all(v.margin);
    Float drive_x, drive_y;  // standing, the person moves so in the vehicle's frame [m/s]
    turn(v, all(-v.vx), all(-v.vy), drive_x, drive_y);
    for (std::size_t k = first; k < first + count; k += kLanes) {
      const Float oc = Float::load(task.candidates.cosine + k);
      const Float os = Float::load(task.candidates.sine + k);
      const Float ex = hc * oc - hs * os, ey = hs * oc + hc * os;  // wanted [m/s]
      Way way{all(v.x), all(v.y), ex, ey, all(v.half_length), all(v.half_width)};
      turn(v, ex - all(v.vx), ey - all(v.vy), way.ux, way.uy);
      Float lag_x, lag_y;
      turn(v, all(stroll.vx) - ex, all(stroll.vy) - ey, lag_x, lag_y);
      way.x = way.x + lag_x * all(stroll.glide);
      way.y = way.y + lag_y * all(stroll.glide);
      const Float walks = smaller(Float::load(stroll.stop + k) / all(stroll.share), time);
      way.ux = way.ux * walks;
      way.uy = way.uy * walks;
      Float worst = larger(of_way(way, margin), Float::load(out + k));
      if (bits(more(time, walks)) != 0) {
        const Float stands = time - walks;
        const Way waits{way.x + way.ux,   way.y + way.uy,  drive_x * stands,
                        drive_y * stands, way.half_length, way.half_width};
        worst = larger(of_way(waits, margin), worst);
      }
      worst.store(out + k);
    }
  }
};

}  // namespace pedzone
