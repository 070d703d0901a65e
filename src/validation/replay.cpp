#include "validation/replay.hpp"

#include <algorithm>
#include <optional>

#include "core/random.hpp"
#include "crowd/crowd.hpp"
#include "validation/companions.hpp"

namespace pedzone {
namespace {

constexpr double kJitter = 0.03;  // share of the preferred speed (protocol 6)
constexpr double kRadius = 0.24;  // [m] of a body
constexpr double kAround = 60.0;  // [m] of open space round the recorded places

/// Open space round everything that was recorded.
Zone open_space(const Clip& clip, const ReplayModel& model) {
  Vec2 low = clip.persons.front().places.front(), high = low;
  for (const PersonTrack& person : clip.persons) {
    for (const Vec2& place : person.places) {
      low = low.cwiseMin(place);
      high = high.cwiseMax(place);
    }
  }
  low -= Vec2::Constant(kAround);
  high += Vec2::Constant(kAround);
  Zone zone;
  zone.id = clip.name;
  zone.model = model.model;
  zone.parameters = model.parameters;
  zone.walkable = repair(Ring{low, {high.x(), low.y()}, high, {low.x(), high.y()}});
  zone.walls = WallIndex(zone.walkable);
  zone.ways = WayFinder(zone.walkable, kWayClearance);
  return zone;
}

std::uint64_t key_of(const Clip& clip, const PersonTrack& track) {
  return person_key(clip.name + '/' + track.id);
}

double preferred_speed(const Clip& clip, const PersonTrack& track, std::uint64_t seed) {
  const Vec2 first_second = track.places[kFollows] - track.places.front();
  const double z = random_normal(seed, key_of(clip, track), 0, Purpose::kSpeedJitter);
  const double jitter = seed != 0 ? kJitter * z : 0.0;
  return first_second.norm() / (kFollows * kFrame) * (1.0 + jitter);
}

Vec2 recorded_velocity(const PersonTrack& track, std::size_t i) {
  const std::size_t from = i >= kPast ? i - kPast : 0;
  const std::size_t to = i > 0 ? i : std::min<std::size_t>(kPast, track.places.size() - 1);
  if (from == to) return Vec2::Zero();
  return (track.places[to] - track.places[from]) / (static_cast<double>(to - from) * kFrame);
}

/// Straight on from the first second's end, without looking.
Polyline blind_way(const Clip& clip, const PersonTrack& track, ReplayModel::Kind kind,
                   std::uint64_t seed) {
  Polyline way = track.places;
  if (way.size() <= kFollows) return way;
  const double speed = preferred_speed(clip, track, seed);
  const Vec2 start = track.places[kFollows], goal = track.places.back();
  const Vec2 first_second = start - track.places.front();
  const Vec2 to_goal = goal - start;
  const bool straight = kind == ReplayModel::Kind::kStraight;
  const Vec2 line = straight ? to_goal : first_second;
  const Vec2 direction = line.norm() > 0.0 ? Vec2(line.normalized()) : Vec2::Zero();
  for (std::size_t i = kFollows + 1; i < way.size(); ++i) {
    const double walked = speed * static_cast<double>(i - kFollows) * kFrame;
    way[i] = start + direction * (straight ? std::min(walked, to_goal.norm()) : walked);
  }
  return way;
}

/// One clip while it is walked.
class Replay {
 public:
  Replay(const Clip& clip, const ReplayModel& model, std::uint64_t seed)
      : clip_(clip),
        seed_(seed),
        zone_(open_space(clip, model)),
        crowd_(zone_, seed),
        groups_(companions(clip)),
        handles_(clip.persons.size()),
        ways_(clip.persons.size()) {
    for (const PersonTrack& person : clip.persons) {
      first_ = std::min(first_, person.first);
      last_ = std::max(last_, person.last());
    }
  }

  void let_vehicles_through() { crowd_.let_vehicles_through(); }

