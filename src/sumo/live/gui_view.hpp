// What a user sees of pedzone in sumo-gui: the zones, waypoints, what each person does as its
// colour, and of selected persons where they look. Nothing without a window.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "sumo/calls/view.hpp"
#include "sumo/live/takeover.hpp"

namespace pedzone {

/// Colour of what somebody does beside an activity, as the legend has them.
TraciColour colour_of(const PersonView& person);

class GuiView {
 public:
  /// All must outlive it. `sumo`: null where there can be no window.
  /// `screenshots`: the folder for a picture of each step; empty: none. Throws InputError where
  /// they are wanted without a window.
  GuiView(SumoView* sumo, SumoPersons& persons, const std::vector<std::unique_ptr<Crowd>>& crowds,
          const Takeover& takeover, std::string screenshots);

  /// Draws what stays where it is.
  void begin(const std::vector<Zone>& zones, const std::vector<WaypointPath>& paths);
  /// Draws everybody as they are to be seen after SUMO's next step.
  void update();

 private:
  void show_rays();
  bool is_selected(std::size_t guest);

  SumoView* sumo_;  ///< null: there is no window
  SumoPersons& persons_;
  const std::vector<std::unique_ptr<Crowd>>& crowds_;
  const Takeover& takeover_;
  std::string screenshots_;
  long pictures_ = 0;
  std::size_t asked_ = 0;  ///< of the guests, in turn, whether they are selected
  std::unordered_map<std::string, TraciColour> shown_;
  std::vector<std::string> selected_;
};

}  // namespace pedzone
