#include "view/zone_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

#include "view/svg.hpp"

namespace pedzone {
namespace {

constexpr double kMargin = 25.0;  // [m] shown round the zones
constexpr double kColumn = 48.0;  // width of a column of the legend in units of the picture

/// How a zone is filled; zones take them in turn.
constexpr std::array<const char*, 6> kZoneColours{"#bfe3b4", "#f7dd9b", "#c9d7f5",
                                                  "#f3c6cf", "#d5c8ec", "#b9e4e0"};
constexpr const char* kObstacleStyle = "fill=\"#a89f94\" stroke=\"#857c71\" stroke-width=\"0.2\"";
constexpr const char* kWalkableBorder = "#3f7a2e";
constexpr const char* kRoadColour = "#d2d5d9";
constexpr const char* kFootwayColour = "#e9ddc7";
constexpr const char* kCrossingColour = "#eef0f2";
constexpr const char* kSharedLaneColour = "#b3541e";
constexpr const char* kFootLaneColour = "#2f6b1f";

/// One line of the legend.
struct LegendEntry {
  std::string name, style;
  bool line;
};

class Picture {
 public:
  Picture(const Network& network, const std::vector<Zone>& zones,
          const std::vector<PathLayer>& layers)
      : network_(network),
        zones_(zones),
        layers_(layers),
        unit_(unit_of(extent(network, zones).sizes())),
        columns_(extent(network, zones).sizes().x() >= 2.0 * kColumn * unit_ ? 2 : 1),
        page_(extent(network, zones), panel_height()) {}

  std::string draw() {
    draw_roads();
    for (std::size_t i = 0; i < zones_.size(); ++i) draw_walkable(i);
    for (const Zone& zone : zones_) page_.region(zone.obstacles, kObstacleStyle);
    for (const Zone& zone : zones_) draw_lanes(zone);
    draw_layers();
    draw_panel();
    std::string title = "Zones of " + network_.file;
    return page_.finish(title);
  }

 private:
  static Box extent(const Network& network, const std::vector<Zone>& zones) {
    Box box;
    for (const Zone& zone : zones) box.extend(box_of(zone.walkable));
    if (box.isEmpty()) {
      for (const Lane& lane : network.lanes) box.extend(box_of(lane.shape));
    }
    return grown(box, kMargin);
  }

  /// A hundredth of the picture; less where a column of the legend would not fit.
  static double unit_of(const Vec2& sizes) {
    return std::min(sizes.maxCoeff() / 100.0, sizes.x() / kColumn);
  }

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < zones_.size(); ++i) {
      entries.push_back(
          {fmt::format("walkable, zone \"{}\" ({:.0f} m²)", zones_[i].id, area(zones_[i].walkable)),
           walkable_style(i), false});
    }
    entries.push_back({"obstacle (building ...)", kObstacleStyle, false});
    entries.push_back(
        {"lane in a zone, persons and vehicles", stroke(kSharedLaneColour, 0.5), true});
    entries.push_back({"lane in a zone, persons only", stroke(kFootLaneColour, 0.5), true});
    entries.push_back({"road that stays SUMO's", stroke(kRoadColour, 3.0), true});
    entries.push_back({"footway that stays SUMO's", stroke(kFootwayColour, 2.0), true});
    for (const PathLayer& layer : layers_) {
      entries.push_back({fmt::format("{} ({})", layer.name, layer.lines.size()),
                         stroke(layer.colour, std::max(layer.width, 0.5)), true});
    }
    return entries;
  }

  static std::string stroke(std::string_view colour, double width) {
    return fmt::format("stroke=\"{}\" stroke-width=\"{:.2f}\"", escaped(colour), width);
  }

