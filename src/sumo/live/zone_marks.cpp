#include "sumo/live/zone_marks.hpp"

namespace pedzone {
namespace {

const std::string kMark = "pedzone.attached";

/// The zones' ordinary edges, each with its zone.
template <typename Visit>
void for_edges(const Network& network, const std::vector<Zone>& zones, const Visit& visit) {
  for (const Zone& zone : zones) {
    for (const int edge : zone.edges) {
      if (network.edges[edge].function == EdgeFunction::kNormal)
        visit(zone, network.edges[edge].id);
    }
  }
}

}  // namespace

void mark_zones(Session& sumo, const Network& network, const std::vector<Zone>& zones) {
  for_edges(network, zones, [&](const Zone& zone, const std::string& edge) {
    if (sumo.edge_parameter(edge, kMark).empty()) return;
    throw InputError("another pedzone walks the people of zone '" + zone.id + "'",
                     {"", 0, "edge '" + edge + "'", "", "one pedzone for the edges of a zone"});
  });
  for_edges(network, zones, [&](const Zone&, const std::string& edge) {
    sumo.set_edge_parameter(edge, kMark, "true");
  });
}

void unmark_zones(Session& sumo, const Network& network, const std::vector<Zone>& zones) {
  for_edges(network, zones, [&](const Zone&, const std::string& edge) {
    sumo.set_edge_parameter(edge, kMark, "");
  });
}

}  // namespace pedzone
