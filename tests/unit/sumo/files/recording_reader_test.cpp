#include "sumo/files/recording_reader.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

namespace pedzone {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kFcd =
    "<fcd-export><timestep time='1'>"
    "<vehicle id='v' x='100' y='50' angle='0' speed='4' type='van'/>"
    "<person id='p' x='90' y='50' angle='90' speed='1'/>"
    "<person id='rider' x='100' y='50' angle='0' speed='4'/></timestep>"
    "<timestep time='2'/><timestep time='3'>"
    "<person id='p' x='92' y='50' angle='0' speed='2'/></timestep></fcd-export>";
constexpr const char* kRows =
    "time,id,x,y,vx,vy,heading,motion,activity\n"
    "2.00,p,91,50,0.6,0.8,0.5,walking,texting\n"
    "3.00,p,92,50,0,0,0.5,waiting,none\n";
constexpr const char* kRoutes =
    "<routes><vType id='van' length='6' width='2'/>"
    "<vType id='old' vClass='pedestrian' width='0.6'><param key='pedzone.profile' value='senior'/>"
    "<param key='pedzone.group' value='club'/></vType>"
    "<person id='p' type='old'><param key='pedzone.group' value='&lt;b>'/><walk from='a' to='b'>"
    "<param key='pedzone.group' value='of the walk'/></walk></person>"
    "<personFlow id='f' type='old'/></routes>";

class Reading : public ::testing::Test {
 protected:
  Reading() : folder_(testing::TempDir() + "pedzone_recording_" + name()) {
    std::filesystem::create_directory(folder_);
    cast_.read(write("routes.xml", kRoutes));
  }
  ~Reading() override { std::filesystem::remove_all(folder_); }

  static std::string name() {
    return testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  std::string write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_ + "/" + file) << text;
    return folder_ + "/" + file;
  }
  std::string complaint(const RecordingSource& source) const {
    try {
      read_recording(source, cast_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::string folder_;
  RecordingCast cast_;
};

TEST_F(Reading, floating_car_data_become_metres_and_radians_and_riders_are_left_out) {
  const Recording recording = read_recording({.file = write("fcd.xml", kFcd)}, cast_);
  EXPECT_THAT(recording.times, ElementsAre(1.0, 3.0)) << "nobody is there at 2 s";
  ASSERT_EQ(recording.persons.size(), 1U);
  const RecordedPerson& person = recording.persons[0];
  EXPECT_EQ(person.width, 0.6);
  EXPECT_EQ(person.radius, 0.3);
  ASSERT_EQ(person.moments.size(), 2U);
  EXPECT_EQ(person.moments[1].step, 1U);
  EXPECT_EQ(person.moments[1].position, Vec2(92.0, 50.0));
  EXPECT_NEAR(person.moments[1].heading, 0.5 * kPi, 1e-6);
  EXPECT_NEAR(person.moments[1].speed, 2.0, 1e-6);
  EXPECT_EQ(person.moments[1].motion, std::nullopt);
  ASSERT_EQ(recording.vehicles.size(), 1U);
  EXPECT_EQ(recording.vehicles[0].type, "van");
  EXPECT_EQ(recording.vehicles[0].moments[0].centre, Vec2(100.0, 47.0)) << "half a length back";
}

TEST_F(Reading, trajectories_have_activities_and_another_files_vehicles) {
  const Recording recording =
      read_recording({.file = write("run.csv", kRows), .fcd = write("fcd.xml", kFcd)}, cast_);
  EXPECT_THAT(recording.times, ElementsAre(1.0, 2.0, 3.0));
  ASSERT_EQ(recording.persons.size(), 1U);
  const auto& moments = recording.persons[0].moments;
  ASSERT_EQ(moments.size(), 3U);
  EXPECT_TRUE(moments[0].by_sumo) << "it is in the other file only";
  EXPECT_EQ(moments[0].step, 0U);
  EXPECT_EQ(moments[0].position, Vec2(90, 50));
  EXPECT_FALSE(moments[1].by_sumo);
  EXPECT_EQ(moments[1].step, 1U);
  EXPECT_EQ(moments[1].activity, Activity::kTexting);
  EXPECT_NEAR(moments[1].speed, 1.0, 1e-6);
  EXPECT_EQ(moments[2].motion, Motion::kWaiting);
  EXPECT_FALSE(moments[2].by_sumo);
  EXPECT_EQ(recording.vehicles[0].moments[0].step, 0U);
}

TEST_F(Reading, profile_and_group_are_the_persons_own_before_its_types) {
  EXPECT_EQ(cast_.traits.of_person("p").profile, "senior");
  EXPECT_EQ(cast_.traits.of_person("p").group, "<b>");
  EXPECT_EQ(cast_.traits.of_person("f.17").group, "club");
  EXPECT_EQ(cast_.traits.of_person("stranger").profile, "");
}

TEST_F(Reading, shows_the_time_and_persons_asked_for) {
  const std::string file = write("fcd.xml", kFcd);
  const Recording late = read_recording({.file = file, .begin = 2.5}, cast_);
  EXPECT_THAT(late.times, ElementsAre(3.0));
  EXPECT_TRUE(late.vehicles.empty());
  EXPECT_THAT(complaint({.file = file, .persons = {"q"}}), HasSubstr("'q' is nobody"));
  EXPECT_THAT(complaint({.file = file, .end = 0.5}), HasSubstr("no person in the time shown"));
}

TEST_F(Reading, names_the_columns_of_today_where_a_table_has_those_of_before) {
  const std::string error =
      complaint({.file = write("run.csv", "time,id,x,y,vx,vy,heading,activity,pastime\n")});
  EXPECT_THAT(error, HasSubstr("heading,activity,pastime'"));
  EXPECT_THAT(error, HasSubstr("heading,motion,activity"));
}

TEST_F(Reading, refuses_rows_that_mean_nothing) {
  const auto with = [&](const std::string& row) {
    return complaint({.file = write("run.csv", kRows + row)});
  };
  EXPECT_THAT(with("4,p,1,1,0,0,0,running,none\n"), HasSubstr("run.csv:4: column motion"));
  EXPECT_THAT(with("4,p,1,1,0,0,0,walking,juggling\n"), HasSubstr("column activity: 'juggling'"));
  EXPECT_THAT(with("2,p,1,1,0,0,0,walking,none\n"), HasSubstr("earlier than the row before"));
  EXPECT_THAT(with("3,p,1,1,0,0,0,walking,none\n"), HasSubstr("twice in this time step"));
  EXPECT_THAT(with("4,p,1,1,0,0,0,walk"), HasSubstr("cut off"));
}

TEST(Moments, are_found_by_step) {
  std::vector<PersonMoment> moments(2);
  moments[0].step = 2;
  moments[1].step = 5;
  EXPECT_EQ(moment_until(moments, 1), nullptr);
  EXPECT_EQ(moment_until(moments, 4), &moments[0]);
  EXPECT_EQ(moment_until(moments, 9), &moments[1]);
  EXPECT_EQ(moment_at(moments, 5), &moments[1]);
  EXPECT_EQ(moment_at(moments, 4), nullptr);
}

}  // namespace
}  // namespace pedzone
