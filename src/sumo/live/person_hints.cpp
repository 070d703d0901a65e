#include "sumo/live/person_hints.hpp"

#include "core/error.hpp"
#include "sumo/live/api.hpp"

namespace pedzone {

PersonHints read_hints(const std::string& person, const HintContext& context) {
  const std::string type = api::Person::getTypeID(person);
  PersonHints hints;
  for (const std::string_view name : kHintKeys) {
    const std::string key(name), own = api::Person::getParameter(person, key);
    try {
      take_hint(key, own.empty() ? api::VehicleType::getParameter(type, key) : own, context, hints);
    } catch (const HintProblem& hint) {
      throw InputError(
          hint.problem,
          {"", 0, "parameter " + key + " of person '" + person + "' or its vType '" + type + "'",
           hint.value, hint.allowed});
    }
  }
  return hints;
}

}  // namespace pedzone
