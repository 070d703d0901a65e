#include "study/measure/free_walk_measure.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/error.hpp"
#include "temporary_file.hpp"

namespace pedzone::study {
namespace {

/// A person for 60 s: 20 s on an edge at 1.2 m/s, 20 s over a walking area at 2 m/s, 15 s on the
/// next edge at 1.2 m/s, then standing.
std::string recording() {
  std::string text = "<fcd-export>\n";
  double x = 0.0;
  for (int time = 0; time <= 60; ++time) {
    const char* edge = time <= 20 ? "a" : time <= 40 ? ":j_w0" : "b";
    if (time > 0) x += time <= 20 ? 1.2 : time <= 40 ? 2.0 : time <= 55 ? 1.2 : 0.0;
    text += fmt::format(
        "<timestep time=\"{}\"><vehicle id=\"v\" x=\"0\" y=\"0\"/>"
        "<person id=\"p\" x=\"{:.3f}\" y=\"1\" speed=\"9\" edge=\"{}\"/></timestep>\n",
        time, x, edge);
  }
  return text + "</fcd-export>";
}

TEST(FreeWalk, of_sumos_models_is_that_on_edges) {
  const TemporaryFile fcd("fcd", recording());
  EXPECT_NEAR(free_walks_of(fcd.path(), "").at("p").speed.value(), 1.2, 1e-6);
}

TEST(FreeWalk, of_pedzone_is_that_while_it_walks_the_person) {
  const TemporaryFile fcd("fcd", recording());
  std::string rows = "time,id,x,y,vx,vy,heading,motion,activity\n";
  for (int time = 10; time <= 30; ++time) {
    rows += fmt::format("{}.00,p,0,0,0,0,0,walking,none\n", time);
  }
  const TemporaryFile trajectories("csv", rows);
  // 10 s at 1.2 m/s and 10 s at 2 m/s.
  EXPECT_NEAR(free_walks_of(fcd.path(), trajectories.path()).at("p").speed.value(), 1.6, 1e-6);
}

TEST(FreeWalk, is_SUMOs_where_pedzone_walks_nobody) {
  const TemporaryFile fcd("fcd", recording());
  const TemporaryFile none("csv", "time,id,x,y,vx,vy,heading,motion,activity\n");
  EXPECT_NEAR(free_walks_of(fcd.path(), none.path()).at("p").speed.value(), 1.2, 1e-6);
}

TEST(FreeWalk, of_few_seconds_is_none) {
  const TemporaryFile fcd("fcd", recording());
  const TemporaryFile trajectories(
      "csv",
      "time,id,x,y,vx,vy,heading,motion,activity\n"
      "5.00,p,0,0,0,0,0,walking,none\n6.00,p,0,0,0,0,0,walking,none\n");
  EXPECT_FALSE(free_walks_of(fcd.path(), trajectories.path()).at("p").speed);
}

TEST(FreeWalk, has_way_and_time_of_who_is_gone_by_the_end) {
  std::string text = recording();
  const TemporaryFile there("fcd", text);
  EXPECT_FALSE(free_walks_of(there.path(), "").at("p").way);
  text.insert(text.find("</fcd-export>"), "<timestep time=\"61\"/>");
  const TemporaryFile gone("fcd", text);
  const FreeWalk walk = free_walks_of(gone.path(), "").at("p");
  EXPECT_NEAR(walk.way.value(), 20 * 1.2 + 20 * 2.0 + 15 * 1.2, 1e-6);
  EXPECT_NEAR(walk.time.value(), 60.0, 1e-9);
  const auto values = free_walk_values({{"way:a", walk}});
  EXPECT_EQ(values.size(), 3U);
  EXPECT_EQ(values.at("time:way:a"), 60.0) << "ids are hostile";
}

TEST(FreeWalk, of_a_file_cut_off_is_refused) {
  const std::string text = recording();
  const TemporaryFile fcd("fcd", text.substr(0, text.size() / 2));
  EXPECT_THROW(free_walks_of(fcd.path(), ""), InputError);
}

}  // namespace
}  // namespace pedzone::study
