#include "sumo/files/fcd_reader.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sumo/files/frames.hpp"
#include "sumo/files/number_text.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kTimes{-1e9, 1e9};         // [s]
constexpr NumberRange kPlaces{-1e9, 1e9};        // [m]
constexpr NumberRange kAngles{-360.0, 360.0};    // [deg]
constexpr NumberRange kSpeeds{-1000.0, 1000.0};  // [m/s]

/// [m] way after which an older direction counts a third (1/e). Positions are rounded to 0.01 m.
/// Assumed, against `pedzone run`, which knows velocities: with 0.3 m directions lag too much.
constexpr double kDirectionWay = 0.05;

// Who walks so far [m] by their speeds, all together, and gets by less than that share of it, is
// given in degrees. Numerical: a degree has 60 km at least, of those people live at. In steps
// longer than kLong [s] speeds tell little.
constexpr double kTold = 100.0, kLeastShare = 0.01, kLong = 2.0;

/// [m] one that is so much farther than its speed explains has been put there.
constexpr double kJump = 1.0;

constexpr std::uint64_t kForgetEvery = 256;  // [steps] numerical: those who are gone

auto place_of(const auto& row) {
  return std::tie(row.reference.x(), row.reference.y(), row.angle, row.speed);
}

}  // namespace

void FcdReader::read(const std::string& file, const StepVisitor& visitor,
                     const ReadProgress& progress) {
  file_ = file;
  visit_elements(
      file, "fcd-export",
      [&](const XmlElement& element) {
        if (element.depth() == 1 && element.name() == "timestep") {
          begin_step(element, visitor);
        } else if (element.depth() == 2 && in_step_) {
          if (element.name() == "person") add(element, true);
          if (element.name() == "vehicle") add(element, false);
        }
      },
      progress);
  end_step(visitor);
}

void FcdReader::begin_step(const XmlElement& element, const StepVisitor& visitor) {
  end_step(visitor);
  const auto clock = time_of(element.value("time"));  // human-readable-time, too
  const double time = clock ? *clock : element.number("time", kTimes);
  if (step_ > 0 && time <= time_) {
    throw element.error("is not later than the step before", "time", *element.value("time"));
  }
  before_ = time_;
  time_ = time;
  in_step_ = true;
  ++step_;
  person_rows_.clear();
  vehicle_rows_.clear();
}

void FcdReader::add(const XmlElement& element, bool person) {
  const std::string id(element.required("id"));
  const bool walks = person || as_persons_.contains(std::string(element.required("type")));
  Movers::value_type& mover = *(walks ? persons_ : vehicles_).try_emplace(id).first;
  if (mover.second.seen == step_) throw element.error("is there twice in this time step", "id", id);
  (walks ? person_rows_ : vehicle_rows_).push_back(row_of(element, person, mover));
}

FcdReader::Row FcdReader::row_of(const XmlElement& element, bool person,
                                 Movers::value_type& entry) {
  Mover& mover = entry.second;
  if (mover.size.length == 0.0) {
    const auto size = person ? std::optional(sizes_.of_person(entry.first))
                             : sizes_.of_type(element.required("type"));
    if (!size) {
      throw element.error("is a vehicle type whose size is not known", "type",
                          element.required("type"),
                          "types of the files given with --scenario and --vtypes");
    }
    mover.size = *size;
    if (!person) {
      mover.type = element.required("type");
      mover.parts = sizes_.parts_of_type(mover.type, mover.size.length);
    }
  }
  Row row;
  row.id = &entry.first;
  row.mover = &mover;
  row.edge = &mover.edge;
  if (const auto edge = element.value("edge"); person && edge && mover.edge != *edge) {
    mover.edge = *edge;
  }
  row.reference = {element.number("x", kPlaces), element.number("y", kPlaces)};
  row.angle = element.number("angle", kAngles);
  row.speed = element.number("speed", kSpeeds);
  row.heading = radians_from_sumo(row.angle);
  row.size = mover.size;
  // SUMO's reference of a vehicle is its front bumper.
  row.centre =
      person ? row.reference : Vec2(row.reference - unit(row.heading) * (0.5 * mover.size.length));
  if (mover.parts.bends()) follow_front(row, mover);
  if (mover.seen + 1 == step_ && mover.seen > 0) {
    const Vec2 moved = row.centre - mover.at;
    mover.way = mover.way * std::exp(-moved.norm() / kDirectionWay) + moved;
    if (person && time_ - before_ <= kLong) {
      told_way_ += std::abs(row.speed) * (time_ - before_);
      gone_way_ += moved.norm();
    }
  } else {
    mover.way = unit(row.heading) * (row.speed < 0.0 ? -kDirectionWay : kDirectionWay);
  }
  mover.at = row.centre;
  mover.seen = step_;
  row.velocity = mover.way.normalized() * std::abs(row.speed);
  return row;
}

/// Who was not there in the step before, or has been put elsewhere, begins anew.
void FcdReader::follow_front(const Row& row, Mover& mover) const {
  const bool was_here = mover.trail.begun() && mover.seen + 1 == step_;
  const double most = kJump + 2.0 * std::abs(row.speed) * (time_ - before_);
  if (was_here && (row.reference - mover.trail.front()).norm() <= most) {
    mover.trail.go_to(row.reference);
  } else {
    mover.trail.begin(row.reference, row.heading, mover.size.length);
  }
}

void FcdReader::add_samples(const Row& vehicle) {
  const Mover& mover = *vehicle.mover;
  if (!mover.parts.bends()) {
    vehicle_samples_.push_back({*vehicle.id, vehicle.centre, vehicle.heading, vehicle.velocity,
                                vehicle.size.length, vehicle.size.width});
    return;
  }
  const double along = vehicle.velocity.dot(unit(vehicle.heading));
  add_parts(*vehicle.id, mover.trail.parts(mover.parts, vehicle.size.width),
            std::copysign(vehicle.velocity.norm(), along), vehicle_samples_);
}

void FcdReader::end_step(const StepVisitor& visitor) {
  if (!in_step_) return;
  in_step_ = false;
  if (told_way_ > kTold && gone_way_ < kLeastShare * told_way_) {
    throw InputError("has places in degrees",
                     {.file = file_, .allowed = "metres: SUMO without fcd-output.geo"});
  }
  vehicle_samples_.clear();
  person_samples_.clear();
  for (const Row& row : vehicle_rows_) add_samples(row);
  // By place, to find who rides.
  std::sort(vehicle_rows_.begin(), vehicle_rows_.end(),
            [](const Row& a, const Row& b) { return place_of(a) < place_of(b); });
  for (const Row& row : person_rows_) {
    const auto same =
        std::lower_bound(vehicle_rows_.begin(), vehicle_rows_.end(), row,
                         [](const Row& a, const Row& b) { return place_of(a) < place_of(b); });
    const bool rides = same != vehicle_rows_.end() && place_of(*same) == place_of(row);
    person_samples_.push_back(
        {*row.id, row.centre, row.velocity, row.heading, disc_radius(row.size),
         rides ? std::string_view(*same->id) : std::string_view(), *row.edge});
  }
  visitor(time_, person_samples_, vehicle_samples_);
  if (step_ % kForgetEvery != 0) return;
  for (Movers* movers : {&persons_, &vehicles_}) {
    std::erase_if(*movers, [&](const auto& entry) { return entry.second.seen != step_; });
  }
}

}  // namespace pedzone
