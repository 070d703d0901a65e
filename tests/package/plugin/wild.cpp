// A plug-in that makes people faster than anybody may be.
#include <limits>

#include "model/plugin.hpp"

class Wild : public pedzone::WalkingModel {
 public:
  void prepare(const pedzone::Snapshot&) override {}
  void decide(std::size_t first, std::size_t last,
              std::span<pedzone::Decision> decisions) const override {
    for (std::size_t i = first; i < last; ++i) {
      decisions[i].speed = std::numeric_limits<double>::quiet_NaN();
    }
  }
};

PEDZONE_WALKING_MODEL(Wild)
