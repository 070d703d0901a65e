#include "validation/passing_order.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace pedzone {
namespace {

constexpr std::size_t kPart = 16;  // numerical: frames in a part of a way

/// How near [m] a place of a person's way has to be to the vehicle's in a frame, or it is not
/// looked at from there: a step of each.
double reach(const Vec2& along) { return along.norm() + 1.0; }

/// What the vehicle's passage over the point `place` leaves to somebody who is there at frame
/// `when` (a fraction of frames): its centre is there around its frame `j`.
PassingOrder passing_at(const VehicleTrack& vehicle, const Vec2& place, double when, double centre,
                        std::size_t j) {
  std::size_t enter = j, leave = j;
  while (enter > 0 && signed_clearance(vehicle.states[enter - 1], place) <= 0.0) --enter;
  while (leave + 1 < vehicle.states.size() &&
         signed_clearance(vehicle.states[leave + 1], place) <= 0.0) {
    ++leave;
  }
  const double before = vehicle.first + static_cast<double>(enter) - when;
  const double after = when - (vehicle.first + static_cast<double>(leave));
  return {when < centre, std::max({0.0, before, after}) * kFrame};
}

/// The crossings of frame j of a vehicle with a part of a way: the closest in time of these and of
/// what is known.
void look(const VehicleTrack& vehicle, std::size_t j, int first, const Polyline& way,
          const WayPart& part, std::optional<PassingOrder>& closest) {
  const Vec2 a = vehicle.states[j].centre, along = vehicle.states[j + 1].centre - a;
  const double near = reach(along);
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const Vec2 to = a - way[i], step = way[i + 1] - way[i];
    if (to.squaredNorm() > near * near) continue;
    const double area = cross(step, along);
    if (area == 0.0) continue;
    const double walked = cross(to, along) / area, driven = cross(to, step) / area;
    if (walked < 0.0 || walked >= 1.0 || driven < 0.0 || driven >= 1.0) continue;
    const PassingOrder found =
        passing_at(vehicle, a + driven * along, first + static_cast<double>(i) + walked,
                   vehicle.first + static_cast<double>(j) + driven, j);
    if (!closest || found.gap < closest->gap) closest = found;
  }
}

std::vector<WayPart> parts_of(const Polyline& way) {
  std::vector<WayPart> parts;
  for (std::size_t begin = 0; begin + 1 < way.size(); begin += kPart) {
    WayPart part{begin, std::min(begin + kPart, way.size() - 1), {}};
    for (std::size_t i = part.begin; i < part.end; ++i) part.around.extend(way[i]);
    parts.push_back(part);
  }
  return parts;
}

/// A vehicle, and the least time [s] between anybody in frames [first, last] and it.
struct Candidate {
  double least = 0.0;
  std::size_t index = 0;
  auto operator<=>(const Candidate&) const = default;
};

double apart(int first, int last, const VehicleTrack& vehicle) {
  return std::max({0, vehicle.first - last, first - vehicle.last()}) * kFrame;
}

}  // namespace

VehicleWays::VehicleWays(const Clip& clip) {
  for (const VehicleTrack& track : clip.vehicles) {
    Vehicle vehicle{&track, {}, {}};
    for (std::size_t begin = 0; begin + 1 < track.states.size(); begin += kPart) {
      WayPart part{begin, std::min(begin + kPart, track.states.size() - 1), {}};
      for (std::size_t j = part.begin; j < part.end; ++j) {
        if (track.states[j].velocity.norm() < kMovingSpeed) continue;
        const Vec2 a = track.states[j].centre;
        const Vec2 margin = Vec2::Constant(reach(track.states[j + 1].centre - a) + 1e-6);
        part.around.extend(Vec2(a - margin)).extend(Vec2(a + margin));
      }
      if (part.around.isEmpty()) continue;
      vehicle.around.extend(part.around);
      vehicle.parts.push_back(part);
    }
    vehicles_.push_back(std::move(vehicle));
  }
}

std::optional<PassingOrder> VehicleWays::closest_of(const Vehicle& vehicle, int first,
                                                    const Polyline& way,
                                                    std::span<const WayPart> parts) {
  std::optional<PassingOrder> found;
  std::vector<const WayPart*> here;
  for (const WayPart& driven : vehicle.parts) {
    here.clear();
    for (const WayPart& walked : parts) {
      if (driven.around.intersects(walked.around)) here.push_back(&walked);
    }
    for (std::size_t j = driven.begin; j < driven.end && !here.empty(); ++j) {
      if (vehicle.track->states[j].velocity.norm() < kMovingSpeed) continue;
      for (const WayPart* walked : here) look(*vehicle.track, j, first, way, *walked, found);
    }
  }
  return found;
}

std::optional<PassingOrder> VehicleWays::closest(int first, const Polyline& way) const {
  const std::vector<WayPart> parts = parts_of(way);
  const int last = first + static_cast<int>(way.size()) - 1;
  std::vector<Candidate> candidates;
  for (std::size_t v = 0; v < vehicles_.size(); ++v) {
    candidates.push_back({apart(first, last, *vehicles_[v].track), v});
  }
  std::ranges::sort(candidates);
  Eigen::AlignedBox2d around;
  for (const WayPart& part : parts) around.extend(part.around);
  std::optional<PassingOrder> closest;
  std::size_t with = 0;
  for (const auto& [least, v] : candidates) {
    if (closest && least > closest->gap) break;  // nor does any that comes after
    if (!vehicles_[v].around.intersects(around)) continue;
    const auto found = closest_of(vehicles_[v], first, way, parts);
    if (!found) continue;
    if (!closest || found->gap < closest->gap || (found->gap == closest->gap && v < with)) {
      closest = found;
      with = v;
    }
  }
  return closest;
}

}  // namespace pedzone
