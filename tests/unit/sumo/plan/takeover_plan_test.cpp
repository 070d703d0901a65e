// Who is taken over, from where, and how the crowd gets it.
#include "sumo/plan/takeover_plan.hpp"

#include <gmock/gmock.h>

#include "core/random.hpp"
#include "four_edges.hpp"

namespace pedzone {
namespace {

class TakeoverPlanTest : public testing::Test, protected test::FourEdges {
 protected:
  TakeoverPlanTest() {
    walker_.id = "ann";
    walker_.edges = {"e0", "e1", "e2", "e3"};
    walker_.stages_left = 1;
    walker_.position = {51.0, 0.0};
    walker_.speed = 1.2;
    walker_.top_speed = 1.5;
  }

  std::optional<TakeoverPlan> plan(int edge, bool walked_until_now = false) {
    return plan_takeover(network, zone, edge, walker_, walked_until_now, fleet_, past_);
  }

  const std::vector<Zone> zones_{zone};
  Fleet fleet_{network, zones_};
  WalkerSeen walker_;
  PersonPast past_;
};

TEST_F(TakeoverPlanTest, person_is_taken_over_on_the_zones_first_edge) {
  const auto found = plan(e1);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->stretch.last, 2);
  EXPECT_TRUE(found->start.isApprox(walker_.position));
  EXPECT_FALSE(found->place_freely);
  EXPECT_EQ(found->plan, plan_number(1, walker_.edges, walker_.arrival_position));
  EXPECT_EQ(past_.refused_edge, -1);
}

TEST_F(TakeoverPlanTest, person_goes_round_a_streets_end_only_over_its_walking_area) {
  Junction end;
  end.id = network.edges[e2].to;
  end.street_end = true;
  network.junction_index = {{end.id, 0}};
  network.junctions = {end};
  EXPECT_FALSE(touches_street_end(network, e1));
  EXPECT_TRUE(touches_street_end(network, e2));
  for (const auto& [id, function] :
       {std::pair(":" + end.id + "_w0", EdgeFunction::kWalkingArea),
        std::pair(":" + end.id + "_c0", EdgeFunction::kCrossing),
        std::pair(std::string(":else_w0"), EdgeFunction::kWalkingArea)}) {
    Edge edge;
    edge.id = id;
    edge.function = function;
    network.edge_index[id] = static_cast<int>(network.edges.size());
    network.edges.push_back(edge);
  }
  EXPECT_TRUE(leads_round_street_end(network, ":" + end.id + "_w0"));
  EXPECT_FALSE(leads_round_street_end(network, ":" + end.id + "_c0"));
  EXPECT_FALSE(leads_round_street_end(network, ":else_w0"));
  EXPECT_FALSE(leads_round_street_end(network, ""));
}

TEST_F(TakeoverPlanTest, person_beside_the_area_begins_inside_it_or_is_left_to_sumo) {
  walker_.position = {60.0, 2.9};
  const auto found = plan(e1);
  ASSERT_TRUE(found);
  EXPECT_LE(found->start.y(), 2.0);
  walker_.position = {60.0, 3.1};
  EXPECT_FALSE(plan(e1));
  EXPECT_EQ(past_.refused_edge, e1) << "not asked again on this edge";
}

TEST_F(TakeoverPlanTest, person_as_good_as_through_stays_sumos) {
  const double portal = 150.0 - kPortalInset;
  walker_.position = {portal - 1.4, 0.0};
  EXPECT_FALSE(plan(e2));
  walker_.position = {portal - 1.6, 0.0};
  EXPECT_TRUE(plan(e2));
  // The other way round, too.
  walker_.edges = {"e3", "e2", "e1", "e0"};
  walker_.position = {50.0 + kPortalInset + 1.4, 0.0};
  EXPECT_FALSE(plan(e1));
  walker_.position = {50.0 + kPortalInset + 1.6, 0.0};
  EXPECT_TRUE(plan(e1));
}

TEST_F(TakeoverPlanTest, unless_it_would_step_over_the_zones_last_junction) {
  add_walking_area();
  walker_.edges = {"e0", "e1", "e2", "e3", "e4"};
  walker_.position = {149.8, 0.0};
  const auto found = plan(e2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->stretch.release, Release::kStepOver);
}

TEST_F(TakeoverPlanTest, person_whose_plan_has_changed_goes_on_however_short_the_rest) {
  walker_.position = {149.0, 0.0};
  EXPECT_FALSE(plan(e2));
  EXPECT_TRUE(plan(e2, true));
}

TEST_F(TakeoverPlanTest, nobody_is_taken_from_an_edge_so_short_that_sumo_walks_beyond_its_end) {
  network.lanes[walking_lane(network, e1)].length = kShortEdge - 0.01;
  EXPECT_FALSE(plan(e1));
  EXPECT_EQ(past_.refused_edge, e1) << "not asked again on this edge";
  EXPECT_TRUE(plan(e1, true)) << "the crowd has it already";
  walker_.position = {101.0, 0.0};
  EXPECT_TRUE(plan(e2)) << "the next edge is long enough";
}

TEST_F(TakeoverPlanTest, person_arriving_in_the_zone_counts_the_way_to_its_arrival) {
  walker_.edges = {"e0", "e1"};
  walker_.arrival_position = 20.0;
  walker_.position = {70.5, 0.0};
  EXPECT_FALSE(plan(e1));
  walker_.position = {75.0, 0.0};
  EXPECT_TRUE(plan(e1)) << "beyond it: it walks back";
}

class Entering : public TakeoverPlanTest {
 protected:
  Entering() {
    put_walking_area_between(e0, e1);
    walker_.position = {49.7, 0.0};
  }

