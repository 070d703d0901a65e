// The page of a validation: well-formed whatever files say, complete, to scale. How it looks and
// that it fetches nothing is tested in a browser.
#include "validation/page.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <stdexcept>

#include "validation/tuned_clips.hpp"

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

  /// What the page shows as XML, and what its scripts draw.
  void read(const std::vector<DrawnCase>& worst) {
    text_ = validation_page(result_, worst);
    const std::string main = "<main>" + between("<main>", "</main>") + "</main>";
    const pugi::xml_parse_result parsed = document_.load_string(main.c_str());
    ASSERT_TRUE(parsed) << parsed.description() << " at " << main.substr(parsed.offset, 80);
    drawn_ = nlohmann::json::parse(between(R"(<script type="application/json" id="data">)", "<"));
  }

  std::string between(std::string_view begin, std::string_view end) const {
    const std::size_t from = text_.find(begin) + begin.size();
    return text_.substr(from, text_.find(end, from) - from);
  }

  std::size_t count(const std::string& path) { return document_.select_nodes(path.c_str()).size(); }

  /// The charts of a group, and where the page has them.
  const nlohmann::json& charts(const std::string& group) {
    for (const auto& heading : document_.select_nodes("//section[@id='curves']//h3")) {
      if (heading.node().text().get() != group + " ") continue;
      const pugi::xml_node place = heading.node().next_sibling("div");
      return drawn_["sets"][place.attribute("data-set").as_uint()]["groups"]
                   [place.attribute("data-group").as_uint()];
    }
    throw std::runtime_error("no charts of " + group);
  }

  ValidationResult result_;
  std::string text_;
  pugi::xml_document document_;
  nlohmann::json drawn_;
};

TEST_F(Page, is_well_formed_whatever_the_names_are) {
  replay_two_sites();
  EXPECT_EQ(count("//script"), 0u);
  EXPECT_THAT(text_, Not(HasSubstr("alert('&\"1")));
  const std::string person = document_.select_node("//figcaption/b").node().text().get();
  EXPECT_THAT(person, HasSubstr(kHostile));
  EXPECT_EQ(drawn_["models"].back(), kHostile);
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
  EXPECT_EQ(count("//div[@data-group]"), 2 * groups_of(result_.data).size());
  EXPECT_EQ(drawn_["drawn"].size(), 3u) << "straight to goal, plain and the page's model";
  EXPECT_EQ(drawn_["drawn"].back(), result_.models.size() - 1);
  for (const std::string& group : groups_of(result_.data)) {
    const std::size_t persons =
        members(result_, result_.runs[0], 0, PersonSet::kRecorded, group).size();
    ASSERT_EQ(charts(group).size(), 4u) << group;
    for (const auto& chart : charts(group)) {
      EXPECT_EQ(chart["recorded"].size(), persons) << group;
      for (const auto& walked : chart["walked"]) {
        EXPECT_EQ(walked.size(), kSeeds * persons) << group;
        EXPECT_TRUE(std::is_sorted(walked.begin(), walked.end())) << group;
      }
    }
  }
}

TEST_F(Page, ends_the_axes_where_the_curves_do) {
  replay_two_sites();
  const auto& ends = drawn_["sets"][0]["ends"];
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& chart = charts("all")[k];
    double most = chart["recorded"].back();
    for (const auto& walked : chart["walked"]) most = std::max(most, walked.back().get<double>());
    EXPECT_GE(ends[k], most);
    EXPECT_LE(ends[k], 2.0 * most + 1.0) << "and not far beyond";
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
  EXPECT_EQ(charts("all")[2]["ks"][0], distance);
}

TEST_F(Page, gives_a_model_its_own_colour_in_tables_and_pictures) {
  replay_two_sites();
  const auto signs = document_.select_nodes("//section[@id='tables']//table[1]//th//path");
  std::set<std::string> strokes;
  for (const auto& sign : signs) strokes.insert(sign.node().attribute("stroke").value());
  EXPECT_THAT(strokes, ::testing::ElementsAre("var(--model-0)", "var(--model-1)", "var(--model-2)",
                                              "var(--model-3)", "var(--model-recorded)"));
  const auto walked = document_.select_node("//figure//path[@class='way walked']").node();
  EXPECT_STREQ(walked.attribute("stroke").value(), "var(--model-3)");
}

TEST_F(Page, draws_the_worst_cases_to_scale_with_a_mark_each_second) {
  replay_two_sites();
  ASSERT_EQ(count("//figure[@class='case']"), 2u);
  const auto figure = document_.select_node("//figure[@class='case']").node();
  EXPECT_EQ(figure.select_nodes("svg/path[@class='way recorded']").size(), 1u);
  EXPECT_EQ(figure.select_nodes("svg/path[@class='way walked']").size(), 1u);
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
  const std::string shown = between("<main>", "</main>");
  EXPECT_THAT(shown, Not(HasSubstr("nan")));
  EXPECT_THAT(shown, Not(HasSubstr("inf")));
}

