#include "crowd/insight.hpp"

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
  if (walker.path != nullptr) insight.waypoint = walker.path->waypoints[walker.path->next];
  crowd.model->rays(i, insight.rays);
  return insight;
}

}  // namespace

/// As in a substep that begins now, up to the decisions; the next substep does all of it anew. What
/// people perceive stays as it was: a vehicle noticed here would be one noticed too early.
std::vector<Insight> look_into(CrowdState& crowd, std::span<const std::size_t> rows) {
  const Attention attention = crowd.attention;
  const bool differs = crowd.differs;
  std::vector<std::vector<Noticed>> noticed;
  for (const WalkState& walker : crowd.walkers) noticed.push_back(walker.noticed);

  append_seen(crowd);
  perceive(crowd, 0.0);
  for (std::size_t i = 0; i < crowd.persons.walking; ++i) set_goal(crowd, i);
  decide(crowd, kLongestSubstep);
  std::vector<Insight> insights;
  for (const std::size_t i : rows) insights.push_back(insight_of(crowd, i));
  resize_rows(crowd.persons, crowd.persons.walking);

  for (std::size_t i = 0; i < noticed.size(); ++i) crowd.walkers[i].noticed = std::move(noticed[i]);
  crowd.attention = attention;
  crowd.differs = differs;
  return insights;
}

}  // namespace pedzone
