// The page of a validation: well-formed and offline whatever files say, complete, to scale.
#include "validation/page.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <pugixml.hpp>

namespace pedzone::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kSeeds = 2;
constexpr std::string_view kHostile = "</td><script>alert('&\"1\"')</script>";

/// Persons who walk east at 1 m/s for 6 s, while a vehicle of 4 by 2 m drives north before them.
Clip clip(const std::string& site, const std::string& manoeuvre, int persons) {
  Clip clip{std::string(kHostile) + "\n", site, manoeuvre, {}, {}};
  for (int i = 0; i < persons; ++i) {
    PersonTrack track{"p" + std::to_string(i) + std::string(kHostile), 0, {}};
    for (int k = 0; k <= 60; ++k) track.places.emplace_back(0.1 * k, 1.5 * i);
    clip.persons.push_back(std::move(track));
  }
  VehicleTrack vehicle{"v", 0, {}};
  for (int k = 0; k <= 60; ++k) {
    VehicleState state;
    state.centre = {7.5, 0.2 * k - 6.0};
    state.heading = 0.5 * M_PI;
    state.velocity = {0.0, 2.0};
    state.length = 4.0;
    state.width = 2.0;
    vehicle.states.push_back(state);
  }
  clip.vehicles.push_back(std::move(vehicle));
  return clip;
}

class Page : public ::testing::Test {
 protected:
  void replay(std::vector<Clip> clips, std::size_t worst = 2) {
    ReplayModel model;
    model.name = kHostile;
    result_ = validate(std::move(clips), {{model}, kSeeds, 10}, [](double) {});
    read(worst_cases(result_, model, worst));
  }

  void replay_two_sites() {
    replay({clip("a<b>", "front", 3), clip("a<b>", "back & \"forth\"", 2), clip("c", "front", 1)});
  }

  void read(const std::vector<DrawnCase>& worst) {
    text_ = validation_page(result_, worst);
    const pugi::xml_parse_result parsed = document_.load_string(text_.c_str());
    ASSERT_TRUE(parsed) << parsed.description() << " at " << text_.substr(parsed.offset, 80);
  }

  std::size_t count(const std::string& path) { return document_.select_nodes(path.c_str()).size(); }

  /// The pictures below the first heading of a group.
  std::vector<pugi::xml_node> charts(const std::string& group) {
    std::vector<pugi::xml_node> found;
    for (const auto& match : document_.select_nodes("//h3")) {
      if (match.node().text().get() != group + " ") continue;
      for (const auto& figure : match.node().next_sibling("div").select_nodes("figure")) {
        found.push_back(figure.node());
      }
      if (!found.empty()) break;
    }
    return found;
  }

  ValidationResult result_;
  std::string text_;
  pugi::xml_document document_;
};

std::ptrdiff_t steps(const pugi::xml_node& chart, const std::string& look) {
  const auto curve = chart.select_node(("svg/path[@class='line " + look + "']").c_str()).node();
  const std::string path = curve.attribute("d").value();
  return std::count(path.begin(), path.end(), 'V');
}

TEST_F(Page, is_well_formed_and_offline_whatever_the_names_are) {
  replay_two_sites();
  EXPECT_EQ(count("//script"), 0u);
  EXPECT_STREQ(document_.document_element().name(), "html");
  for (const char* loads : {"://", "url(", "src=", "@import"}) {
    EXPECT_THAT(text_, Not(HasSubstr(loads)));
  }
  const std::string person = document_.select_node("//figcaption/b").node().text().get();
  EXPECT_THAT(person, HasSubstr(kHostile));
  EXPECT_THAT(person, Not(HasSubstr("\n")));
}

