#include "crowd/zone_models.hpp"

#include "model/walking_model.hpp"

namespace pedzone {

const std::vector<ZoneSpec>& with_models(const std::vector<ZoneSpec>& specs) {
  for (const ZoneSpec& spec : specs) {
    try {
      check_model(spec.model);
    } catch (const ModelError& error) {
      throw zone_error(spec, error.problem, "model", spec.model, error.allowed);
    }
  }
  return specs;
}

}  // namespace pedzone