  static std::string walkable_style(std::size_t zone) {
    return fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"0.25\"",
                       kZoneColours[zone % kZoneColours.size()], kWalkableBorder);
  }

  std::size_t rows() const {
    const std::size_t columns = static_cast<std::size_t>(columns_);
    return (legend().size() + columns - 1) / columns;
  }

  double panel_height() const { return unit_ * (5.0 + 2.2 * static_cast<double>(rows())); }

  void draw_roads() {
    std::unordered_set<int> inside;
    for (const Zone& zone : zones_) inside.insert(zone.lanes.begin(), zone.lanes.end());
    const auto draw = [&](bool footways) {
      for (int index = 0; index < static_cast<int>(network_.lanes.size()); ++index) {
        const Lane& lane = network_.lanes[index];
        const bool footway = lane.persons && !lane.vehicles;
        if (inside.contains(index) || footway != footways) continue;
        if (page_.box().intersects(box_of(lane))) draw_road(lane);
      }
    };
    page_.begin_group("stroke-linejoin=\"round\"");
    for (const Junction& junction : network_.junctions) {
      const Region shape = repair(junction.shape);
      if (!page_.box().intersects(box_of(shape))) continue;
      page_.region(shape, fmt::format("fill=\"{}\"", kRoadColour), "junction " + junction.id);
    }
    draw(false);
    draw(true);
    page_.end_group();
  }

  void draw_road(const Lane& lane) {
    const Edge& edge = network_.edges[lane.edge];
    const bool inner = edge.function != EdgeFunction::kNormal;
    if (lane.outline) {
      page_.region(repair(lane.shape), fmt::format("fill=\"{}\"", kFootwayColour), lane.id);
      return;
    }
    if (inner && edge.function != EdgeFunction::kCrossing) return;  // the junction shows them
    const bool footway = lane.persons && !lane.vehicles;
    const char* colour = inner ? kCrossingColour : footway ? kFootwayColour : kRoadColour;
    page_.line(lane.shape, stroke(colour, lane.width), lane.id + " " + edge.type);
  }

  void draw_walkable(std::size_t zone) {
    page_.region(zones_[zone].walkable, walkable_style(zone), "zone " + zones_[zone].id);
  }

  void draw_lanes(const Zone& zone) {
    const double lane_width = std::max(0.3, 0.08 * unit_);  // to be seen in large pictures too
    page_.begin_group("stroke-opacity=\"0.7\"");
    for (const int index : zone.lanes) {
      const Lane& lane = network_.lanes[index];
      const Edge& edge = network_.edges[lane.edge];
      if (lane.outline || edge.function == EdgeFunction::kInternal) continue;
      page_.line(lane.shape,
                 stroke(lane.vehicles ? kSharedLaneColour : kFootLaneColour, lane_width),
                 lane.id + " " + edge.type);
    }
    page_.end_group();
  }

  void draw_layers() {
    for (const PathLayer& layer : layers_) {
      page_.begin_group(fmt::format(
          "{} stroke-opacity=\"{:.3f}\" stroke-linejoin=\"round\" stroke-linecap=\"round\"",
          stroke(layer.colour, layer.width), layer.opacity));
      for (const Polyline& line : layer.lines) page_.line(line, "");
      page_.end_group();
    }
  }

  void draw_panel() {
    const double width = page_.box().sizes().x();
    const Vec2 corner = page_.panel_point(0.0, 0.0),
               opposite = page_.panel_point(width, panel_height());
    // Covers what reaches out of the picture.
    page_.region({{{corner, {corner.x(), opposite.y()}, opposite, {opposite.x(), corner.y()}}, {}}},
                 "fill=\"#ffffff\"");
    page_.line({corner, {opposite.x(), corner.y()}}, stroke("#666666", 0.1 * unit_));
    const auto entries = legend();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      const double right = unit_ * 2.0 + (i < rows() ? 0.0 : 0.5 * width);
      draw_entry(entries[i], right, unit_ * (2.2 + 2.2 * static_cast<double>(i % rows())));
    }
    draw_scale_bar();
  }

  void draw_entry(const LegendEntry& entry, double right, double down) {
    const Vec2 low = page_.panel_point(right, down + 0.5 * unit_);
    const Vec2 high = page_.panel_point(right + 4.0 * unit_, down - 0.7 * unit_);
    if (entry.line) {
      const double y = 0.5 * (low.y() + high.y());
      // Line widths of the map are metres; here they are made to be seen.
      page_.line({{low.x(), y}, {high.x(), y}},
                 entry.style + fmt::format(" style=\"stroke-width:{:.2f}\"", 0.4 * unit_));
    } else {
      page_.region({{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}}, entry.style);
    }
    page_.text(page_.panel_point(right + 5.0 * unit_, down + 0.4 * unit_), 1.4 * unit_, entry.name);
  }

  /// 1, 2 or 5 times a power of ten metres, about an eighth of the picture.
  void draw_scale_bar() {
    const double width = page_.box().sizes().x();
    const double power = std::pow(10.0, std::floor(std::log10(width / 8.0)));
    double length = power;
    for (const double step : {2.0, 5.0}) {
      if (step * power <= width / 8.0) length = step * power;
    }
    const double down = panel_height() - 1.2 * unit_;
    const Vec2 from = page_.panel_point(2.0 * unit_, down);
    const Vec2 to = from + Vec2(length, 0.0);
    const Vec2 tick(0.0, 0.5 * unit_);
    page_.line({from + tick, from, to, to + tick}, stroke("#222222", 0.15 * unit_));
    page_.text(to + Vec2(unit_, 0.0), 1.4 * unit_, fmt::format("{:g} m", length));
    page_.text(page_.panel_point(0.5 * width, down), 1.4 * unit_, "north is up");
  }

  const Network& network_;
  const std::vector<Zone>& zones_;
  const std::vector<PathLayer>& layers_;
  double unit_;  ///< [m] sizes of text and legend are multiples of it
  int columns_;  ///< of the legend
  SvgPage page_;
};

}  // namespace

std::string zone_svg(const Network& network, const std::vector<Zone>& zones,
                     const std::vector<PathLayer>& layers) {
  return Picture(network, zones, layers).draw();
}

}  // namespace pedzone
