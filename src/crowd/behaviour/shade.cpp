#include "crowd/behaviour/shade.hpp"

#include <optional>

#include "crowd/state/route.hpp"
#include "geometry/polygon.hpp"
#include "geometry/segment.hpp"

namespace pedzone {
namespace {

constexpr double kDetour = 1.2;  // assumed: so much longer people walk for some shade
constexpr double kWorth = 3.0;   // [m] assumed: less shade is not worth a turn
constexpr double kInside = 0.5;  // [m] numerical: towards the middle, so that the body is in it

/// The place of the shade next to `point`, a little inside; the point itself where it is in it.
Vec2 enter(const Polygon& polygon, const Vec2& point) {
  if (contains({polygon}, point)) return point;
  const Ring& shade = polygon.outer;
  Vec2 nearest = shade.front(), middle = Vec2::Zero();
  for (std::size_t k = 0; k < shade.size(); ++k) {
    const Vec2 on = nearest_on(shade[k], shade[(k + 1) % shade.size()], point);
    if ((on - point).squaredNorm() < (nearest - point).squaredNorm()) nearest = on;
    middle += shade[k] / static_cast<double>(shade.size());
  }
  const Vec2 inwards = middle - nearest;
  return nearest + inwards * std::min(1.0, kInside / std::max(inwards.norm(), 1e-9));
}

}  // namespace

std::vector<Waypoint> way_through_shade(const Zone& zone, const Vec2& from,
                                        const Destination& destination) {
  std::vector<Waypoint> best;
  const Vec2 goal = 0.5 * (destination.a + destination.b);
  double least = kDetour * (goal - from).norm();
  for (const Region& shade : zone.shades) {
    for (const Polygon& polygon : shade) {
      const Vec2 in = enter(polygon, from), out = enter(polygon, goal);
      const double walked = (in - from).norm() + (out - in).norm() + (goal - out).norm();
      if (walked > least || (out - in).norm() < kWorth) continue;
      if (!zone.walls.inside(in) || !zone.walls.inside(out)) continue;
      least = walked;
      best.clear();
      if (in != from) best.push_back({in, zone.parameters.waypoint_radius});
      if (out != goal) best.push_back({out, zone.parameters.waypoint_radius});
    }
  }
  return best;
}

}  // namespace pedzone
