#include "zone/walkable_area.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "geometry/polyline.hpp"
#include "zone/passage.hpp"
#include "zone/simplify.hpp"
#include "zone/way_cutter.hpp"

namespace pedzone {
namespace {

// numerical: shapes that touch in the file lie up to some centimetres apart after rounding, and
// walls in between would part them. Slits up to twice the first are closed; lanes reach into
// junctions by the second [m].
constexpr double kClosing = 0.1;
constexpr double kOverlap = 0.2;
// numerical: how far simplifying may move the border; far less than a body's radius, so that no
// body's centre gets where it was not before [m].
constexpr double kSimplification = 0.02;
// numerical: passages at a junction are judged by what lies so near to it [m].
constexpr double kJunctionMargin = 10.0;
constexpr double kInset = 0.5;  // [m] how far inside a lane passages are looked up

/// The end of an edge's walking lane at a junction.
struct LaneEnd {
  const Lane* lane;
  bool at_end;

  const Vec2& point() const { return at_end ? lane->shape.back() : lane->shape.front(); }
  Vec2 inside() const { return inner_point(lane->shape, at_end, kInset); }
};

LaneEnd end_at(const Network& network, int edge, const std::string& junction) {
  return {&network.lanes[walking_lane(network, edge)], network.edges[edge].to == junction};
}

/// The line with its ends moved outwards.
Polyline extended(const Polyline& line, double at_start, double at_end) {
  Polyline longer = line;
  const Vec2 first = line[1] - line[0], last = line.back() - line[line.size() - 2];
  if (first.norm() > 0.0) longer.front() -= first.normalized() * at_start;
  if (last.norm() > 0.0) longer.back() += last.normalized() * at_end;
  return longer;
}

class Builder {
 public:
  Builder(const Network& network, const ZoneSpec& spec, const ZoneParts& parts,
          const std::vector<bool>& in_a_zone, std::vector<std::string>& warnings)
      : network_(network), spec_(spec), parts_(parts), in_a_zone_(in_a_zone), warnings_(warnings) {}

  WalkableArea build() {
    reach_ = open_space_reach(network_, spec_, parts_.selection);
    Box near;
    for (const int lane : parts_.selection.lanes) near.extend(box_of(network_.lanes[lane]));
    near = grown(near, std::max(reach_.distance, kJunctionMargin));
    polygons_ = sort_polygons(network_, spec_, near, warnings_);
    cut_obstacles(network_, centre_lines(), polygons_.obstacles, warnings_);
    walkable_ = subtract(united_shapes(), regions_of(polygons_.obstacles));
    add_open_space(near);
    mend_links();
    drop_islands();
    walkable_ = simplified(walkable_, kSimplification);
    return {std::move(walkable_), regions_of(polygons_.obstacles)};
  }

 private:
  /// Lanes along whose centre line people walk: those of the zone, and crossings.
  std::vector<int> centre_lines() const {
    std::vector<int> lanes = parts_.selection.lanes;
    for (const int lane : parts_.inner_lanes) {
      const Edge& edge = network_.edges[network_.lanes[lane].edge];
      if (edge.function == EdgeFunction::kCrossing) lanes.push_back(lane);
    }
    return lanes;
  }

  /// All shapes of the zone; those at a junction are remembered for mend_links.
  Region united_shapes() {
    std::set<std::pair<int, std::string>> linked;
    for (const Link& link : parts_.links) {
      linked.insert({link.from, link.junction});
      linked.insert({link.to, link.junction});
    }
    std::vector<Region> shapes;
    for (const int index : parts_.selection.lanes) {
      Lane lane = network_.lanes[index];
      const Edge& edge = network_.edges[lane.edge];
      const bool from = linked.contains({lane.edge, edge.from});
      const bool to = linked.contains({lane.edge, edge.to});
      lane.shape = extended(lane.shape, from ? kOverlap : 0.0, to ? kOverlap : 0.0);
      shapes.push_back(area_of(lane));
      if (from) at_junction_[edge.from].push_back(shapes.back());
      if (to && edge.to != edge.from) at_junction_[edge.to].push_back(shapes.back());
    }
    const auto add = [&](const std::string& junction, Region shape) {
      at_junction_[junction].push_back(shape);
      shapes.push_back(std::move(shape));
    };
    for (const int index : parts_.inner_lanes) {
      Lane lane = network_.lanes[index];
      if (!lane.outline) lane.shape = extended(lane.shape, kOverlap, kOverlap);
      add(junction_of(network_.edges[lane.edge]), area_of(lane));
    }
    for (const int index : parts_.shared_junctions) {
      add(network_.junctions[index].id, repair(network_.junctions[index].shape));
    }
    for (const Link& link : parts_.links) {
      if (link.way.empty()) add(link.junction, straight(link));
    }
    for (const ShapedPolygon& polygon : polygons_.walkable) shapes.push_back(polygon.region);
    return closed(unite(shapes));
  }

