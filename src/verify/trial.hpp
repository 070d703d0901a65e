// A standard test while it is walked: a zone, its people, a clock.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "crowd/crowd.hpp"
#include "verify/ground.hpp"

namespace pedzone::verify {

constexpr double kBodyRadius = 0.239;  ///< [m] SUMO's person is 0.478 m wide
constexpr double kMeanSpeed = 1.34;    ///< [m/s] measured: Weidmann 1993
constexpr double kSpeedSpread = 0.26;  ///< [m/s] measured: Weidmann 1993, standard deviation
constexpr double kStep = 0.1;          ///< [s] the crowd's substep
/// [m] So far the ground goes on behind where people leave: more than they see (10 m), since they
/// take the ground's border for a wall.
constexpr double kOpenEnd = 12.0;

/// Where the next person stands, is headed, and to which stream it belongs.
struct Participant {
  NewPerson given;
  int stream = 0;  ///< of those that the test tells apart, such as the two ways of a corridor
  Crowd::Handle handle = 0;
  Vec2 before = Vec2::Zero(), at = Vec2::Zero();  ///< [m] at the last two steps
  Vec2 moved = Vec2::Zero();  ///< [m] since the start, over ends of a period too
  bool here = true;
  double arrival = 0.0;  ///< [s] once it is not here any more
};

/// Carries whoever leaves the corridor at one end (x, [m]) to the other: people there see and touch
/// those beyond the end as if it were closed to a ring. The ground must go on for kBeyond at both.
struct Period {
  double low = 0.0, high = 0.0;            ///< [m]
  static constexpr double kBeyond = 12.0;  ///< [m] more than people see (10 m)
  double length() const { return high - low; }
};

/// What one run is made with.
struct RunInput {
  std::string model;
  std::uint64_t seed = 1;
};

class Trial {
 public:
  Trial(const Region& walkable, const RunInput& input,
        const std::function<void(Zone&)>& change = {});
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  void set_period(const Period& period) { period_ = period; }

  /// Adds somebody with the default body, at rest or (`start` 1) at its preferred speed towards its
  /// destination. `speed` [m/s]; unset: drawn from Weidmann's distribution within 0.5 to 2.2 m/s.
  std::size_t add(const Vec2& at, const Destination& to, int stream = 0,
                  std::optional<double> speed = {}, double start = 0.0);
  std::size_t add(NewPerson person, int stream);

  void step();
  /// Steps until nobody is left or the clock shows `until` [s]; after each step calls `look`.
  void walk(double until, const std::function<void()>& look = {});

  const std::optional<Period>& period() const { return period_; }
  double time() const { return time_; }
  /// Whether a whole multiple of `every` [s] has just been reached.
  bool at_every(double every) const;
  const std::vector<Participant>& people() const { return people_; }
  const Zone& zone() const { return zone_; }
  std::uint64_t seed() const { return seed_; }
  /// Those who are not here any more, of all streams.
  std::size_t arrived() const { return arrived_; }
  /// Time [s] at which the last of the stream (any: -1) came; `until` where somebody is left.
  double last_arrival(double until, int stream = -1) const;
  /// Persons-times-steps whose centre was outside the walls; none, or the crowd is at fault.
  std::size_t outside() const { return outside_; }

 private:
  void see_beyond_ends();
  void carry_over(Participant& participant);
  NewPerson again(const Participant& participant, const PersonView& view) const;

  Zone zone_;
  Crowd crowd_;
  std::uint64_t seed_;
  std::vector<Participant> people_;
  std::vector<SeenPerson> beyond_;
  std::optional<Period> period_;
  double time_ = 0.0;
  std::uint64_t steps_ = 0;
  std::size_t arrived_ = 0, outside_ = 0;
};

/// Preferred speed [m/s] of that person: normal (Weidmann 1993), drawn anew outside 0.5 to 2.2 m/s
/// (assumed).
double drawn_speed(std::uint64_t seed, std::uint64_t person);

/// `count` places in a rectangle [m] that keep a body's radius from its sides, as far apart as
/// a lattice puts them, each moved at random as far as nobody touches. Throws
/// std::invalid_argument where bodies do not fit.
std::vector<Vec2> places_in(const Vec2& low, const Vec2& high, std::size_t count,
                            std::uint64_t seed);

/// The destination across x = `x` from y0 to y1, and across y = `y`.
Destination line_at_x(double x, double y0, double y1);
Destination line_at_y(double y, double x0, double x1);

}  // namespace pedzone::verify
