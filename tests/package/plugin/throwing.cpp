// A plug-in that fails while people walk.
#include <stdexcept>

#include "model/perceiving_model.hpp"
#include "model/plugin.hpp"

class Throwing : public pedzone::PerceivingModel {
 protected:
  pedzone::Decision decide_from(const pedzone::Perceived&) const override {
    throw std::out_of_range("no way out");
  }
};

PEDZONE_WALKING_MODEL(Throwing)
