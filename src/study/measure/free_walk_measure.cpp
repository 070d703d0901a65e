#include "study/measure/free_walk_measure.hpp"

#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/vec.hpp"
#include "core/xml_stream.hpp"
#include "sumo/files/walked_by_pedzone.hpp"

namespace pedzone::study {
namespace {

constexpr double kMoving = 0.3;      // [m/s] assumed: slower is a stop or a wait, and its ends
constexpr double kLeastTime = 10.0;  // [s] assumed: less says little where dawdling varies by step
constexpr NumberRange kTimes{-1e9, 1e9};   // [s]
constexpr NumberRange kPlaces{-1e9, 1e9};  // [m]

class FreeWalks {
 public:
  explicit FreeWalks(const std::optional<WalkedByPedzone>& controlled) : controlled_(controlled) {}

  void begin_step(double time) {
    ++step_;
    dt_ = time - time_;
    time_ = time;
  }

  void add(const XmlElement& element) {
    const std::string id(element.required("id"));
    Walk& walk = walks_[id];
    const Vec2 at(element.number("x", kPlaces), element.number("y", kPlaces));
    const std::string edge(element.required("edge"));
    const bool ours = models_own(id, edge);
    const double moved = walk.seen > 0 ? (at - walk.at).norm() : 0.0;
    if (walk.seen == 0) walk.begin = time_;
    walk.way += moved;
    walk.end = time_;
    if (ours && walk.ours && walk.seen + 1 == step_ && (controlled_ || edge == walk.edge) &&
        moved >= kMoving * dt_) {
      walk.distance += moved;
      walk.time += dt_;
    }
    walk.seen = step_;
    walk.ours = ours;
    walk.at = at;
    walk.edge = edge;
  }

  std::map<std::string, FreeWalk> result() const {
    std::map<std::string, FreeWalk> result;
    for (const auto& [id, walk] : walks_) {
      FreeWalk& free = result[id];
      if (walk.time > kLeastTime) free.speed = walk.distance / walk.time;
      if (walk.seen == step_) continue;
      free.way = walk.way;
      free.time = walk.end - walk.begin;
    }
    return result;
  }

 private:
  struct Walk {
    std::uint64_t seen = 0;             ///< number of the latest step
    bool ours = false;                  ///< in that step, see models_own
    Vec2 at = Vec2::Zero();             ///< [m] in that step
    std::string edge;                   ///< in that step
    double distance = 0.0, time = 0.0;  ///< [m], [s] of the model's own walking
    double way = 0.0;                   ///< [m] of all
    double begin = 0.0, end = 0.0;      ///< [s]
  };

  /// Whether the model's own walking is to be seen at this moment.
  bool models_own(const std::string& id, const std::string& edge) const {
    if (!controlled_) return !edge.starts_with(':');
    return controlled_->at(id, time_);
  }

  const std::optional<WalkedByPedzone>& controlled_;
  std::uint64_t step_ = 0;
  double time_ = 0.0, dt_ = 0.0;  ///< [s]
  std::unordered_map<std::string, Walk> walks_;
};

}  // namespace

std::map<std::string, FreeWalk> free_walks_of(const std::string& fcd,
                                              const std::string& trajectories) {
  std::optional<WalkedByPedzone> controlled = read_walked(trajectories);
  if (controlled && controlled->empty()) controlled.reset();
  FreeWalks walks(controlled);
  visit_elements(fcd, "fcd-export", [&](const XmlElement& element) {
    if (element.depth() == 1 && element.name() == "timestep") {
      walks.begin_step(element.number("time", kTimes));
    } else if (element.depth() == 2 && element.name() == "person") {
      walks.add(element);
    }
  });
  return walks.result();
}

std::map<std::string, double> free_walk_values(const std::map<std::string, FreeWalk>& walks) {
  std::map<std::string, double> values;
  for (const auto& [id, walk] : walks) {
    if (walk.speed) values["speed:" + id] = *walk.speed;
    if (walk.way) values["way:" + id] = *walk.way;
    if (walk.time) values["time:" + id] = *walk.time;
  }
  return values;
}

}  // namespace pedzone::study
