#include "sumo/live/person_hints.hpp"

#include "core/error.hpp"

namespace pedzone {

PersonHints read_hints(const SumoPersons& sumo, const std::string& person,
                       const HintContext& context) {
  PersonHints hints;
  for (const std::string_view name : kHintKeys) {
    const std::string key(name);
    try {
      take_hint(key, sumo.parameter(person, key), context, hints);
    } catch (const HintProblem& hint) {
      throw InputError(hint.problem, {"", 0,
                                      "parameter " + key + " of person '" + person +
                                          "' or its vType '" + sumo.type(person) + "'",
                                      hint.value, hint.allowed});
    }
  }
  return hints;
}

}  // namespace pedzone
