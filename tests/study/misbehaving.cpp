// A walking model that does what no program should, in the middle of a run.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "model/perceiving_model.hpp"
#include "model/plugin.hpp"

class Misbehaving : public pedzone::PerceivingModel {
 protected:
  pedzone::Decision decide_from(const pedzone::Perceived& who) const override {
#if defined(ABORTS)
    std::abort();
#elif defined(HANGS)
    for (;;) pause();
#elif defined(STUMBLES)  // the first time only
    if (!std::filesystem::exists("stumbled")) {
      std::ofstream("stumbled").put('\n');
      std::abort();
    }
#endif
    return walk_with(who.speed * who.goal_direction, who);
  }
};

PEDZONE_WALKING_MODEL(Misbehaving)
