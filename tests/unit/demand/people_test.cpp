// People whom a panel plans: how many, when, where, who with; and what is refused.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "geometry/polyline.hpp"
#include "panel_scene.hpp"
#include "scene.hpp"

namespace pedzone::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::map<std::string, int> group_sizes(const std::vector<PlannedPerson>& people) {
  std::map<std::string, int> sizes;
  for (const PlannedPerson& person : people) ++sizes[person.group];
  return sizes;
}

TEST(Panel, one_number_is_enough) {
  PanelScene scene = PanelScene::plaza();
  const auto people = scene.add({{"number", "200"}}).people();
  ASSERT_EQ(people.size(), 200u);
  std::set<std::string> ids;
  std::set<const Profile*> profiles;
  std::set<int> edges;
  for (const PlannedPerson& person : people) {
    ids.insert(person.id);
    profiles.insert(person.profile);
    edges.insert(person.from.edge);
    EXPECT_EQ(person.depart, 0.0);
    EXPECT_TRUE(scene.zones[0].edges.contains(person.to.edge));
  }
  EXPECT_EQ(ids.size(), 200u);
  EXPECT_TRUE(ids.contains("pedestrians.0") && ids.contains("pedestrians.199"));
  EXPECT_GE(profiles.size(), 5u);
  EXPECT_EQ(edges.size(), scene.zones[0].edges.size()) << "they begin everywhere";
}

TEST(Panel, places_lie_on_their_edges_and_apart) {
  PanelScene scene = PanelScene::plaza();
  const auto middle = [&](const PlannedPlace& place) {
    const Lane& lane = scene.network.lanes[walking_lane(scene.network, place.edge)];
    EXPECT_GE(place.position, 0.0);
    EXPECT_LE(place.position, lane.length);
    EXPECT_LE(std::abs(place.lateral), 0.5 * lane.width);
    return point_on(lane.shape, place.position).point;
  };
  for (const PlannedPerson& person : scene.add({{"number", "2000"}}).people()) {
    // 15 m, less what a group spreads.
    EXPECT_GE((middle(person.from) - middle(person.to)).norm(), 15.0 - 2.0) << person.id;
  }
}

TEST(Panel, the_seed_decides_and_nothing_else) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "100"}});
  const std::string first = scene.file(1);
  EXPECT_EQ(first, scene.file(1));
  EXPECT_NE(first, scene.file(2));
  std::map<std::string, double> speeds;
  for (const PlannedPerson& person : scene.people()) speeds[person.id] = person.speed;
  scene.add({{"number", "50"}});  // others beside them change nothing about them
  std::size_t same = 0;
  for (const PlannedPerson& person : scene.people()) {
    const auto found = speeds.find(person.id);
    if (found == speeds.end()) continue;
    EXPECT_EQ(person.speed, found->second);
    ++same;
  }
  EXPECT_EQ(same, 100u);
}

TEST(Panel, times) {
  const auto departures = [](const Attributes& attributes, double begin) {
    std::vector<double> times;
    for (const PlannedPerson& person : PanelScene::plaza().add(attributes).people(3, begin)) {
      times.push_back(person.depart);
    }
    return times;
  };
  EXPECT_EQ(departures({{"number", "3"}, {"alone", "1"}}, 25200), std::vector<double>(3, 25200.0));
  EXPECT_EQ(departures({{"number", "3"}, {"begin", "60"}}, 0), std::vector<double>(3, 60.0));
  // SUMO would drop whoever departs before it begins.
  EXPECT_EQ(departures({{"number", "3"}, {"begin", "60"}}, 90), std::vector<double>(3, 90.0));
  const auto spread = departures({{"number", "50"}, {"begin", "60"}, {"end", "90"}}, 0);
  EXPECT_EQ(spread.size(), 50u);
  EXPECT_TRUE(std::is_sorted(spread.begin(), spread.end()));
  EXPECT_GE(spread.front(), 60.0);
  EXPECT_LE(spread.back(), 90.0);
  EXPECT_GT(spread.back() - spread.front(), 15.0);
  EXPECT_EQ(departures({{"number", "40"}, {"perHour", "3600"}}, 0).size(), 40u);
  EXPECT_LT(departures({{"number", "4000"}, {"perHour", "36"}, {"end", "900"}}, 0).size(), 60u);
}