TEST_F(Page, has_a_table_of_all_models_for_every_set_and_group) {
  replay_two_sites();
  const std::size_t groups = groups_of(result_.data).size();
  EXPECT_EQ(groups, 1u + 2u + 3u);
  EXPECT_EQ(count("//table[@class='figures']"), 2 * groups);
  EXPECT_EQ(count("//table[@class='figures']/tbody/tr"), 2 * groups * (1 + result_.models.size()));
  EXPECT_EQ(count("//table[@class='figures']/tbody/tr[1]/td"), 2 * groups * kFigures);
  EXPECT_EQ(count("//ul[@class='meanings']/li"), kFigures);
}

TEST_F(Page, draws_every_person_in_the_curves_of_its_groups) {
  replay_two_sites();
  EXPECT_EQ(count("//figure[@class='chart']"), 2 * 4 * groups_of(result_.data).size());
  for (const std::string& group : groups_of(result_.data)) {
    const auto persons = static_cast<std::ptrdiff_t>(
        members(result_, result_.runs[0], 0, PersonSet::kRecorded, group).size());
    ASSERT_EQ(charts(group).size(), 4u) << group;
    for (const pugi::xml_node& chart : charts(group)) {
      EXPECT_EQ(steps(chart, "recorded"), persons) << group;
      for (const char* look : {"main", "plain", "straight"}) {
        EXPECT_EQ(steps(chart, look), kSeeds * persons) << group << ' ' << look;
      }
    }
  }
}

TEST_F(Page, prints_the_same_distance_to_the_recording_in_tables_and_pictures) {
  replay_two_sites();
  const auto row = std::find_if(result_.rows.begin(), result_.rows.end(), [](const auto& r) {
    return r.group == "all" && r.model == "straight to goal";
  });
  char distance[16];
  std::snprintf(distance, sizeof distance, "%.2f",
                row->value[static_cast<std::size_t>(Figure::kLeastSpeedKs)]);
  const auto caption = charts("all").at(2).child("figcaption");
  const auto last = caption.select_node(".//span[@class='legend']/span[last()]").node();
  EXPECT_THAT(last.last_child().value(), HasSubstr(distance));
}

TEST_F(Page, draws_the_worst_cases_to_scale_with_a_mark_each_second) {
  replay_two_sites();
  ASSERT_EQ(count("//figure[@class='case']"), 2u);
  const auto figure = document_.select_node("//figure[@class='case']").node();
  EXPECT_EQ(figure.select_nodes("svg/path[@class='line recorded']").size(), 1u);
  EXPECT_EQ(figure.select_nodes("svg/path[@class='line main walked']").size(), 1u);
  EXPECT_EQ(figure.select_nodes("svg/circle[starts-with(@class, 'place')]").size(), 2u * 7u);
  EXPECT_EQ(figure.select_nodes("svg/path[@class='vehicle']").size(), 7u);
  const auto outline = figure.select_node("svg/path[@class='vehicle']").node();
  double x[3], y[3];
  ASSERT_EQ(std::sscanf(outline.attribute("d").value(), "M%lf %lfL%lf %lfL%lf %lf", x, y, x + 1,
                        y + 1, x + 2, y + 2),
            6);
  const double length = std::hypot(x[1] - x[0], y[1] - y[0]);
  const double width = std::hypot(x[2] - x[1], y[2] - y[1]);
  // 4 by 2 m, written to a tenth of a pixel.
  EXPECT_NEAR(length, 2.0 * width, 0.5);
}

TEST_F(Page, is_well_formed_where_nobody_met_a_vehicle_and_with_empty_ways) {
  Clip far = clip("a", "front", 1);
  for (Vec2& place : far.persons[0].places) place.y() += 100.0;
  replay({far}, 0);
  EXPECT_EQ(count("//figure"), 0u);
  EXPECT_EQ(count("//table"), 0u);
  DrawnCase still;
  still.recorded = {{1, 1}};
  read({DrawnCase{}, still});
  EXPECT_EQ(count("//figure[@class='case']"), 2u);
  EXPECT_THAT(text_, Not(HasSubstr("nan")));
  EXPECT_THAT(text_, Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace pedzone::test