  std::optional<EntryPlan> enter(double dt = 0.1, bool walked_until_now = false) {
    const std::vector<Zone> zones{zone};
    return plan_entry(network, zones, zones_of_edges(network, zones), e0, walker_, walked_until_now,
                      dt, fleet_, past_);
  }
};

TEST_F(Entering, person_is_taken_over_before_sumo_has_it_on_a_walking_area) {
  const auto entry = enter();
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->zone, 0);
  EXPECT_EQ(entry->plan.stretch.last, 2);
  EXPECT_NEAR(entry->plan.start.x(), 50.0, 0.01) << "where the zone's area begins";
  EXPECT_EQ(entry->plan.plan, past_.plan);
}

TEST_F(Entering, not_sooner_than_in_the_last_step_before_it) {
  walker_.position = {49.6, 0.0};
  EXPECT_FALSE(enter(0.1));
  EXPECT_TRUE(enter(0.2));
}

TEST_F(Entering, against_the_direction_of_the_edge_too) {
  zone.edges = {e0};
  zone.lanes = {lane_of(e0)};
  zone.links.clear();
  has_space({{0, -2}, {50, -2}, {50, 2}, {0, 2}});
  walker_.edges = {"e1", "e0"};
  walker_.arrival_position = 10.0;
  walker_.position = {50.2, 0.0};
  const std::vector<Zone> zones{zone};
  const std::vector<int> of_edges = zones_of_edges(network, zones);
  EXPECT_TRUE(plan_entry(network, zones, of_edges, e1, walker_, false, 0.1, fleet_, past_));
  walker_.position = {51.0, 0.0};
  EXPECT_FALSE(plan_entry(network, zones, of_edges, e1, walker_, false, 0.1, fleet_, past_));
}

TEST_F(Entering, not_where_the_walk_does_not_lead_into_the_zone) {
  walker_.edges = {"e0"};
  EXPECT_FALSE(enter()) << "it ends before";
  walker_.edges = {"e0", "e3"};
  EXPECT_FALSE(enter());
}

TEST_F(Entering, not_where_other_than_a_walking_area_lies_between) {
  network.connections.pop_back();
  EXPECT_FALSE(enter());
}

TEST_F(Entering, who_walks_beyond_already_goes_on) {
  walker_.position = {54.0, 0.0};
  network.connections.clear();
  EXPECT_FALSE(enter());
  EXPECT_TRUE(enter(0.1, true));
}

TEST_F(Entering, people_come_from_edges_at_the_zones_junctions) {
  const int brief = add_edge("brief", "D", "G", 150, 151);
  const int far = add_edge("far", "H", "I", 300, 350);
  const std::vector<bool> entries =
      entries_of_zones(network, zones_of_edges(network, std::vector<Zone>{zone}));
  EXPECT_TRUE(entries[e0]);
  EXPECT_TRUE(entries[e3]);
  EXPECT_FALSE(entries[e1]) << "of the zone";
  EXPECT_FALSE(entries[brief]) << "nobody is taken over there";
  EXPECT_FALSE(entries[far]);
}

TEST_F(TakeoverPlanTest, person_that_comes_twice_by_an_edge_is_left_where_sumo_does_not_tell_when) {
  walker_.edges = {"e1", "e0", "e1", "e2", "e3"};
  EXPECT_FALSE(plan(e1)) << "the first passage or the second?";
  EXPECT_EQ(past_.refused_edge, e1);
  past_.last = 0;  // released on the first: the second is meant
  ASSERT_TRUE(plan(e1));
  EXPECT_EQ(plan(e1)->stretch.last, 3);
}

