#include "sumo/person_hints.hpp"

#include "core/error.hpp"
#include "core/random.hpp"
#include "core/xml.hpp"
#include "sumo/api.hpp"
#include "sumo/path_references.hpp"

namespace pedzone {
namespace {

class Hints {
 public:
  explicit Hints(const std::string& person)
      : person_(person), type_(api::Person::getTypeID(person)) {}

  /// Empty where neither the person nor its type says anything.
  std::string of(const std::string& key) const {
    const std::string own = api::Person::getParameter(person_, key);
    return own.empty() ? api::VehicleType::getParameter(type_, key) : own;
  }

  InputError error(const std::string& problem, const std::string& key, const std::string& value,
                   const std::string& allowed) const {
    return InputError(
        problem,
        {"", 0, "parameter " + key + " of person '" + person_ + "' or its vType '" + type_ + "'",
         value, allowed});
  }

 private:
  std::string person_, type_;
};

std::string pastime_ids() {
  std::string ids;
  for (const PastimeInfo& info : pastime_list()) {
    if (info.pastime != Pastime::kNone) ids += (ids.empty() ? "" : ", ") + std::string(info.id);
  }
  return ids;
}

/// "texting phoning=0.5": each with the rate [1/min] at which it begins, or its usual one.
std::array<double, kPastimes> read_rates(const Hints& hints, const std::string& key) {
  std::array<double, kPastimes> rates{};
  for (const std::string& word : split_words(hints.of(key))) {
    const std::size_t equals = word.find('=');
    const PastimeInfo* info = find_pastime(word.substr(0, equals));
    if (info == nullptr || info->pastime == Pastime::kNone) {
      throw hints.error("is no activity", key, word, pastime_ids());
    }
    double rate = info->rate;
    if (equals != std::string::npos &&
        (!parse_number(word.substr(equals + 1), rate) || rate < 0.0 || rate > 60.0)) {
      throw hints.error("has no rate", key, word, "ACTIVITY or ACTIVITY=0 to 60 (per minute)");
    }
    rates[static_cast<std::size_t>(info->pastime)] = rate;
  }
  return rates;
}

}  // namespace

PersonHints read_hints(const std::string& person, const Profiles& profiles,
                       const std::vector<WaypointPath>& paths) {
  const Hints hints(person);
  PersonHints read;
  if (const std::string id = hints.of("pedzone.profile"); !id.empty()) {
    read.profile = profiles.find(id);
    if (read.profile == nullptr) {
      throw hints.error("is no profile", "pedzone.profile", id, profiles.ids());
    }
  }
  if (const std::string aware = hints.of("pedzone.aware"); !aware.empty()) {
    if (aware != "true" && aware != "false") {
      throw hints.error("is neither true nor false", "pedzone.aware", aware, "true, false");
    }
    read.aware = aware == "true";
  }
  if (const std::string id = hints.of("pedzone.group"); !id.empty()) read.group = person_key(id);
  read.rates = read_rates(hints, "pedzone.activities");
  if (const std::string id = hints.of(kPathKey); !id.empty()) {
    read.path = find_path(paths, id);
    if (read.path == nullptr) {
      throw hints.error("is no path of the zone file", kPathKey, id, path_ids(paths));
    }
  }
  return read;
}

}  // namespace pedzone
