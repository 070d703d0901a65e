#include "model/walking_model.hpp"

#include <algorithm>
#include <stdexcept>

#include "model/heuristic_model.hpp"
#include "world/model_names.hpp"

namespace pedzone {

std::unique_ptr<WalkingModel> make_model(const std::string& name) {
  if (std::ranges::find(kModelNames, name) != std::end(kModelNames)) {
    return std::make_unique<HeuristicModel>(vehicle_form(name));
  }
  std::string known;
  for (const std::string_view model : kModelNames) {
    known += (known.empty() ? "" : ", ") + std::string(model);
  }
  throw std::invalid_argument("unknown walking model \"" + name + "\"; known: " + known);
}

}  // namespace pedzone
