#include "view/maps_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "pages/page_builder.hpp"
#include "pages/palette.hpp"
#include "view/run_map.hpp"
#include "view/scatter_chart.hpp"
#include "view/svg.hpp"
#include "zone/simplify.hpp"

namespace pedzone {

// Made from view/maps_page by the build.
extern const std::string_view kMapsPage, kMapsStyles, kMapsScripts;

namespace {

using Json = PageJson;

constexpr const char* kGround = "ground";                            // id of the ground's picture
constexpr std::size_t kManyPaths = 60;                               // more are drawn fainter
constexpr std::array kSpeedBounds{0.25, 0.5, 0.75, 1.0, 1.25, 1.5};  // [m/s]

struct SeverityLook {
  std::string_view colour, text;
  double radius;  ///< [units] a hundredth of the map
};
const SeverityLook& look_of(Severity severity) {
  static const std::array<SeverityLook, 3> kLooks{
      {{colours::kOrange.light, "slight", 0.9},
       {colours::kVermilion.light, "serious: TTC below 1.5 s or PET below 1 s", 1.15},
       {colours::kCrimson.light, "contact", 1.4}}};
  return kLooks[static_cast<std::size_t>(severity)];
}

Json legend(const std::vector<MapClass>& classes) {
  Json entries = Json::array();
  for (const MapClass& one : classes)
    entries.push_back({{"colour", one.colour}, {"text", one.text}});
  return entries;
}

Json map_of(const char* id, const char* title, const std::string& caption, const std::string& svg,
            const std::vector<MapClass>& classes) {
  return {{"id", id},
          {"title", title},
          {"caption", caption},
          {"svg_html", svg},
          {"legend", legend(classes)}};
}

/// Pictures are in the box's frame with y down.
std::string point(const Vec2& at, const Box& box) {
  return fmt::format("{:.2f} {:.2f}", at.x() - box.min().x(), box.max().y() - at.y());
}

std::string paths_svg(const MapsPage& page) {
  const double unit = page.box.sizes().maxCoeff() / 100.0, gap = line_gap(*page.recording);
  const double alpha = page.recording->persons.size() > kManyPaths ? 0.4 : 0.7;
  std::string svg =
      fmt::format(R"(<g fill="none" stroke="{}" stroke-width="{:.3f}" stroke-opacity="{}" )"
                  R"(stroke-linejoin="round">)",
                  colours::kBlue.light, 0.35 * unit, alpha);
  for (const RecordedPerson& person : page.recording->persons) {
    for (const TrackPiece& piece : pieces_of(person.moments, page.recording->times, gap)) {
      Polyline line;
      for (std::size_t i = piece.first; i <= piece.last; ++i) {
        line.push_back(person.moments[i].position);
      }
      if (line.size() < 2 || !page.box.intersects(box_of(line))) continue;
      svg += "<path d=\"";
      for (const Vec2& at : simplified(line, 0.05 * unit)) {
        svg += (svg.back() == '"' ? 'M' : 'L') + point(at, page.box);
      }
      svg += "\"/>";
    }
  }
  return svg + "</g>";
}

/// The gravest lie on top.
std::string conflicts_svg(const MapsPage& page) {
  const double unit = page.box.sizes().maxCoeff() / 100.0;
  std::string svg =
      fmt::format(R"(<g stroke="{}" stroke-width="{:.3f}">)", colours::kPaper, 0.12 * unit);
  for (const Severity severity : {Severity::kSlight, Severity::kSerious, Severity::kContact}) {
    const SeverityLook& look = look_of(severity);
    for (const MappedConflict& one : page.conflicts) {
      if (one.severity != severity || !page.box.contains(one.at)) continue;
      const Vec2 at(one.at.x() - page.box.min().x(), page.box.max().y() - one.at.y());
      fmt::format_to(
          std::back_inserter(svg),
          R"(<circle fill="{}" cx="{:.2f}" cy="{:.2f}" r="{:.3f}"><title>{}</title></circle>)",
          look.colour, at.x(), at.y(), look.radius * unit, escaped(one.title));
    }
  }
  return svg + "</g>";
}

/// The measured area's outline.
std::string area_svg(const MapsPage& page) {
  if (page.area.isEmpty()) return "";
  const Vec2 size = page.area.sizes(), corner(page.area.min().x(), page.area.max().y());
  return fmt::format(
      R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" fill="none" stroke="{}" )"
      R"(stroke-width="{:.3f}"/>)",
      corner.x() - page.box.min().x(), page.box.max().y() - corner.y(), size.x(), size.y(),
      colours::kBlack.light, page.box.sizes().maxCoeff() / 250.0);
}

std::vector<MapClass> service_classes() {
  std::vector<MapClass> classes;
  for (std::size_t i = 0; i < kServiceLevels.size(); ++i) {
    classes.push_back({service_colour(i), service_text(i)});
  }
  return classes;
}

std::vector<double> service_bounds() {
  std::vector<double> bounds;
  for (std::size_t i = 1; i < kServiceLevels.size(); ++i) bounds.push_back(kServiceLevels[i].least);
  return bounds;
}

Json grid_maps(const MapsPage& page) {
  const RunGrids& grids = *page.grids;
  const std::vector<double> mean_bounds = class_bounds(std::span(&grids.mean, 1));
  const std::vector<double> speed_bounds(kSpeedBounds.begin(), kSpeedBounds.end());
  const std::string cells = fmt::format("Cells of {:g} m.", grids.mean.size);
  const auto map = [&](const ValueGrid& grid, const std::vector<double>& bounds,
                       const char* label) {
    return map_svg(grid, page.box, bounds, kGround, label, area_svg(page));
  };
  return Json::array(
      {map_of("mean", "Density of people",
              fmt::format("Persons per m²: mean from {:g} to {:g} s. ", grids.begin, grids.end) +
                  cells,
              map(grids.mean, mean_bounds, "Density of people"), map_classes(mean_bounds)),
       map_of("service", "Level of service in the peak minute",
              fmt::format("Fruin's levels for walkways, persons per m²: mean from {:g} to {:g} s, "
                          "when most people are there; each cell at the worst level of its 2 m.",
                          grids.minute_begin, grids.minute_end),
              map(grids.minute, service_bounds(), "Level of service"), service_classes()),
       map_of("speed", "Speed of people",
              "m/s: mean of those who are there, by the time they spend, standing included.",
              map(grids.speed, speed_bounds, "Speed of people"), map_classes(speed_bounds))});
}

Json maps(const MapsPage& page) {
  Json all = grid_maps(page);
  const ValueGrid nothing(1.0, false);
  const auto drawn = [&](const std::string& more, const char* label) {
    return map_svg(nothing, page.box, {}, kGround, label, more);
  };
  all.push_back(map_of("paths", "Paths",
                       fmt::format("The ways of {} persons.", page.recording->persons.size()),
                       drawn(paths_svg(page), "Paths"), {}));
  if (!page.conflicts_known) return all;
  std::vector<MapClass> classes;
  for (const Severity severity : {Severity::kSlight, Severity::kSerious, Severity::kContact}) {
    const auto count = std::ranges::count(page.conflicts, severity, &MappedConflict::severity);
    classes.push_back({std::string(look_of(severity).colour),
                       fmt::format("{} ({})", look_of(severity).text, count)});
  }
  all.push_back(map_of("conflicts", "Conflicts",
                       "With moving vehicles, by severity: where bodies touched, or would have.",
                       drawn(conflicts_svg(page), "Conflicts"), classes));
  return all;
}

Json diagrams(const MapsPage& page) {
  std::vector<Vec2> speeds, flows;
  for (const DiagramPoint& one : page.diagram) {
    speeds.emplace_back(one.density, one.speed);
    flows.emplace_back(one.density, one.density * one.speed);
  }
  const char* density = "density [persons/m²]";
  return Json::array({{{"title", "Speed over density"},
                       {"svg_html", scatter_chart(speeds, density, "speed [m/s]")}},
                      {{"title", "Flow over density"},
                       {"svg_html", scatter_chart(flows, density, "specific flow [1/(m·s)]")}}});
}

}  // namespace

std::string maps_page(const MapsPage& page) {
  Json numbers = Json::array();
  for (const auto& [name, value] : page.numbers) {
    numbers.push_back({{"name", name}, {"value", value}});
  }
  Json shown{{"title", page.title},
             {"question", page.question},
             {"numbers", numbers},
             {"note", page.note},
             {"ground_html", ground_svg(page.place, page.box, kGround)},
             {"maps", maps(page)}};
  if (!page.area.isEmpty()) {
    shown["measured"] = {
        {"text", fmt::format("The rectangle from ({:g}, {:g}) to ({:g}, {:g}) m, once a second: {} "
                             "points. Densities and speeds by Voronoi cells (Steffen and Seyfried "
                             "2010), at most 2 m from their person; flow is density times speed.",
                             page.area.min().x(), page.area.min().y(), page.area.max().x(),
                             page.area.max().y(), page.diagram.size())},
        {"diagrams", diagrams(page)}};
  }
  return rendered_page({kMapsPage, kMapsStyles, kMapsScripts}, shown, {{"models", Json::array()}});
}

}  // namespace pedzone
