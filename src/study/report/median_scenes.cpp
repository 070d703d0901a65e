#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "study/measure/measure_list.hpp"
#include "study/report/busy_window.hpp"
#include "study/report/median_seed.hpp"
#include "study/report/recording_clip.hpp"
#include "study/report/run_recording.hpp"
#include "study/report/scene_parts.hpp"
#include "view/animation.hpp"
#include "view/path_plot.hpp"
#include "view/svg_row.hpp"

namespace pedzone::study {
namespace {

constexpr double kRate = 2.0;         // [1/s] numerical: the page moves people evenly in between
constexpr double kZoneMargin = 3.0;   // [m] shown around the zones
constexpr double kClipMargin = 20.0;  // [m] beyond that, nobody is kept

Box box_of(const std::vector<Zone>& zones) {
  Box box;
  for (const Zone& zone : zones) box.extend(box_of(zone.walkable));
  return box;
}

/// One scenario's reference and one model.
class MedianScene {
 public:
  MedianScene(const Store& store, const Plan& plan, const Records& records, RunPlaces& places,
              const MedianPair& pair)
      : store_(store), plan_(plan), records_(records), places_(places), pair_(pair) {}

  /// Unset where outputs are missing or broken.
  std::optional<ReportScene> make() const {
    const auto window =
        busiest_window({file(pair_.reference, "series.csv"), file(pair_.model, "series.csv")});
    if (!window) return std::nullopt;
    const Place& place = places_.of(run(pair_.reference), folder(pair_.reference));
    const Box area = grown(box_of(place.zones), kZoneMargin);
    const Recording reference = read(pair_.reference, *window, area);
    const Recording model = read(pair_.model, *window, area);
    const std::string &left = run(pair_.reference).model, &right = run(pair_.model).model;
    ReportScene scene;
    scene.title =
        fmt::format("{}: {} beside {}, seed {}", condition().name, left, right, pair_.seed);
    scene.caption = caption(*window);
    scene.page = animation_page({{left, &reference}, {right, &model}}, &place,
                                {.title = scene.title, .rate = kRate, .area = area});
    const auto paths = [&](const std::string& name, const Recording& recording) {
      return NamedPicture{
          name, path_plot(recording, &place, {.title = name, .area = area, .narrow = true})};
    };
    scene.still = svg_row({paths(left, reference), paths(right, model)});
    scene.wide = true;
    return scene;
  }

 private:
  const PlannedRun& run(std::size_t index) const { return plan_.runs[index]; }
  const Condition& condition() const { return plan_.conditions[run(pair_.reference).condition]; }
  std::string folder(std::size_t index) const { return store_.run_folder(run(index).id); }
  std::string file(std::size_t index, const std::string& name) const {
    return (std::filesystem::path(folder(index)) / name).string();
  }

  Recording read(std::size_t index, const TimeWindow& window, const Box& area) const {
    return clipped(
        read_recording({.file = file(index, kFcdName), .begin = window.begin, .end = window.end},
                       run_cast(plan_, run(index), folder(index))),
        grown(area, kClipMargin));
  }

  std::string caption(const TimeWindow& window) const {
    std::string text;
    if (pair_.measures.empty()) {
      text = fmt::format("Seed {}, the first of {}.", pair_.seed, pair_.seeds);
    } else {
      text = fmt::format(
          "Seed {} of {}: the median one, whose differences in the {} main measures lie nearest to "
          "the middle of all seeds.",
          pair_.seed, pair_.seeds, pair_.measures.size());
    }
    for (const std::string key : {"person.travelTime", "vehicle.travelTime"}) {
      text += values(key);
    }
    return text + fmt::format(
                      " Shown: {:g} s to {:g} s, when most people are there; the still "
                      "picture has everybody's way in this time.",
                      window.begin, window.end);
  }

  /// A sentence with both runs' values of a measure; empty where they are not known.
  std::string values(const std::string& key) const {
    const auto &left = records_[pair_.reference]->measures,
               &right = records_[pair_.model]->measures;
    if (!left.contains(key) || !right.contains(key)) return "";
    const Measure& measure = *find_measure(key);
    return fmt::format(" {}, {}: {:.1f} {} by {}, {:.1f} {} by {}.", measure.group, lower(measure),
                       left.at(key), measure.unit, run(pair_.reference).model, right.at(key),
                       measure.unit, run(pair_.model).model);
  }
  static std::string lower(const Measure& measure) {
    std::string name(measure.name);
    name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    return name;
  }

  const Store& store_;
  const Plan& plan_;
  const Records& records_;
  RunPlaces& places_;
  const MedianPair& pair_;
};

}  // namespace

std::vector<ReportScene> median_scenes(const Store& store, const Plan& plan, const Records& records,
                                       RunPlaces& places) {
  std::vector<ReportScene> scenes;
  for (std::size_t s = 0; s < plan.study.scenarios.size(); ++s) {
    const auto condition = middle_condition(plan, records, s);
    if (!condition) continue;
    for (const std::string& model : plan.study.models) {
      if (model == plan.study.reference) continue;
      const auto pair = median_pair(plan, records, *condition, model);
      if (!pair) continue;
      try {
        if (auto scene = MedianScene(store, plan, records, places, *pair).make()) {
          scenes.push_back(std::move(*scene));
        }
      } catch (const InputError&) {
        continue;  // outputs were removed to save room, or broke: the tables stand without them
      }
    }
  }
  return scenes;
}

}  // namespace pedzone::study
