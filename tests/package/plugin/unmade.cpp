// A plug-in whose model cannot be made.
#include <stdexcept>

#include "model/plugin.hpp"

class Unmade : public pedzone::WalkingModel {
 public:
  Unmade() { throw std::runtime_error("its file of numbers is missing"); }
  void prepare(const pedzone::Snapshot&) override {}
  void decide(std::size_t, std::size_t, std::span<pedzone::Decision>) const override {}
};

PEDZONE_WALKING_MODEL(Unmade)
