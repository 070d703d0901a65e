#include "zone/way_cutter.hpp"

#include <algorithm>

#include "zone/passage.hpp"

namespace pedzone {
namespace {

// assumed: corridors are as wide as the lane, up to this; what a lorry needs [m].
constexpr double kWidestCorridor = 4.0;
// assumed: on lanes wider than that an obstacle stays where a passage of twice this is left beside
// it, so that a fountain on a square is no reason to cut [m].
constexpr double kBroadRoom = 1.0;

struct Cut {
  std::size_t obstacle;
  Region corridor;
};

bool meets(const ShapedPolygon& obstacle, const Region& region) {
  return obstacle.box.intersects(box_of(region)) && !intersect(obstacle.region, region).empty();
}

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (!Box(a.cwiseMin(b), a.cwiseMax(b)).intersects(Box(c.cwiseMin(d), c.cwiseMax(d))))
    return false;
  const auto parted = [](const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
    return cross(q - p, r - p) * cross(q - p, s - p) > 0.0;
  };
  return !parted(a, b, c, d) && !parted(c, d, a, b);
}

bool touches(const Ring& ring, const Vec2& a, const Vec2& b) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (segments_meet(a, b, ring[j], ring[i])) return true;
  }
  return false;
}

/// Whether a line has a point in a region or on its border.
bool touches(const Region& region, const Polyline& line) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (const Polygon& polygon : region) {
      if (touches(polygon.outer, line[i], line[i + 1])) return true;
      for (const Ring& hole : polygon.holes) {
        if (touches(hole, line[i], line[i + 1])) return true;
      }
    }
  }
  return contains(region, line.front());
}

bool passable(const Lane& lane, const Region& free, double room) {
  const double inset = std::max(0.5, 1.5 * room);
  return Passages(free, room)
      .joins(inner_point(lane.shape, false, inset), inner_point(lane.shape, true, inset));
}

/// Which obstacles have to be cut for one lane.
class LaneCutter {
 public:
  LaneCutter(const Lane& lane, const std::vector<ShapedPolygon>& obstacles)
      : lane_(lane), obstacles_(obstacles), area_(area_of(lane)) {
    const Box box = box_of(lane);
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      if (box.intersects(obstacles[i].box) && meets(obstacles[i], area_)) near_.push_back(i);
    }
  }

  void find_cuts(std::vector<Cut>& cuts, std::vector<std::string>& warnings) {
    if (near_.empty()) return;
    const Region corridor =
        widen(lane_.shape, std::clamp(lane_.width, kLeastLaneWidth, kWidestCorridor));
    std::vector<std::size_t> kept;
    for (const std::size_t i : near_) {
      if (!touches(obstacles_[i].region, lane_.shape) || leaves_broad_passage(obstacles_[i])) {
        kept.push_back(i);
        continue;
      }
      warnings.push_back("polygon '" + obstacles_[i].id + "' cuts the centre line of lane '" +
                         lane_.id + "': cut open along it");
      cuts.push_back({i, corridor});
    }
    if (!kept.empty()) widen_passage(kept, cuts, warnings);
  }

 private:
  bool leaves_broad_passage(const ShapedPolygon& obstacle) const {
    return lane_.width > kWidestCorridor && !contains(obstacle.region, lane_.shape.front()) &&
           !contains(obstacle.region, lane_.shape.back()) &&
           passable(lane_, subtract(area_, obstacle.region), kBroadRoom);
  }

  /// Cuts what leaves no room for a body between them.
  void widen_passage(const std::vector<std::size_t>& kept, std::vector<Cut>& cuts,
                     std::vector<std::string>& warnings) const {
    std::vector<Region> regions;
    for (const std::size_t i : kept) regions.push_back(obstacles_[i].region);
    if (passable(lane_, subtract(area_, unite(regions)), kBodyRoom)) return;
    const Region corridor = widen(lane_.shape, kClearWidth);
    for (const std::size_t i : kept) {
      if (!meets(obstacles_[i], corridor)) continue;
      warnings.push_back("polygon '" + obstacles_[i].id + "' leaves no way through on lane '" +
                         lane_.id + "': cut open along its centre line");
      cuts.push_back({i, corridor});
    }
  }

  const Lane& lane_;
  const std::vector<ShapedPolygon>& obstacles_;
  Region area_;
  std::vector<std::size_t> near_;
};

}  // namespace

void cut_obstacles(const Network& network, const std::vector<int>& lanes,
                   std::vector<ShapedPolygon>& obstacles, std::vector<std::string>& warnings) {
  std::vector<Cut> cuts;
  for (const int lane : lanes) {
    LaneCutter(network.lanes[lane], obstacles).find_cuts(cuts, warnings);
  }
  for (const Cut& cut : cuts) {
    ShapedPolygon& obstacle = obstacles[cut.obstacle];
    obstacle.region = subtract(obstacle.region, cut.corridor);
  }
}

std::vector<std::string> clear_corridor(const Region& corridor,
                                        std::vector<ShapedPolygon>& obstacles) {
  std::vector<std::string> ids;
  for (ShapedPolygon& obstacle : obstacles) {
    if (!meets(obstacle, corridor)) continue;
    obstacle.region = subtract(obstacle.region, corridor);
    ids.push_back(obstacle.id);
  }
  return ids;
}

}  // namespace pedzone