TEST(Panel, groups_by_number_and_size) {
  PanelScene six = PanelScene::plaza();
  six.add({{"number", "6"}, {"groups", "1"}, {"groupSize", "6"}});
  EXPECT_EQ(group_sizes(six.people()), (std::map<std::string, int>{{"pedestrians.group0", 6}}));
  PanelScene tight = PanelScene::plaza();
  tight.add({{"number", "21"}, {"groups", "7"}, {"groupSize", "2-5"}});
  for (std::uint64_t seed = 1; seed < 30; ++seed) {
    auto sizes = group_sizes(tight.people(seed));
    sizes.erase("");
    EXPECT_EQ(sizes.size(), 7u);
    for (const auto& [id, size] : sizes) EXPECT_TRUE(2 <= size && size <= 5) << size;
  }
  PanelScene nobody_alone = PanelScene::plaza();
  nobody_alone.add({{"number", "60"}, {"alone", "0"}, {"groupSize", "3"}});
  EXPECT_EQ(group_sizes(nobody_alone.people()).size(), 20u);
  PanelScene all_alone = PanelScene::plaza();
  all_alone.add({{"number", "60"}, {"groups", "0"}});
  EXPECT_EQ(group_sizes(all_alone.people()), (std::map<std::string, int>{{"", 60}}));
}

TEST(Panel, from_to_path_and_staying) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "20"},
             {"from", "north"},
             {"to", "south west_path"},
             {"path", "loop"},
             {"atEnd", "stay"}});
  for (const PlannedPerson& person : scene.people()) {
    EXPECT_EQ(scene.network.edges[person.from.edge].id, "north");
    EXPECT_THAT(scene.network.edges[person.to.edge].id, ::testing::AnyOf("south", "west_path"));
  }
  EXPECT_THAT(scene.file(1), AllOf(HasSubstr("<param key=\"pedzone.path\" value=\"loop\"/>"),
                                   HasSubstr("<stop duration=")));
}

TEST(Panel, nobody_is_sent_where_no_way_leads) {
  Scene streets;
  streets.add({"a", {{0, 0}, {50, 0}}, "highway.pedestrian", "A", "B"})
      .add({"b", {{50, 0}, {100, 0}}, "highway.pedestrian", "B", "C"})
      .add({"island", {{0, 200}, {50, 200}}, "highway.pedestrian", "X", "Y"})
      .add_road("road", {{0, -50}, {100, -50}});
  PanelScene scene(streets.network());
  for (const PlannedPerson& person : scene.add({{"number", "300"}}).people()) {
    EXPECT_EQ(scene.network.edges[person.from.edge].id == "island",
              scene.network.edges[person.to.edge].id == "island");
  }
  const auto complaint = [&](const Attributes& attributes) {
    return PanelScene(streets.network()).add(attributes).complaint();
  };
  EXPECT_THAT(complaint({{"number", "1"}, {"from", "a"}, {"to", "island"}}),
              StartsWith("z.xml:7: <pedestrians> attribute to: 'island' cannot be reached"));
  EXPECT_THAT(complaint({{"number", "1"}, {"to", "road"}}),
              HasSubstr("attribute to: 'road' has no lane that persons may use; allowed: "));
  EXPECT_THAT(complaint({{"number", "1"}, {"from", "c"}}),
              HasSubstr("attribute from: 'c' is no edge; allowed: "));
  EXPECT_THAT(complaint({{"number", "1"}, {"zone", "park"}}),
              HasSubstr("attribute zone: 'park' is no zone; allowed: shared-space"));
}

TEST(Panel, hostile_ids_are_escaped) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "2"}});
  Profile odd = *scene.profiles.find("adult");
  odd.id = "a \"b\" & <c>";
  scene.profiles.add(odd);
  scene.panels.front().profiles = {{odd.id, 1.0}};
  EXPECT_THAT(scene.file(1), HasSubstr("value=\"a &quot;b&quot; &amp; &lt;c&gt;\""));
}

