#include "app/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/command_line/terminal.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kNamed = 10;   // who are stuck among people
constexpr std::size_t kMany = 10;    // people: more are warned of
constexpr double kStoodFor = 120.0;  // [s]
constexpr double kOnePlace = 10.0;   // [m] assumed: so near to one, others stand at the same place

long others_near(const Standstill& one, const std::vector<Standstill>& all) {
  return std::ranges::count_if(all, [&](const Standstill& other) {
    return (other.position - one.position).norm() <= kOnePlace;
  });
}

}  // namespace

void JamWarnings::step(const Simulation& simulation, Progress& progress) {
  const std::vector<JamRecord>& jams = simulation.jams();
  for (; told_ < std::min(jams.size(), kNamed); ++told_) {
    const JamRecord& jam = jams[told_];
    progress.print(fmt::format(
        "{} person '{}' in zone '{}' is stuck among people, or beside a vehicle that stands, at "
        "({:.1f}, {:.1f}), time {:.1f}: it squeezes through.",
        warning_label(), jam.person, jam.zone, jam.position.x(), jam.position.y(), jam.time));
  }
}

void JamWarnings::finish(const Simulation& simulation, Progress& progress) const {
  const std::size_t all = simulation.jams().size();
  if (all > kNamed)
    progress.print(fmt::format("{} {} more were stuck.", warning_label(), all - kNamed));
}

void OutsideNotes::step(const Simulation& simulation, Progress& progress) {
  const std::vector<OutsideRecord>& vehicles = simulation.outside_vehicles();
  for (; vehicles_ < vehicles.size(); ++vehicles_) {
    const OutsideRecord& found = vehicles[vehicles_];
    progress.print(
        fmt::format("Another program drives vehicle '{}' (noticed at {:.1f} s): pedzone does not "
                    "slow it. Its parameter pedzone.external=\"true\" says so from the start.",
                    found.id, found.time));
  }
  const std::vector<OutsideRecord>& persons = simulation.outside_persons();
  for (; persons_ < persons.size(); ++persons_) {
    const OutsideRecord& found = persons[persons_];
    if (!told_.insert(found.id).second) continue;
    progress.print(
        fmt::format("Another program walks person '{}' (from {:.1f} s on): pedzone lets "
                    "it, and the others see it.",
                    found.id, found.time));
  }
}

void StuckWarning::step(const Simulation& simulation, Progress& progress) {
  const std::vector<Standstill>& stuck = simulation.stuck_persons().all();
  if (told_ || stuck.size() <= kMany) return;
  std::vector<Standstill> long_stuck;
  for (const Standstill& one : stuck) {
    if (simulation.time() - one.since >= kStoodFor) long_stuck.push_back(one);
  }
  if (long_stuck.size() <= kMany) return;
  told_ = true;
  const Standstill* most = &long_stuck.front();
  for (const Standstill& one : long_stuck) {
    if (others_near(one, long_stuck) > others_near(*most, long_stuck)) most = &one;
  }
  progress.print(fmt::format(
      "{} at {:.0f} s {} people have stood for {:.0f} s, {} of them within {:.0f} m of '{}' "
      "at ({:.1f}, {:.1f}){}{}.",
      warning_label(), simulation.time(), long_stuck.size(), kStoodFor,
      others_near(*most, long_stuck), kOnePlace, most->id, most->position.x(), most->position.y(),
      most->where.empty() ? "" : " ", most->where));
}

}  // namespace pedzone
