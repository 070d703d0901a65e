// Pictures and reports of zones: well-formed, complete, in the right place.
#include <gmock/gmock.h>

#include <pugixml.hpp>

#include "pages/palette.hpp"
#include "scene.hpp"
#include "view/path_plot.hpp"
#include "view/svg.hpp"
#include "view/zone_report.hpp"
#include "view/zone_svg.hpp"

namespace pedzone::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A street of 60 m whose id needs escaping, a house, and a road beside them.
class Picture : public ::testing::Test {
 protected:
  Picture() {
    scene_.add({"a<b>&\"c\"", {{100, 200}, {160, 200}}});
    scene_.add_building("house", rectangle(120, 204, 130, 210));
    scene_.add_road("road", {{100, 185}, {160, 185}});
    zones_.push_back(scene_.zone());
  }

  pugi::xml_document drawn(const std::vector<PathLayer>& layers = {}) const {
    pugi::xml_document document;
    const std::string text = zone_svg(scene_.network(), zones_, layers);
    EXPECT_TRUE(document.load_string(text.c_str())) << text;
    return document;
  }

  /// The first element whose title begins so.
  static pugi::xml_node titled(const pugi::xml_document& document, const std::string& title) {
    return document.select_node(("//*[starts-with(title, '" + title + "')]").c_str()).node();
  }

  Scene scene_;
  std::vector<Zone> zones_;
};

TEST_F(Picture, is_well_formed_whatever_the_ids_are) {
  const pugi::xml_document document = drawn();
  EXPECT_STREQ(document.document_element().name(), "svg");
  EXPECT_TRUE(titled(document, "a<b>&")) << "the street's lane";
}

TEST_F(Picture, shows_zone_obstacles_and_roads_in_metres_with_north_up) {
  const pugi::xml_document document = drawn();
  // The zone reaches 12 m beyond the lane's side; the picture 25 m beyond the zone.
  const Box zone = box_of(zones_[0].walkable);
  char corner[64];
  std::snprintf(corner, sizeof corner, "M%.2f %.2f", 100.0 - (zone.min().x() - 25.0),
                zone.max().y() + 25.0 - 200.0);
  EXPECT_THAT(titled(document, "a<b>&").attribute("d").value(), ::testing::StartsWith(corner));
  EXPECT_TRUE(titled(document, "zone shared-space"));
  EXPECT_TRUE(titled(document, "road_0 highway.residential"));
}

TEST_F(Picture, gives_a_zone_the_colour_that_it_has_in_plots_of_runs) {
  const auto fill_of = [](const std::string& text) {
    pugi::xml_document document;
    document.load_string(text.c_str());
    return std::string(titled(document, "zone shared-space").attribute("fill").value());
  };
  const Place place{scene_.network(), zones_, {}};
  EXPECT_EQ(fill_of(zone_svg(scene_.network(), zones_)), colours::kZone.light);
  EXPECT_EQ(fill_of(path_plot({}, &place, {"", box_of(zones_[0].walkable)})), colours::kZone.light);
}

TEST_F(Picture, gives_neighbouring_zones_different_colours) {
  zones_.push_back(zones_.front());
  zones_.back().id = "other";
  const pugi::xml_document document = drawn();
  EXPECT_STRNE(titled(document, "zone shared-space").attribute("fill").value(),
               titled(document, "zone other").attribute("fill").value());
}

TEST_F(Picture, has_a_legend_and_a_scale_bar) {
  const std::string text = zone_svg(scene_.network(), zones_);
  char walkable[64];
  std::snprintf(walkable, sizeof walkable, "(%.0f m²)", area(zones_[0].walkable));
  for (const std::string& part :
       {std::string("walkable, zone &quot;shared-space&quot;"), std::string(walkable),
        std::string("obstacle"), std::string("road that stays SUMO&apos;s"), std::string(">10 m<"),
        std::string("north is up")}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST_F(Picture, draws_layers_of_paths_and_names_them) {
  PathLayer people;
  people.name = "people & prams";
  people.colour = "#123456";
  people.lines = {{{110, 200}, {150, 201}}, {{110, 199}}, {{111, 199}, {120, 199}, {121, 200}}};
  const pugi::xml_document document = drawn({people});
  const auto group = document.select_node("//g[@stroke='#123456']").node();
  ASSERT_TRUE(group);
  EXPECT_EQ(std::distance(group.begin(), group.end()), 2) << "one point is no line";
  EXPECT_THAT(zone_svg(scene_.network(), zones_, {people}), HasSubstr("people &amp; prams (3)"));
  EXPECT_THAT(zone_svg(scene_.network(), zones_), Not(HasSubstr("#123456")));
}

TEST_F(Picture, the_report_lists_what_is_in_what_is_out_and_every_warning) {
  scene_.add_building("gate", rectangle(140, 190, 145, 210));
  Street path{"path", {{100, 250}, {140, 250}}, "highway.footway"};
  scene_.add(path);
  const std::string text = zone_report(scene_.network(), {scene_.zone()});
  for (const char* part :
       {"Zone \"shared-space\" (model heuristic)", "edges        1 of 60.0 m together",
        "highway.pedestrian       60.0 m      1 edge", "highway.footway       40.0 m      1 edge",
        "edgeTypes=\"highway.footway\"", "1 warning\n",
        "polygon 'gate' cuts the centre line of lane 'a<b>&\"c\"_0': cut open along it"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text, Not(HasSubstr("highway.residential"))) << "closed to persons";
}

TEST(Escaped, writes_what_xml_reads_back) {
  EXPECT_EQ(escaped("a<b>&\"'\x01"), "a&lt;b&gt;&amp;&quot;&apos;");
  EXPECT_EQ(escaped("Fußgängerzone"), "Fußgängerzone");
}

}  // namespace
}  // namespace pedzone::test