  static Region closed(const Region& region) {
    return grow(grow(region, kClosing, Corners::kMitred), -kClosing, Corners::kMitred);
  }

  /// Networks without walking areas: from lane end to lane end.
  Region straight(const Link& link) const {
    const LaneEnd a = end_at(network_, link.from, link.junction);
    const LaneEnd b = end_at(network_, link.to, link.junction);
    const double width = std::max(kClearWidth, std::min(a.lane->width, b.lane->width));
    return widen({a.inside(), a.point(), b.point(), b.inside()}, width);
  }

  static Region regions_of(const std::vector<ShapedPolygon>& polygons) {
    std::vector<Region> regions;
    for (const ShapedPolygon& polygon : polygons) regions.push_back(polygon.region);
    return unite(regions);
  }

  void add_open_space(const Box& near) {
    if (reach_.distance <= 0.0 || reach_.lanes.empty()) return;
    const std::vector<Region> blocked{regions_of(polygons_.obstacles), regions_of(polygons_.water),
                                      bounding_roads(network_, parts_.selection, in_a_zone_, near)};
    walkable_ = with_open_space(network_, reach_, walkable_, unite(blocked));
  }

  /// Checks the links of each junction and mends those that nobody gets through.
  void mend_links() {
    std::map<std::string, std::vector<const Link*>> by_junction;
    for (const Link& link : parts_.links) by_junction[link.junction].push_back(&link);
    std::vector<Region> corridors;
    for (const auto& [junction, links] : by_junction) {
      const std::vector<const Link*> blocked = blocked_links(junction, links);
      if (blocked.empty()) continue;
      const Region wider = pinched_parts(blocked);
      at_junction_[junction].push_back(wider);
      for (const Link* link : blocked_links(junction, blocked)) corridors.push_back(mend(*link));
      corridors.push_back(wider);
    }
    if (corridors.empty()) return;
    corridors.push_back(walkable_);
    walkable_ = unite(corridors);
  }

  std::vector<const Link*> blocked_links(const std::string& junction,
                                         std::vector<const Link*> links) const {
    const auto keep_blocked = [&](const Passages& passages) {
      std::erase_if(links, [&](const Link* link) {
        return passages.joins(end_at(network_, link->from, junction).inside(),
                              end_at(network_, link->to, junction).inside());
      });
    };
    // The junction's own shapes are few and mostly enough, even before slits are closed; only then
    // the whole area is looked at, since there may be a way round over open space.
    const Region shapes = unite(at_junction_.at(junction));
    const Region obstacles = obstacles_near(grown(box_of(shapes), kClosing));
    keep_blocked(Passages(subtract(shapes, obstacles)));
    if (!links.empty()) keep_blocked(Passages(subtract(closed(shapes), obstacles)));
    if (!links.empty()) keep_blocked(Passages(clip(walkable_, box_round(junction, links))));
    return links;
  }

  Region obstacles_near(const Box& box) const {
    std::vector<Region> regions;
    for (const ShapedPolygon& obstacle : polygons_.obstacles) {
      if (box.intersects(obstacle.box)) regions.push_back(obstacle.region);
    }
    return unite(regions);
  }

  Box box_round(const std::string& junction, const std::vector<const Link*>& links) const {
    Box box;
    for (const Link* link : links) {
      for (const int edge : {link->from, link->to}) {
        const LaneEnd end = end_at(network_, edge, junction);
        box.extend(end.point()).extend(end.inside());
      }
      for (const int lane : link->way) box.extend(box_of(network_.lanes[lane]));
    }
    return grown(box, kJunctionMargin);
  }

