#include "study/measure/zone_stays.hpp"

#include <gmock/gmock.h>

namespace pedzone::study {
namespace {

/// A street of two zones, "a1 a2 b", with "out" beside it; one person.
class ZoneStaysTest : public testing::Test {
 protected:
  ZoneStaysTest() {
    for (const char* id : {"a1", "a2", "b", "out"}) {
      network_.edges.emplace_back();
      network_.edges.back().id = id;
    }
    zones_.resize(2);
    zones_[0].edges = {0, 1};
    zones_[1].edges = {2};
    trips_.persons.emplace_back();
    trips_.persons.back().id = "p";
  }

  /// Whether the person is covered in the middle of each second, of which it spends one on each
  /// edge: "1" or "0" for each.
  std::string covered(const std::vector<std::string>& edges) const {
    ZoneStays stays(trips_, network_, zones_);
    std::string present(edges.size(), '0');
    const auto note = [&present](std::span<const Presence> known) {
      for (const Presence& presence : known) present[presence.step.number] = '1';
    };
    for (std::size_t second = 0; second < edges.size(); ++second) {
      note(stays.step(at(second), std::vector<Pedestrian>{{.edge = edges[second]}}, one_));
    }
    note(stays.finish());
    std::string text;
    for (std::size_t second = 0; second < edges.size(); ++second) {
      text += stays.cover("p", static_cast<double>(second) + 0.5) ? '1' : '0';
    }
    EXPECT_EQ(present, text) << "who is covered and who is present are the same";
    return text;
  }

  static RunStep at(std::size_t second) { return {second, static_cast<double>(second), 1.0}; }

  const std::vector<Closeness> one_{1};
  Network network_;
  std::vector<Zone> zones_;
  Trips trips_;
};

TEST_F(ZoneStaysTest, are_on_its_edges) {
  EXPECT_EQ(covered({"out", "a1", "a2", "b", "out", "never heard of"}), "011100");
}

TEST_F(ZoneStaysTest, are_in_junctions_between_two_of_one_zone) {
  EXPECT_EQ(covered({"a1", ":j_w0", ":j_c0", ":j_w1", "a2"}), "11111");
  EXPECT_EQ(covered({"out", ":j_w0", "a1", ":j_w1", "out"}), "00100");
  EXPECT_EQ(covered({"a2", ":j_w0", "b"}), "101") << "one is left before the other begins";
}

TEST_F(ZoneStaysTest, where_somebody_is_last_decides_by_where_it_came_from) {
  EXPECT_EQ(covered({"a1", ":j_w0"}), "11");
  EXPECT_EQ(covered({"out", ":j_w0"}), "00");
  EXPECT_EQ(covered({":j_w0", "a1"}), "01");
}

TEST_F(ZoneStaysTest, are_told_of_a_junction_when_it_is_left) {
  ZoneStays stays(trips_, network_, zones_);
  const auto told = [&](std::size_t second, const char* edge) {
    std::vector<std::size_t> steps;
    for (const Presence& presence :
         stays.step(at(second), std::vector<Pedestrian>{{.edge = edge}}, one_)) {
      EXPECT_EQ(presence.zone, 0);
      steps.push_back(presence.step.number);
    }
    return steps;
  };
  using testing::ElementsAre;
  EXPECT_THAT(told(0, "a1"), ElementsAre(0));
  EXPECT_THAT(told(1, ":j_w0"), ElementsAre());
  EXPECT_THAT(told(2, "a2"), ElementsAre(1, 2));
  EXPECT_THAT(told(3, ":k_w0"), ElementsAre());
  EXPECT_THAT(told(4, "out"), ElementsAre()) << "it led out";
  EXPECT_TRUE(stays.finish().empty());
}

TEST_F(ZoneStaysTest, are_of_nobody_unknown_and_not_before_the_first_step) {
  ZoneStays stays(trips_, network_, zones_);
  const std::vector<Pedestrian> pedestrians{{.edge = "a1"}};
  stays.step(at(5), pedestrians, one_);
  EXPECT_FALSE(stays.cover("p", 4.9));
  EXPECT_TRUE(stays.cover("p", 5.0));
  EXPECT_FALSE(stays.cover("q", 5.0));
}

}  // namespace
}  // namespace pedzone::study
