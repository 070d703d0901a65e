// What is drawn in sumo-gui: calls, and no decision.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sumo/calls/persons.hpp"

namespace pedzone {

/// How a polygon or a line is drawn.
struct ShapeLook {
  TraciColour colour;
  bool filled = false;
  double line_width = 0.1;  ///< [m]
  int layer = 0;            ///< SUMO's: the higher ones lie above
};

class SumoView {
 public:
  virtual ~SumoView() = default;

  /// Whether there is a window.
  virtual bool is_there() const = 0;
  /// Draws a polygon, in place of one of that id. `type` as sumo-gui shows it.
  virtual void draw(const std::string& id, std::span<const Vec2> points, const std::string& type,
                    const ShapeLook& look) = 0;
  virtual void mark(const std::string& id, const Vec2& point, const std::string& type,
                    const TraciColour& colour) = 0;
  /// Nothing where there is no such polygon.
  virtual void erase(const std::string& id) = 0;
  virtual bool is_selected(const std::string& person) const = 0;
  /// With the end of the next step.
  virtual void screenshot(const std::string& file) = 0;
};

}  // namespace pedzone
