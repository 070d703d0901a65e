#include "view/zone_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "zone/selection.hpp"

namespace pedzone {
namespace {

std::string shown_type(const TypeLength& entry) {
  return entry.type.empty() ? "(no type)" : entry.type;
}

int width_of_types(const std::vector<TypeLength>& entries) {
  std::size_t width = 0;
  for (const TypeLength& entry : entries) width = std::max(width, shown_type(entry).size());
  return static_cast<int>(width);
}

void add_types(const std::vector<TypeLength>& entries, std::string& text) {
  const int width = width_of_types(entries);
  for (const TypeLength& entry : entries) {
    fmt::format_to(std::back_inserter(text), "    {:<{}}  {:>9.1f} m  {:>5} edge{}{}\n",
                   shown_type(entry), width, entry.length, entry.edges,
                   entry.edges == 1 ? " " : "s",
                   entry.bring_in.empty() ? "" : "  " + entry.bring_in);
  }
}

void add_zone(const Network& network, const Zone& zone, std::string& text) {
  const ZoneFigures figures = figures_of(network, zone);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "Zone \"{}\" (model {})\n", zone.id, zone.model);
  fmt::format_to(out, "  edges        {} of {:.1f} m together\n", zone.edges.size(),
                 figures.length);
  fmt::format_to(out, "  lanes        {}, those inside junctions included; {} crossings\n",
                 zone.lanes.size(), figures.crossings);
  fmt::format_to(out, "  walkable     {:.0f} m² in {} part{}\n", figures.surface,
                 zone.walkable.size(), zone.walkable.size() == 1 ? "" : "s");
  fmt::format_to(out, "  walls        {}\n", zone.walls.walls().size());
  text += "  edges inside by type\n";
  add_types(zone.inside, text);
}

void add_left_out(const std::vector<TypeLength>& left_out, std::string& text) {
  if (left_out.empty()) {
    text += "Left to SUMO: no edge that persons may use\n";
    return;
  }
  text +=
      "Left to SUMO: edges that persons may use, with the attribute of a <zone> that brings them "
      "in\n";
  add_types(left_out, text);
  text +=
      "    A <zone> that names edges, edge types or lanes has only those; a second <zone> without "
      "takes the rest by the rule.\n";
}

void add_warnings(const std::string& heading, const std::vector<std::string>& warnings,
                  std::string& text) {
  if (warnings.empty()) return;
  text +=
      fmt::format("{}: {} warning{}\n", heading, warnings.size(), warnings.size() == 1 ? "" : "s");
  for (const std::string& warning : warnings) text += "    " + warning + "\n";
}

}  // namespace

ZoneFigures figures_of(const Network& network, const Zone& zone) {
  ZoneFigures figures;
  for (const TypeLength& entry : zone.inside) figures.length += entry.length;
  figures.surface = area(zone.walkable);
  figures.crossings = std::ranges::count_if(zone.lanes, [&](int lane) {
    return network.edges[network.lanes[lane].edge].function == EdgeFunction::kCrossing;
  });
  return figures;
}

std::vector<TypeLength> left_to_sumo(const Network& network, const std::vector<Zone>& zones) {
  if (!zones.empty()) return zones.front().left_out;
  return lengths_left_out(network, std::vector<bool>(network.edges.size(), false));
}

std::string zone_report(const Network& network, const std::vector<Zone>& zones) {
  std::string text;
  for (const Zone& zone : zones) add_zone(network, zone, text);
  if (zones.empty()) text += "No shared space\n";
  add_left_out(left_to_sumo(network, zones), text);
  add_warnings("Input files", network.warnings, text);
  for (const Zone& zone : zones) add_warnings("Zone \"" + zone.id + "\"", zone.warnings, text);
  return text;
}

}  // namespace pedzone
