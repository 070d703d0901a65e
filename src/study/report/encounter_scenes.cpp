#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "results/conflict_table.hpp"
#include "study/measure/conflict_measures.hpp"
#include "study/measure/run_measures.hpp"
#include "study/report/encounter_choice.hpp"
#include "study/report/recording_clip.hpp"
#include "study/report/run_recording.hpp"
#include "study/report/scene_parts.hpp"
#include "view/animation.hpp"
#include "view/time_plot.hpp"

namespace pedzone::study {
namespace {

constexpr std::size_t kMost = 3;      // of each model
constexpr double kApart = 10.0;       // [m] assumed: places of its encounters, so that they differ
constexpr double kAround = 5.0;       // [s] shown before and after
constexpr double kReach = 25.0;       // [m] shown around it
constexpr double kRate = 10.0;        // [1/s] numerical
constexpr double kBesideStill = 3.0;  // [m] around the two of them in the picture

constexpr const char* kRule =
    " By danger: with vehicles that move before those with standing ones; contacts first, those at "
    "the highest closing speed first, but not where bodies only brush each other; then least TTC "
    "at a closing speed above 1 m/s, then other TTC, then PET; last those whom SUMO put onto each "
    "other. The next ones are of other people, another vehicle and another place.";

std::string manner(EncounterType type) {
  switch (type) {
    case EncounterType::kHeadOn:
      return "towards each other";
    case EncounterType::kFromBehind:
      return "the vehicle comes from behind";
    case EncounterType::kFollowing:
      return "the person comes from behind";
    case EncounterType::kCrossingLeft:
      return "the person comes from the vehicle's left";
    case EncounterType::kCrossingRight:
      return "the person comes from the vehicle's right";
    case EncounterType::kParked:
      return "the vehicle stands";
  }
  return "";
}

/// "contact at 1.2 m/s", "0.4 s to contact" ...
std::string danger(const Conflict& conflict) {
  if (conflict.contact) {
    return fmt::format("contact at {:.1f} m/s", std::max(0.0, conflict.contact->closing_speed));
  }
  if (conflict.ttc) return fmt::format("{:.1f} s from contact", conflict.ttc->value);
  if (conflict.pet) return fmt::format("{:.1f} s apart", conflict.pet->value);
  if (conflict.clearance) return fmt::format("{:.2f} m apart", conflict.clearance->value);
  return "encounter";
}

std::string numbers(const Conflict& conflict) {
  std::string text;
  const auto add = [&text](const char* name, const std::optional<Extreme>& extreme,
                           const char* unit) {
    if (extreme) text += fmt::format(", {} {:.2f} {}", name, extreme->value, unit);
  };
  if (!conflict.contact) add("TTC", conflict.ttc, "s");
  add("PET", conflict.pet, "s");
  add("greatest DRAC", conflict.drac, "m/s²");
  if (!conflict.contact) add("smallest clearance", conflict.clearance, "m");
  return text;
}

/// An encounter that was chosen.
struct Encounter {
  const PlannedRun& run;
  std::string folder;
  Conflict conflict;
  Extreme moment;
  std::size_t rank, count;  ///< among how many of the model
};

/// [s] since the vehicle was put there; unset where it drove up.
std::optional<double> since_inserted(const Recording& recording, const Encounter& encounter) {
  for (const RecordedVehicle& vehicle : recording.vehicles) {
    if (vehicle.id != encounter.conflict.vehicle || vehicle.moments.front().step == 0) continue;
    const double since = encounter.moment.time - recording.times[vehicle.moments.front().step];
    if (since >= 0.0) return since;
  }
  return std::nullopt;
}

std::string caption(const Plan& plan, const Encounter& encounter, const Recording& recording) {
  const auto& [run, folder, conflict, moment, rank, count] = encounter;
  std::string text = fmt::format(
      "{}, seed {}, at {:.1f} s: person {} ({:.1f} m/s) and vehicle {} ({:.1f} m/s), {}; {}{}.",
      plan.conditions[run.condition].name, run.seed, moment.time, conflict.person,
      moment.person_speed, conflict.vehicle, moment.vehicle_speed, manner(moment.type),
      danger(conflict), numbers(conflict));
  constexpr double kJustNow = 2.0;  // [s] as tests count contacts after insertion apart
  if (const auto since = since_inserted(recording, encounter); since && *since <= kJustNow) {
    text += fmt::format(" SUMO had put the vehicle there {:.1f} s before.", *since);
  }
  text += fmt::format(" Number {} of {} conflicts in the zones by {}.", rank, count, run.model);
  return rank == 1 ? text + kRule : text;
}

std::string still(const Recording& recording, const Place& place, const Encounter& encounter,
                  const std::string& title) {
  const Recording two = only(recording, encounter.conflict.person, encounter.conflict.vehicle);
  Box box;
  for (const RecordedPerson& person : two.persons) {
    for (const PersonMoment& moment : person.moments) box.extend(moment.position);
  }
  return time_plot(
      two, &place,
      {.title = title, .area = grown(box, kBesideStill), .every = 1.0, .narrow = true});
}

ReportScene scene_of(const Plan& plan, const Encounter& encounter, const Place& place) {
  const auto& [run, folder, conflict, moment, rank, count] = encounter;
  const Vec2 reach(kReach, kReach);
  const Box area(moment.position - reach, moment.position + reach);
  const Recording recording =
      read_recording({.file = (std::filesystem::path(folder) / kFcdName).string(),
                      .begin = moment.time - kAround,
                      .end = moment.time + kAround},
                     run_cast(plan, run, folder));
  const Recording near = clipped(recording, area);
  ReportScene scene;
  scene.title = fmt::format("{}: {}", run.model, danger(conflict));
  scene.caption = caption(plan, encounter, recording);
  scene.page = animation_page(
      {{run.model, &near}}, &place,
      {.title = scene.title, .rate = kRate, .area = area, .selected = conflict.person});
  scene.still = still(near, place, encounter, scene.title);
  return scene;
}

class EncounterScenes {
 public:
  EncounterScenes(const Store& store, const Plan& plan, const Records& records, RunPlaces& places)
      : store_(store), plan_(plan), records_(records), places_(places) {}