  void run() {
    for (int frame = first_; frame <= last_; ++frame) {
      let_in_and_out(frame);
      record(frame);
      vehicles_.clear();
      for (const VehicleTrack& vehicle : clip_.vehicles) {
        const VehicleState* state = at_frame(vehicle, frame);
        if (state == nullptr) continue;
        vehicles_.push_back(*state);
        vehicles_.back().key = person_key(vehicle.id);
      }
      crowd_.step(kFrame, vehicles_);
      pushes_.add(frame * kFrame, kFrame, crowd_.pushes());
    }
  }

  bool kept_anybody_out() const { return crowd_.kept_anybody_out(); }
  std::vector<Polyline> ways() && { return std::move(ways_); }

  std::vector<PushedPerson> pushes() const {
    std::vector<PushedPerson> all;
    for (const PersonTrack& track : clip_.persons) {
      const auto found = pushes_.persons().find(key_of(clip_, track));
      all.push_back(found != pushes_.persons().end() ? found->second : PushedPerson());
    }
    return all;
  }

 private:
  void let_in_and_out(int frame) {
    seen_.clear();
    for (std::size_t i = 0; i < clip_.persons.size(); ++i) {
      const PersonTrack& track = clip_.persons[i];
      if (frame > track.last() && handles_[i]) {
        crowd_.remove(*handles_[i]);
        handles_[i].reset();
      }
      if (frame < track.first || frame > track.last() || handles_[i]) continue;
      const auto at = static_cast<std::size_t>(frame - track.first);
      if (at < kFollows) {
        seen_.push_back({track.places[at], recorded_velocity(track, at), kRadius});
      } else {
        add(i);
      }
    }
    crowd_.see(seen_);
  }

  void add(std::size_t i) {
    const PersonTrack& track = clip_.persons[i];
    NewPerson person;
    person.key = key_of(clip_, track);
    person.position = track.places[kFollows];
    person.velocity = recorded_velocity(track, kFollows);
    const Vec2 first_second = person.position - track.places.front();
    person.heading = angle_of(first_second);
    person.radius = kRadius;
    person.preferred_speed = preferred_speed(clip_, track, seed_);
    person.destination = {track.places.back(), track.places.back()};
    person.group = groups_[i];
    handles_[i] = crowd_.add(person);
  }

  void record(int frame) {
    for (std::size_t i = 0; i < clip_.persons.size(); ++i) {
      const PersonTrack& track = clip_.persons[i];
      if (frame < track.first || frame > track.last()) continue;
      ways_[i].push_back(handles_[i] ? crowd_.view(*handles_[i]).position
                                     : track.places[static_cast<std::size_t>(frame - track.first)]);
    }
  }

  const Clip& clip_;
  std::uint64_t seed_;
  Zone zone_;
  Crowd crowd_;
  std::vector<std::uint64_t> groups_;
  std::vector<std::optional<Crowd::Handle>> handles_;
  std::vector<Polyline> ways_;
  std::vector<SeenPerson> seen_;
  std::vector<VehicleState> vehicles_;
  PushLog pushes_;
  int first_ = clip_.persons.front().first, last_ = clip_.persons.front().last();
};

}  // namespace

Replayed replay(const Clip& clip, const ReplayModel& model, std::uint64_t seed) {
  Replayed replayed;
  if (model.kind != ReplayModel::Kind::kModel) {
    for (const PersonTrack& track : clip.persons) {
      replayed.ways.push_back(blind_way(clip, track, model.kind, seed));
    }
    replayed.unpushed = replayed.ways;
    return replayed;
  }
  Replay solid(clip, model, seed);
  solid.run();
  replayed.pushes = solid.pushes();
  if (solid.kept_anybody_out()) {
    Replay open(clip, model, seed);
    open.let_vehicles_through();
    open.run();
    replayed.unpushed = std::move(open).ways();
  }
  const bool same = replayed.unpushed.empty();
  replayed.ways = std::move(solid).ways();
  if (same) replayed.unpushed = replayed.ways;
  return replayed;
}

}  // namespace pedzone