TEST_F(TakeoverPlanTest, with_another_plan_earlier_releases_do_not_count) {
  past_.plan = plan_number(2, walker_.edges, walker_.arrival_position);
  past_.last = 2;
  EXPECT_TRUE(plan(e1));
  EXPECT_EQ(past_.last, -1);
}

TEST_F(TakeoverPlanTest, person_released_before_is_not_taken_over_on_the_same_passage) {
  past_.plan = plan_number(1, walker_.edges, walker_.arrival_position);
  past_.last = 2;
  walker_.position = {120.0, 0.0};
  EXPECT_FALSE(plan(e2));
}

TEST_F(TakeoverPlanTest, nobody_is_taken_over_where_no_way_leads_through) {
  zone.ways = WayFinder(Region{Polygon{{{50, -2}, {90, -2}, {90, 2}, {50, 2}}, {}},
                               Polygon{{{110, -2}, {150, -2}, {150, 2}, {110, 2}}, {}}},
                        kWayClearance);
  EXPECT_FALSE(plan(e1));
}

TEST_F(TakeoverPlanTest, person_that_departs_here_may_be_moved_to_a_free_place) {
  walker_.edges = {"e1", "e2", "e3"};
  EXPECT_FALSE(plan(e1)->place_freely) << "it walks already";
  walker_.speed = 0.0;
  EXPECT_TRUE(plan(e1)->place_freely);
  EXPECT_FALSE(plan(e1, true)->place_freely);
  walker_.edges = {"e0", "e1", "e2", "e3"};
  EXPECT_FALSE(plan(e1)->place_freely) << "it has stopped on its way";
}

TEST_F(TakeoverPlanTest, person_whom_sumo_walks_into_a_vehicle_is_put_beside_it) {
  fleet_.update({test::seen_vehicle("van", {53.0, 0.0}, 0.0)}, 0.1);
  EXPECT_TRUE(plan(e1)->place_freely);
  EXPECT_FALSE(plan(e1, true)->place_freely) << "the crowd has put it there";
  walker_.position = {53.3, 0.0};
  EXPECT_FALSE(plan(e1)->place_freely);
}

TEST_F(TakeoverPlanTest, person_walks_where_the_crowd_has_put_it_unless_in_a_vehicle) {
  fleet_.update({test::seen_vehicle("van", {53.0, 0.0}, 0.0)}, 0.1);
  TakeoverPlan freely;
  freely.place_freely = true;
  PersonView view{};
  view.position = {51.0, 0.0};
  EXPECT_EQ(entry_of(freely, view, 0.25, fleet_, 0.1), Entry::kNoRoom);
  EXPECT_EQ(entry_of({}, view, 0.25, fleet_, 0.1), Entry::kWalks) << "the vehicle ran into it";
  view.position = {53.3, 0.0};
  EXPECT_EQ(entry_of(freely, view, 0.25, fleet_, 0.1), Entry::kWalks);
  EXPECT_EQ(entry_of(freely, view, 0.35, fleet_, 0.1), Entry::kNoRoom) << "it is wider";
}

TEST_F(TakeoverPlanTest, person_whom_sumo_puts_before_a_vehicle_that_cannot_stop_stays_sumos) {
  VehicleSeen seen = test::seen_vehicle("van", {60.0, 0.0}, 10.0);
  seen.traits.decel = 4.5;  // from 10 m/s it stops within 11.2 m, or a step more
  seen.lane = lane_of(e1);
  const std::vector<int> route{e1, e2};
  seen.route = route;
  fleet_.update({seen}, 0.1);
  PersonView view{};
  view.position = {68.0, 0.0};
  EXPECT_EQ(entry_of({}, view, 0.25, fleet_, 0.1), Entry::kNoRoom);
  TakeoverPlan ours;
  ours.from_sumo = false;
  EXPECT_EQ(entry_of(ours, view, 0.25, fleet_, 0.1), Entry::kWalks) << "the crowd has put it there";
  view.position = {73.0, 0.0};
  EXPECT_EQ(entry_of({}, view, 0.25, fleet_, 0.1), Entry::kWalks) << "far enough";
  view.position = {68.0, 2.0};
  EXPECT_EQ(entry_of({}, view, 0.25, fleet_, 0.1), Entry::kWalks) << "beside its way";
  fleet_.vehicles()[0].traits.yields = false;
  view.position = {68.0, 0.0};
  EXPECT_EQ(entry_of({}, view, 0.25, fleet_, 0.1), Entry::kWalks) << "it stops for nobody";
}