  std::vector<ReportScene> of_model(const std::string& model) const {
    const EncounterChoice choice = all_of(model);
    std::vector<ReportScene> scenes;
    for (const EncounterChoice::Place& place : choice.most_dangerous(kMost, kApart)) {
      const PlannedRun& run = plan_.runs[place.run];
      const Conflict conflict = conflict_at(place);
      try {
        const std::string folder = store_.run_folder(run.id);
        const Encounter encounter{
            run, folder, conflict, moment_of(conflict), scenes.size() + 1, choice.count()};
        scenes.push_back(scene_of(plan_, encounter, places_.of(run, folder)));
      } catch (const InputError&) {
        continue;  // outputs were removed to save room, or broke: the tables stand without them
      }
    }
    return scenes;
  }

 private:
  std::string table_of(std::size_t run) const {
    return (std::filesystem::path(store_.run_folder(plan_.runs[run].id)) / kZoneConflicts).string();
  }

  EncounterChoice all_of(const std::string& model) const {
    EncounterChoice choice;
    for (std::size_t r = 0; r < plan_.runs.size(); ++r) {
      const bool done = records_[r] && records_[r]->status == RunStatus::kDone;
      const PlannedRun& run = plan_.runs[r];
      if (!done || run.kind != RunKind::kStudy || run.model != model) continue;
      try {
        add_all(r, choice);
      } catch (const InputError&) {
        continue;
      }
    }
    return choice;
  }

  void add_all(std::size_t r, EncounterChoice& choice) const {
    const std::size_t scenario = plan_.conditions[plan_.runs[r].condition].scenario;
    std::size_t row = 0;
    conflict_table().visit(table_of(r), [&](const Conflict& conflict, const CsvRow&) {
      choice.add(scenario, {r, row}, conflict);
      ++row;
    });
  }

  Conflict conflict_at(const EncounterChoice::Place& place) const {
    std::size_t row = 0;
    Conflict found;
    conflict_table().visit(table_of(place.run), [&](const Conflict& conflict, const CsvRow&) {
      if (row++ == place.row) found = conflict;
    });
    return found;
  }

  const Store& store_;
  const Plan& plan_;
  const Records& records_;
  RunPlaces& places_;
};

}  // namespace

std::vector<ReportScene> encounter_scenes(const Store& store, const Plan& plan,
                                          const Records& records, RunPlaces& places) {
  const EncounterScenes all(store, plan, records, places);
  std::vector<ReportScene> scenes;
  for (const std::string& model : plan.study.models) {
    for (ReportScene& scene : all.of_model(model)) scenes.push_back(std::move(scene));
  }
  return scenes;
}

}  // namespace pedzone::study
