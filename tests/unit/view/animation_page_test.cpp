#include <gtest/gtest.h>

#include "view/animation.hpp"
#include "world/activities.hpp"

namespace pedzone {
namespace {

TEST(AnimationPage, has_a_colour_and_a_letters_colour_for_each_activity) {
  RecordedPerson person;
  person.id = "p";
  person.length = person.width = 0.5;
  person.radius = 0.25;
  person.moments.push_back({});
  Recording recording;
  recording.times = {0.0};
  recording.persons.push_back(person);
  const std::string page = animation_page({{"run", &recording}}, nullptr, {.title = "page"});
  for (const ActivityInfo& activity : activity_list().subspan(1)) {
    const std::string name(activity.id);
    EXPECT_NE(page.find("--" + name + ":"), std::string::npos) << name;
    EXPECT_NE(page.find("--on-" + name + ":"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace pedzone