TEST(Panel, refuses_what_makes_no_sense) {
  const auto with = [](std::string attribute, std::string value) {
    return panel_complaint({{"number", "10"}, {attribute, value}});
  };
  const auto place = [](const std::string& attribute) {
    return "z.xml:7: <pedestrians> attribute " + attribute + ": ";
  };
  EXPECT_EQ(panel_complaint({}), place("number") + "is missing; allowed: number or perHour");
  EXPECT_EQ(panel_complaint({{"number", "0"}}),
            place("number") + "'0' is out of range; allowed: 1 to 1000000");
  EXPECT_THAT(panel_complaint({{"number", "2.5"}}), HasSubstr("'2.5' is no whole number"));
  EXPECT_THAT(panel_complaint({{"perHour", "60"}}), StartsWith(place("end") + "is missing"));
  EXPECT_THAT(panel_complaint({{"perHour", "1e6"}, {"end", "1e9"}}), HasSubstr("too many people"));
  EXPECT_THAT(with("end", "-1"), HasSubstr("'-1' is out of range"));
  EXPECT_THAT(panel_complaint({{"number", "1"}, {"begin", "9"}, {"end", "8"}}),
              HasSubstr("attribute end: '8' lies before begin"));
  EXPECT_THAT(with("alone", "1.1"), HasSubstr("'1.1' is out of range; allowed: 0 to 1"));
  EXPECT_THAT(with("groups", "6"), HasSubstr("'6' is too many; allowed: 0 to 5 groups of 2"));
  EXPECT_THAT(panel_complaint({{"number", "9"}, {"groups", "1"}, {"alone", "0.5"}}),
              HasSubstr("contradicts groups"));
  EXPECT_THAT(with("groupSize", "1"), HasSubstr("'1' is out of range; allowed: 2 to 50"));
  EXPECT_THAT(with("groupSize", "1-4"), HasSubstr("'1' is out of range"));
  EXPECT_THAT(with("groupSize", "5-2"), HasSubstr("'5-2' runs backwards"));
  EXPECT_THAT(with("speedMin", "0"), HasSubstr("'0' is out of range; allowed: 0.1 to 5"));
  EXPECT_THAT(panel_complaint({{"number", "9"}, {"speedMin", "1.5"}, {"speedMax", "1"}}),
              HasSubstr("attribute speedMax: '1' lies below speedMin"));
  EXPECT_EQ(with("profiles", "adlt=0.5")
                .rfind(place("profiles") + "'adlt' is no profile; allowed: "
                                           "infant, child"),
            0u);
  EXPECT_THAT(with("profiles", "adult"), HasSubstr("'adult' has no share"));
  EXPECT_THAT(with("profiles", "adult=0.5 adult=0.1"), HasSubstr("'adult' is named twice"));
  EXPECT_THAT(with("profiles", "adult=0.7 senior=0.4"),
              HasSubstr("'adult=0.7 senior=0.4' has shares that add to more than 1"));
  EXPECT_THAT(with("activities", "sleeping=0.5"),
              HasSubstr("'sleeping' is no activity; allowed: texting, phoning"));
  EXPECT_THAT(with("activities", "texting=0.7 phoning=0.4"), HasSubstr("more than 1"));
  EXPECT_THAT(with("path", "lop"), HasSubstr("'lop' is no path; allowed: loop"));
  EXPECT_THAT(with("atEnd", "vanish"), HasSubstr("'vanish' is unknown; allowed: leave, stay"));
  EXPECT_THAT(with("id", "a b"), HasSubstr("'a b' is no id"));
  EXPECT_THAT(with("from", "a a"), HasSubstr("'a' is named twice"));
  EXPECT_THAT(with("from", ""), HasSubstr("is empty"));
  EXPECT_THAT(with("colour", "red"), HasSubstr("'colour' is an unknown attribute; allowed: id, "));
}

TEST(Panel, no_small_child_walks_alone) {
  EXPECT_THAT(panel_complaint({{"number", "10"}, {"profiles", "infant=1"}}),
              HasSubstr("attribute profiles: 'infant' would have to walk alone; allowed: "));
  EXPECT_THAT(panel_complaint({{"number", "10"}, {"alone", "1"}, {"profiles", "infant=0.01"}}),
              HasSubstr("would have to walk alone"));
  EXPECT_EQ(
      panel_complaint(
          {{"number", "10"}, {"groups", "5"}, {"groupSize", "2"}, {"profiles", "infant=0.5"}}),
      "");
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "10"}, {"groups", "5"}, {"groupSize", "2"}, {"profiles", "infant=0.5"}});
  std::map<std::string, int> infants;
  for (const PlannedPerson& person : scene.people()) {
    infants[person.group] += person.profile->id == "infant";
  }
  for (const auto& [group, count] : infants) EXPECT_EQ(count, 1) << group;
}

TEST(Panel, who_cannot_walk_so_fast_is_not_drawn) {
  EXPECT_THAT(panel_complaint({{"number", "9"}, {"speedMin", "2"}, {"profiles", "wheelchair=0.1"}}),
              HasSubstr("'wheelchair' cannot walk so fast"));
  PanelScene scene = PanelScene::plaza();
  for (const PlannedPerson& person : scene.add({{"number", "500"}, {"speedMin", "2"}}).people()) {
    EXPECT_GE(person.speed, 2.0);
    EXPECT_NE(person.profile->id, "wheelchair");
  }
}

}  // namespace
}  // namespace pedzone::test
