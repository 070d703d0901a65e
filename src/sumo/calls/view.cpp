#include <libsumo/libtraci.h>

#include <unordered_set>

#include "sumo/calls/both.hpp"

namespace pedzone::over_traci {
namespace {

namespace api = libtraci;

libsumo::TraCIColor colour_of(const TraciColour& colour) {
  return {colour.red, colour.green, colour.blue, colour.alpha};
}

class ViewCalls final : public SumoView {
 public:
  bool is_there() const override { return api::Simulation::hasGUI(); }

  void draw(const std::string& id, std::span<const Vec2> points, const std::string& type,
            const ShapeLook& look) override {
    libsumo::TraCIPositionVector shape;
    for (const Vec2& point : points) {
      libsumo::TraCIPosition at;
      at.x = point.x();
      at.y = point.y();
      shape.value.push_back(at);
    }
    if (drawn_.insert(id).second) {
      api::Polygon::add(id, shape, colour_of(look.colour), look.filled, type, look.layer,
                        look.line_width);
    } else {
      api::Polygon::setShape(id, shape);
    }
  }

  void mark(const std::string& id, const Vec2& point, const std::string& type,
            const TraciColour& colour) override {
    api::POI::add(id, point.x(), point.y(), colour_of(colour), type);
  }

  void erase(const std::string& id) override {
    if (drawn_.erase(id) > 0) api::Polygon::remove(id);
  }

  bool is_selected(const std::string& person) const override {
    return api::GUI::isSelected(person, "person");
  }

  void screenshot(const std::string& file) override { api::GUI::screenshot("View #0", file); }

 private:
  std::unordered_set<std::string> drawn_;
};

}  // namespace

std::unique_ptr<SumoView> view_calls() { return std::make_unique<ViewCalls>(); }

}  // namespace pedzone::over_traci