TEST_F(Page, gives_intervals_from_five_clips_on_and_none_of_counts) {
  const auto intervals = [&](int clips) {
    std::vector<Clip> several;
    for (int c = 0; c < clips; ++c) several.push_back(clip("a", "front", 2 + c % 2));
    replay(std::move(several), 0);
    std::set<std::string> found;
    for (const auto& cell : document_.select_nodes("//section[@id='tables']//tbody/tr[4]/td")) {
      found.insert(cell.node().child("small").text().get());
    }
    return found;
  };
  EXPECT_THAT(intervals(4), ::testing::IsSubsetOf({"—", ""}));
  EXPECT_THAT(intervals(5), Not(::testing::Contains("—")));
  for (const ValidationRow& row : result_.rows) {
    for (std::size_t f = 0; f < kFigures; ++f) {
      EXPECT_TRUE(figure_list()[f].has_interval() || std::isnan(row.low[f])) << figure_list()[f].key;
    }
  }
}

TEST_F(Page, tells_in_its_first_paragraph_what_the_default_was_tuned_on) {
  const auto first = [&] {
    pugi::xml_document header;
    EXPECT_TRUE(
        header.load_string(("<p " + between("<p class=\"tuned\"", "</p>") + "</p>").c_str()));
    std::string text;
    for (const auto& node : header.select_nodes("//text()")) text += node.node().value();
    return text;
  };
  ASSERT_GE(tuned_clips().size(), 2u);
  const auto& [site, name] = tuned_clips().front();
  Clip known = clip(site, "front", 1), other = clip("elsewhere", "front", 1);
  known.name = name;
  other.name = "ours_07";
  replay({known, other}, 0);
  EXPECT_THAT(first(), HasSubstr("Scored here are 1 of them (" + site + ": " + name + ")"));
  EXPECT_THAT(first(), HasSubstr("1 of the 2 clips scored here it was not tuned on (elsewhere: "
                                 "ours_07)"));
  replay({known}, 0);
  EXPECT_THAT(first(), HasSubstr("No other clip is scored here"));
  replay({other}, 0);
  EXPECT_THAT(first(), HasSubstr("None of them is scored here"));
}

TEST(TunedClips, are_listed_with_what_differs_in_a_number_once) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(
      listed({{"a", "back_01"}, {"a", "back_02"}, {"a", "front"}, {"b", "front_1"}, {"b", "7"}}),
      "a: back_01, 02, front; b: front_1, 7");
}

/// The crossings of one person whose recorded way and walked way pass a vehicle so long after it.
Figures crossings(std::optional<double> recorded, std::optional<double> walked,
                  bool as_recorded = true) {
  ScoredPerson person;
  if (recorded) person.recorded.passing = PassingOrder{true, *recorded};
  if (walked) person.walked.passing = PassingOrder{as_recorded, *walked};
  const ScoredPerson right = [] {
    ScoredPerson one;
    one.recorded.passing = one.walked.passing = PassingOrder{false, 1.0};
    return one;
  }();
  const ScoredPerson* persons[] = {&person, &right};
  return figures_of(persons);
}

TEST(Scores, count_who_crosses_and_who_no_longer_does) {
  const auto of = [](const Figures& f, Figure figure) {
    return f[static_cast<std::size_t>(figure)];
  };
  struct Case {
    Figures figures;
    double first, count, of_all;
  };
  for (const Case& c : {Case{crossings(1.0, 9.0), 1.0, 2, 1.0},              // right again
                        Case{crossings(1.0, 1.0, false), 0.5, 2, 0.5},       // the other way round
                        Case{crossings(1.0, std::nullopt), 1.0, 1, 0.5},     // not any longer
                        Case{crossings(std::nullopt, 1.0), 1.0, 1, 1.0},     // never recorded
                        Case{crossings(3.0, std::nullopt), 1.0, 1, 1.0}}) {  // not within 2 s
    EXPECT_EQ(of(c.figures, Figure::kFirstClose), c.first);
    EXPECT_EQ(of(c.figures, Figure::kFirstCloseCount), c.count);
    EXPECT_EQ(of(c.figures, Figure::kFirstCloseOfAll), c.of_all);
  }
  EXPECT_EQ(of(crossings(3.0, std::nullopt), Figure::kFirstOfAll), 0.5);
}

}  // namespace
}  // namespace pedzone::test
