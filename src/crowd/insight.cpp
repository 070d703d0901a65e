#include "crowd/insight.hpp"

#include "crowd/behaviour/way.hpp"
#include "crowd/sense/perception.hpp"
#include "crowd/step.hpp"

namespace pedzone {
namespace {

Insight insight_of(const CrowdState& crowd, std::size_t i) {
  const WalkState& walker = crowd.walkers[i];
  Insight insight;
  insight.position = insight.aim = crowd.position(i);
  insight.direction = crowd.persons.heading[i];
  if (walker.arrived) return insight;
  insight.aim = heading_point(walker.route, insight.position);
  insight.direction = crowd.decisions[i].direction;
  insight.speed = crowd.decisions[i].speed;
  const PathMemory& path = crowd.paths[walker.handle];
  if (path != nullptr) insight.waypoint = path->current();
  crowd.model->rays(i, insight.rays);
  return insight;
}

}  // namespace

/// As in a substep that begins now, up to the decisions; the next substep does all of it anew. What
/// people perceive stays as it was: a vehicle noticed here would be one noticed too early.
std::vector<Insight> look_into(CrowdState& crowd, std::span<const std::size_t> rows) {
  const Attention attention = crowd.attention;
  const bool varied = crowd.perception_varies;
  const ByHandle<TrafficMemory> traffic = crowd.traffic;

  append_seen(crowd, crowd.persons);
  crowd.perception_varies = perceives_otherwise(crowd);
  if (crowd.perception_varies) perceive(crowd, crowd.clock.time, crowd.traffic, crowd.attention);
  crowd.proposals.begin(crowd.persons.walking);
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) {
    crowd.proposals.propose(i, wish_of_route(crowd, i));
  }
  resolve(crowd.proposals, crowd.persons);
  decide(crowd, kLongestSubstep, crowd.vehicles, crowd.decisions);
  std::vector<Insight> insights;
  for (const std::size_t i : rows) insights.push_back(insight_of(crowd, i));
  resize_rows(crowd.persons, crowd.persons.walking);

  crowd.traffic = traffic;
  crowd.attention = attention;
  crowd.perception_varies = varied;
  return insights;
}

}  // namespace pedzone