  /// Where walking areas and crossings of the links are too narrow for a body, which netconvert
  /// makes them at some bends: as wide as it takes.
  Region pinched_parts(const std::vector<const Link*>& links) const {
    std::set<int> lanes;
    for (const Link* link : links) lanes.insert(link->way.begin(), link->way.end());
    constexpr double kHalf = 0.5 * kClearWidth;
    std::vector<Region> parts;
    for (const int index : lanes) {
      const Region area = area_of(network_.lanes[index]);
      const Region wide = grow(grow(area, -kHalf), kHalf, Corners::kMitred);
      parts.push_back(grow(subtract(area, wide), kHalf));
    }
    return subtract(unite(parts), regions_of(polygons_.obstacles));
  }

  /// [m] from a point to the nearest lane's shape of that walking area or crossing.
  double distance_to(int lane, const Vec2& point) const {
    const Polyline& shape = network_.lanes[lane].shape;
    return (point_on(shape, project_on(shape, point).offset).point - point).norm();
  }

  /// Whether the link passes way[k], a crossing, from its end to its begin: what comes before and
  /// after it touches those.
  bool is_passed_backwards(const Link& link, std::size_t k) const {
    const Polyline& shape = network_.lanes[link.way[k]].shape;
    double forwards = 0.0, backwards = 0.0;
    if (k > 0) {
      forwards += distance_to(link.way[k - 1], shape.front());
      backwards += distance_to(link.way[k - 1], shape.back());
    }
    if (k + 1 < link.way.size()) {
      forwards += distance_to(link.way[k + 1], shape.back());
      backwards += distance_to(link.way[k + 1], shape.front());
    }
    return backwards < forwards;
  }

  /// A corridor along the link: straight from lane end to lane end, by way of its crossings.
  Region mend(const Link& link) {
    const LaneEnd a = end_at(network_, link.from, link.junction);
    const LaneEnd b = end_at(network_, link.to, link.junction);
    Polyline line{a.inside(), a.point()};
    for (std::size_t k = 0; k < link.way.size(); ++k) {
      const Lane& lane = network_.lanes[link.way[k]];
      if (lane.outline) continue;
      if (is_passed_backwards(link, k)) {
        line.insert(line.end(), lane.shape.rbegin(), lane.shape.rend());
      } else {
        line.insert(line.end(), lane.shape.begin(), lane.shape.end());
      }
    }
    line.push_back(b.point());
    line.push_back(b.inside());
    const Region corridor = widen(line, kClearWidth);
    for (const std::string& id : clear_corridor(corridor, polygons_.obstacles)) {
      warnings_.push_back("polygon '" + id + "' closes the way between edges '" +
                          network_.edges[link.from].id + "' and '" + network_.edges[link.to].id +
                          "' at junction '" + link.junction + "': cut open");
    }
    return corridor;
  }

  void drop_islands() {
    Region kept;
    for (Polygon& polygon : walkable_) {
      const Box box = box_of(polygon.outer);
      const auto& lanes = parts_.selection.lanes;
      const bool holds = std::any_of(lanes.begin(), lanes.end(), [&](int lane) {
        const Vec2 place = inner_point(network_.lanes[lane].shape, false, kInset);
        return box.contains(place) && contains({polygon}, place);
      });
      if (holds) kept.push_back(std::move(polygon));
    }
    walkable_ = std::move(kept);
    for (const ShapedPolygon& polygon : polygons_.walkable) {
      if (intersect(walkable_, polygon.region).empty()) {
        warnings_.push_back("walkable polygon '" + polygon.id +
                            "' touches no lane of the zone: left out");
      }
    }
  }

  const Network& network_;
  const ZoneSpec& spec_;
  const ZoneParts& parts_;
  const std::vector<bool>& in_a_zone_;
  std::vector<std::string>& warnings_;
  OpenSpaceReach reach_;
  ZonePolygons polygons_;
  std::map<std::string, std::vector<Region>> at_junction_;  ///< shapes that meet there
  Region walkable_;
};

}  // namespace

WalkableArea build_walkable_area(const Network& network, const ZoneSpec& spec,
                                 const ZoneParts& parts, const std::vector<bool>& in_a_zone,
                                 std::vector<std::string>& warnings) {
  return Builder(network, spec, parts, in_a_zone, warnings).build();
}

}  // namespace pedzone
