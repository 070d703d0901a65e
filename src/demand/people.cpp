#include "demand/people.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

#include "demand/draws.hpp"
#include "demand/foot_network.hpp"
#include "demand/places.hpp"
#include "demand/units.hpp"

namespace pedzone {
namespace {

/// A preferred speed: the profile's normal distribution truncated to what its body and the panel
/// allow (not clamped: nobody piles up at a limit), by the inverse of the distribution.
double draw_speed(const Profile& profile, const PanelSpec& spec, double uniform) {
  const double least = spec.speed_min, most = std::min(spec.speed_max, profile.top_speed);
  if (profile.speed_deviation <= 0.0) return std::clamp(profile.speed, least, most);
  using boost::math::cdf, boost::math::complement, boost::math::quantile;
  const boost::math::normal normal(profile.speed, profile.speed_deviation);
  double speed = 0.0;
  if (least > profile.speed) {  // upper tail: probabilities near 1 would lose their digits
    const double low = cdf(complement(normal, most)), high = cdf(complement(normal, least));
    const double tail = high - uniform * (high - low);
    speed = tail > 0.0 ? quantile(complement(normal, tail)) : least;
  } else {
    const double low = cdf(normal, least), high = cdf(normal, most);
    const double part = low + uniform * (high - low);
    speed = part > 0.0 ? quantile(normal, part) : most;
  }
  return std::clamp(speed, least, most);  // rounding
}

/// Who each person is. A guarded profile (a small child) is only drawn for members of groups after
/// the first, so much more often that its share of all people is what the panel says.
class Kinds {
 public:
  Kinds(const DemandInput& input, const PanelSpec& spec, const std::vector<Unit>& units)
      : profiles_(input.profiles.all()) {
    const std::vector<double> shares = profile_shares(spec, input.profiles);
    double guarded = 0.0, people = 0.0, companions = 0.0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const bool is_guarded = profiles_[i].guarded >= 0.5;
      guarded_.push_back(is_guarded ? shares[i] : 0.0);
      free_.push_back(is_guarded ? 0.0 : shares[i]);
      guarded += guarded_.back();
    }
    for (const Unit& unit : units) {
      people += unit.size;
      companions += unit.size - 1;
    }
    if (companions > 0.0) companion_guarded_ = std::min(1.0, guarded * people / companions);
  }

  const Profile& draw(bool first, Draws& draws) const {
    const bool guarded = draws.uniform() < companion_guarded_ && !first;
    return profiles_[draws.index(guarded ? guarded_ : free_)];
  }

 private:
  std::span<const Profile> profiles_;
  std::vector<double> guarded_, free_;  ///< weights
  double companion_guarded_ = 0.0;      ///< probability that a companion is guarded
};

Activity draw_activity(const PanelSpec& spec, double uniform) {
  for (const auto& [activity, share] : spec.activities) {
    if (uniform < share) return activity;
    uniform -= share;
  }
  return Activity::kNone;
}

void plan_panel(const DemandInput& input, const PanelSpec& spec, const std::vector<int>& parts,
                std::vector<PlannedPerson>& people) {
  const Places places(input, spec, parts);
  const std::vector<Unit> units = plan_units(spec, input.seed, input.begin);
  const Kinds kinds(input, spec, units);
  std::size_t person_number = 0, group_number = 0;
  for (const Unit& unit : units) {
    const std::string first = spec.id + "." + std::to_string(person_number);
    Draws trip_draws(input.seed, first + " trip");
    const Places::Trip trip = places.draw(trip_draws);
    const std::string group =
        unit.size > 1 ? spec.id + ".group" + std::to_string(group_number++) : "";
    for (int member = 0; member < unit.size; ++member) {
      PlannedPerson person;
      person.id = spec.id + "." + std::to_string(person_number++);
      Draws draws(input.seed, person.id);
      person.profile = &kinds.draw(member == 0, draws);
      person.speed = draw_speed(*person.profile, spec, draws.uniform());
      person.activity = draw_activity(spec, draws.uniform());
      person.depart = unit.depart;
      person.from = places.beside(trip.from, member, person.profile->width);
      person.to = places.beside(trip.to, 0, person.profile->width);
      person.group = group;
      person.panel = &spec;
      people.push_back(std::move(person));
    }
  }
}

}  // namespace

std::vector<PlannedPerson> plan_people(const DemandInput& input) {
  const std::vector<int> parts = foot_parts(input.network);
  std::vector<PlannedPerson> people;
  for (const PanelSpec& spec : input.panels) plan_panel(input, spec, parts, people);
  const auto sooner = [](const PlannedPerson& a, const PlannedPerson& b) {
    return a.depart < b.depart;
  };
  std::stable_sort(people.begin(), people.end(), sooner);
  return people;
}

}  // namespace pedzone
