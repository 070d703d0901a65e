#include "sumo/plan/bystanders.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kFastest = 40.0;  // [m/s] numerical: nobody comes nearer faster, riding included
constexpr double kBeyondSight = 10.0;  // [m] numerical: bodies, and what comes towards somebody
constexpr double kLatest = 5.0;        // [s] numerical: another program may move them anyhow

/// Square cells of the plane, numbered.
class Cells {
 public:
  explicit Cells(double size) : size_(size) {}
  std::int64_t of(const Vec2& point, int right = 0, int up = 0) const {
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / size_)); };
    return (index(point.x()) + right) * (std::int64_t{1} << 32) + index(point.y()) + up;
  }

 private:
  double size_;
};

}  // namespace

/// Prams, wheelchairs and bicycles, longer than wide, cannot be turned to be narrower.
void measure(Bystander& person, const BodySize& size) {
  person.radius = disc_radius(size);
  person.turns = size.length < size.width;
  person.key = person_key(person.id);
}

SeenPerson seen(const Bystander& person, double speed, double heading) {
  const Vec2 velocity = person.external ? person.velocity : Vec2(unit(heading) * speed);
  return {person.position, velocity, person.radius, person.key, heading, person.turns};
}

Bystanders::Bystanders(const std::vector<Zone>& zones) : zones_(zones) {
  for (const Zone& zone : zones) distances_.emplace_back(zone);
}

/// SUMO's list and ours have the same order, so one pass over both finds who came and who went.
void Bystanders::update(std::vector<std::string> ids) {
  if (!std::is_sorted(ids.begin(), ids.end())) std::sort(ids.begin(), ids.end());
  gone_.clear();
  if (std::ranges::equal(ids, all_, {}, {}, &Bystander::id)) return;  // as in most steps
  std::swap(all_, before_);
  all_.clear();
  auto known = before_.begin();
  const auto leave = [&](Bystander& person) { gone_.push_back(std::move(person)); };
  for (std::string& id : ids) {
    while (known != before_.end() && known->id < id) leave(*known++);
    if (known != before_.end() && known->id == id) {
      all_.push_back(std::move(*known++));
    } else {
      all_.emplace_back().id = std::move(id);
    }
  }
  std::for_each(known, before_.end(), leave);
}

void Bystanders::look(Bystander& person, double time, const Vec2& position) const {
  const double elapsed = person.looked_at < 0.0 ? 0.0 : time - person.looked_at;
  person.velocity = elapsed > 0.0 ? Vec2((position - person.position) / elapsed) : Vec2::Zero();
  if (person.velocity.norm() > kHaltingSpeed) person.heading = angle_of(person.velocity);
  person.looked_at = time;
  person.position = position;
  double beyond = kFastest * kLatest;
  for (std::size_t z = 0; z < zones_.size(); ++z) {
    const double distance = distances_[z].at_least(person.position);
    beyond = std::min(beyond, distance - zones_[z].parameters.sight);
  }
  person.near = beyond <= 0.0;
  person.look_at = person.near ? time : time + beyond / kFastest;
}

Bystander* Bystanders::find(const std::string& id) {
  const auto found = std::lower_bound(
      all_.begin(), all_.end(), id,
      [](const Bystander& person, const std::string& key) { return person.id < key; });
  return found == all_.end() || found->id != id ? nullptr : &*found;
}

void Bystanders::set_guest(const std::string& id, bool guest) {
  Bystander* found = find(id);
  if (found == nullptr) return;
  found->guest = guest;
  found->look_at = -1.0;
  found->barred_edge.clear();
}

void Bystanders::seen_from(std::size_t zone, std::span<const Vec2> eyes,
                           std::vector<Bystander*>& out) {
  out.clear();
  const double sight = zones_[zone].parameters.sight;
  const Cells cells(sight + kBeyondSight);
  eyed_.clear();
  for (const Vec2& point : eyes) eyed_.insert(cells.of(point));
  const auto is_eyed = [&](const Vec2& point) {
    for (int right = -1; right <= 1; ++right) {
      for (int up = -1; up <= 1; ++up) {
        if (eyed_.contains(cells.of(point, right, up))) return true;
      }
    }
    return false;
  };
  for (Bystander& person : all_) {
    if (person.guest || !person.near || !is_eyed(person.position)) continue;
    if (distances_[zone].at_least(person.position) > sight) continue;
    out.push_back(&person);
  }
}

}  // namespace pedzone
