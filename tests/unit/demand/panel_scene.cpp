#include "panel_scene.hpp"

#include "demand/route_file.hpp"
#include "scene.hpp"
#include "sumo/files/net_reader.hpp"

namespace pedzone::test {

PanelScene::PanelScene(Network net) : network(std::move(net)), zones(build_zones(network, {})) {}

namespace {

std::vector<PathSpec> known_paths() {
  PathSpec loop;
  loop.id = "loop";
  return {loop};
}

}  // namespace

PanelScene PanelScene::plaza() {
  return PanelScene(read_network(network_file("plaza/plaza.net.xml")));
}

PanelScene& PanelScene::add(const Attributes& attributes) {
  add_panel(panels, read_panel({"z.xml", 7, attributes}, profiles, known_paths(), panels.size()));
  return *this;
}

std::string PanelScene::complaint() const {
  try {
    people();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::vector<PlannedPerson> PanelScene::people(std::uint64_t seed, double begin) const {
  return plan_people({network, zones, profiles, panels, seed, begin});
}

std::string PanelScene::file(std::uint64_t seed) const {
  return route_file(people(seed), network, "test", 0.9);
}

std::string panel_complaint(const Attributes& attributes) {
  try {
    read_panel({"z.xml", 7, attributes}, Profiles(), known_paths(), 0);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace pedzone::test