TEST_F(TakeoverPlanTest, person_that_would_rather_cross_at_a_junction_stays_sumos) {
  PersonView view{};
  view.stays_outside = true;
  EXPECT_EQ(entry_of({}, view, 0.25, fleet_, 0.1), Entry::kStaysOutside);
}

TEST_F(TakeoverPlanTest, walk_that_leads_a_long_way_round_comes_by_the_ends_of_its_edges) {
  walker_.edges = {"e1", "e2"};
  walker_.arrival_position = 30.0;
  EXPECT_TRUE(plan(e1)->round.empty());
  const int back = add_edge("back", network.edges[e2].to, network.edges[e1].from, 150.0, 50.0);
  zone.edges.insert(back);
  link(e2, back);
  walker_.edges = {"e1", "e2", "back"};  // 100 m there and, but for 10 m, back
  walker_.arrival_position = 90.0;
  const auto round = plan(e1)->round;
  ASSERT_EQ(round.size(), 2u);
  EXPECT_NEAR(round[1].at.x(), 150.0, 0.5);
  EXPECT_TRUE(plan(e1, true)->round.empty()) << "how much is behind it?";
  walker_.arrival_position = 20.0;  // 119 m to a place 79 m ahead
  EXPECT_TRUE(plan(e1)->round.empty());
}

TEST_F(TakeoverPlanTest, plan_is_another_with_other_edges_or_stages) {
  const std::size_t one = plan_number(1, {"a", "b"}, 5.0);
  EXPECT_EQ(one, plan_number(1, {"a", "b"}, 5.0));
  EXPECT_NE(one, plan_number(2, {"a", "b"}, 5.0));
  EXPECT_NE(one, plan_number(1, {"b", "a"}, 5.0));
  EXPECT_NE(one, plan_number(1, {"a"}, 5.0));
  EXPECT_NE(one, plan_number(1, {"a", "b"}, 6.0));
}

TEST_F(TakeoverPlanTest, free_speed_is_that_of_sumos_striping_model) {
  // It takes a share between 0 and `dawdling` off, all alike likely.
  EXPECT_EQ(striping_share(0.0), 1.0);
  EXPECT_NEAR(striping_share(0.2), 0.9, 1e-12);
  EXPECT_NEAR(striping_share(7.0), 0.5, 1e-12) << "SUMO takes 1 at most";
}

TEST_F(TakeoverPlanTest, crowd_gets_the_person_as_it_walks) {
  walker_.heading = 0.5 * kPi;
  walker_.radius = 0.3;
  const auto found = plan(e1);
  const NewPerson person = new_person(walker_, *found, {}, 0, 1.35);
  EXPECT_EQ(person.key, person_key("ann"));
  EXPECT_TRUE(person.position.isApprox(found->start));
  EXPECT_TRUE(person.velocity.isApprox(Vec2(0.0, 1.2)));
  EXPECT_EQ(person.heading, walker_.heading);
  EXPECT_EQ(person.radius, 0.3);
  EXPECT_EQ(person.preferred_speed, 1.35);
  walker_.speed = 9.0;
  EXPECT_NEAR(new_person(walker_, *found, {}, 0, 1.35).velocity.norm(), 1.35, 1e-12);
}

TEST_F(TakeoverPlanTest, portal_leaves_room_for_the_body_at_both_sides) {
  network.lanes[lane_of(e2)].vehicles = false;
  walker_.radius = 0.3;
  const auto found = plan(e1);
  const Destination portal = new_person(walker_, *found, {}, 0, 1.35).destination;
  EXPECT_NEAR((portal.a - portal.b).norm(), 4.0 - 2.0 * 0.3, 1e-9);
  walker_.radius = 5.0;  // wider than the street: its middle
  const Destination middle = new_person(walker_, *found, {}, 0, 1.35).destination;
  EXPECT_NEAR((middle.a - middle.b).norm(), 0.0, 1e-9);
  EXPECT_NEAR(middle.a.y(), 0.0, 1e-9);
}

TEST_F(TakeoverPlanTest, edges_belong_to_the_zone_that_has_them) {
  Zone other;
  other.edges = {e3};
  EXPECT_THAT(zones_of_edges(network, {zone, other}), testing::ElementsAre(-1, 0, 0, 1));
}

}  // namespace
}  // namespace pedzone
