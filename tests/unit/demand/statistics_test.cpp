// 10,000 people of a panel against the table of profiles: every figure within 4.5 standard errors
// of what the distributions say, which are integrated here anew.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "panel_scene.hpp"

namespace pedzone::test {
namespace {

constexpr double kSigmas = 4.5;
constexpr double kPeople = 10000;

/// Mean, variance and fourth central moment.
struct Moments {
  double mean = 0.0, variance = 0.0, fourth = 0.0;
};

/// Of a normal distribution cut off outside [least, most], by summing its density.
Moments truncated_normal(double mean, double deviation, double least, double most) {
  constexpr int kSteps = 20000;
  const double width = (most - least) / kSteps;
  const auto density = [&](int i, double& x) {
    x = least + (i + 0.5) * width;
    const double z = (x - mean) / deviation;
    return std::exp(-0.5 * z * z);
  };
  Moments moments;
  double sum = 0.0, x = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double weight = density(i, x);
    sum += weight;
    moments.mean += weight * x;
  }
  moments.mean /= sum;
  for (int i = 0; i < kSteps; ++i) {
    const double weight = density(i, x) / sum, off = x - moments.mean;
    moments.variance += weight * off * off;
    moments.fourth += weight * off * off * off * off;
  }
  return moments;
}

Moments moments_of(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values) moments.mean += value / static_cast<double>(values.size());
  for (const double value : values) {
    moments.variance += std::pow(value - moments.mean, 2) / static_cast<double>(values.size() - 1);
  }
  return moments;
}

using Groups = std::map<std::string, std::vector<const PlannedPerson*>>;

Groups groups_of(const std::vector<PlannedPerson>& people) {
  Groups groups;
  for (const PlannedPerson& person : people) {
    if (!person.group.empty()) groups[person.group].push_back(&person);
  }
  return groups;
}

/// Probability of each size of a group of 2 to 5: zero-truncated Poisson, 45 % of people alone.
std::map<int, double> size_probabilities() {
  const double parameter = std::log(1.0 / 0.45);
  std::map<int, double> probability;
  double sum = 0.0, term = parameter;
  for (int size = 2; size <= 5; ++size) {
    term *= parameter / size;
    probability[size] = term;
    sum += term;
  }
  for (auto& [size, value] : probability) value /= sum;
  return probability;
}

void expect_count(double count, double n, double probability, const std::string& what) {
  const double error = std::sqrt(n * probability * (1.0 - probability));
  EXPECT_NEAR(count, n * probability, kSigmas * error) << what;
}

/// People's speeds against their profiles', within a range.
void check_speeds(const PanelScene& scene, double least, double most) {
  std::map<const Profile*, std::vector<double>> speeds;
  for (const PlannedPerson& person : scene.people()) {
    speeds[person.profile].push_back(person.speed);
    ASSERT_GE(person.speed, least);
    ASSERT_LE(person.speed, std::min(most, person.profile->top_speed));
  }
  for (const auto& [profile, values] : speeds) {
    const double n = static_cast<double>(values.size());
    if (n < 30) continue;
    const Moments expected = truncated_normal(profile->speed, profile->speed_deviation, least,
                                              std::min(most, profile->top_speed));
    const Moments found = moments_of(values);
    EXPECT_NEAR(found.mean, expected.mean, kSigmas * std::sqrt(expected.variance / n))
        << profile->id;
    const double spread = expected.fourth - expected.variance * expected.variance;
    EXPECT_NEAR(found.variance, expected.variance, kSigmas * std::sqrt(spread / n)) << profile->id;
  }
}

TEST(PanelStatistics, shares_of_profiles_are_those_of_the_table) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "10000"}});
  std::map<std::string, int> counts;
  for (const PlannedPerson& person : scene.people()) ++counts[person.profile->id];
  double sum = 0.0;
  for (const Profile& profile : scene.profiles.all()) sum += profile.share;
  for (const Profile& profile : scene.profiles.all()) {
    expect_count(counts[profile.id], kPeople, profile.share / sum, profile.id);
  }
}

TEST(PanelStatistics, shares_named_are_kept_and_the_rest_is_as_in_the_table) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "10000"}, {"profiles", "senior=0.5 infant=0.1 wheelchair=0.15"}});
  std::map<std::string, int> counts;
  for (const PlannedPerson& person : scene.people()) ++counts[person.profile->id];
  const std::map<std::string, double> named{{"senior", 0.5}, {"infant", 0.1}, {"wheelchair", 0.15}};
  double others = 0.0;
  for (const Profile& profile : scene.profiles.all()) {
    if (!named.contains(profile.id)) others += profile.share;
  }
  for (const Profile& profile : scene.profiles.all()) {
    const auto share = named.find(profile.id);
    expect_count(counts[profile.id], kPeople,
                 share == named.end() ? 0.25 * profile.share / others : share->second, profile.id);
  }
}

TEST(PanelStatistics, speeds_are_those_of_the_table) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "10000"}});
  check_speeds(scene, 0.1, 5.0);
}

TEST(PanelStatistics, speeds_are_truncated_to_the_range_of_the_user) {
  for (const auto& [least, most] :
       {std::pair(1.0, 1.5), std::pair(0.6, 0.9), std::pair(1.8, 3.0)}) {
    PanelScene scene = PanelScene::plaza();
    scene.add({{"number", "10000"},
               {"speedMin", std::to_string(least)},
               {"speedMax", std::to_string(most)}});
    check_speeds(scene, least, most);
    std::size_t at_limits = 0;  // truncated, not clamped
    for (const PlannedPerson& person : scene.people()) {
      at_limits += person.speed == least || person.speed == most;
    }
    EXPECT_EQ(at_limits, 0u);
  }
}

TEST(PanelStatistics, groups_are_as_large_as_published) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "10000"}});
  const auto people = scene.people();
  const Groups groups = groups_of(people);
  std::map<int, int> counts;
  double in_groups = 0.0;
  for (const auto& [id, members] : groups) {
    ++counts[static_cast<int>(members.size())];
    in_groups += static_cast<double>(members.size());
  }
  double mean = 0.0, square = 0.0;
  for (const auto& [size, probability] : size_probabilities()) {
    expect_count(counts[size], static_cast<double>(groups.size()), probability,
                 std::to_string(size));
    mean += size * probability;
    square += size * size * probability;
  }
  for (const auto& [size, count] : counts) EXPECT_TRUE(2 <= size && size <= 5) << size;
  // A unit is one person with probability p, else a group. The share of people alone is a ratio of
  // means over units: its variance is that of (alone - share * size) over units times mean size^2.
  const double share = 0.45, p = share * mean / (1.0 - share + share * mean);
  const double unit = p + (1.0 - p) * mean;
  const double variance =
      p * std::pow(1.0 - share, 2) + (1.0 - p) * share * share * square;  // its mean is 0
  const double error = std::sqrt(variance / (kPeople / unit)) / unit;
  EXPECT_NEAR(1.0 - in_groups / kPeople, share, kSigmas * error);
}

TEST(PanelStatistics, small_children_have_somebody_with_them_and_groups_walk_together) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "10000"}, {"profiles", "infant=0.2"}});
  const auto people = scene.people();
  std::size_t infants = 0;
  for (const PlannedPerson& person : people) {
    if (person.profile->id != "infant") continue;
    ++infants;
    EXPECT_FALSE(person.group.empty()) << person.id;
  }
  EXPECT_GT(infants, 1500u);
  for (const auto& [id, members] : groups_of(people)) {
    bool guarded = true;
    for (const PlannedPerson* member : members) {
      guarded = guarded && member->profile->guarded > 0.5;
      EXPECT_EQ(member->depart, members.front()->depart);
      EXPECT_EQ(member->from.edge, members.front()->from.edge);
      EXPECT_EQ(member->to.edge, members.front()->to.edge);
      EXPECT_NEAR(member->from.position, members.front()->from.position, 2.0);
      EXPECT_EQ(member->to.position, members.front()->to.position);
    }
    EXPECT_FALSE(guarded) << id;
  }
}

TEST(PanelStatistics, activities_are_as_frequent_as_asked_for) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"number", "10000"}, {"activities", "texting=0.2 phoning=0.1"}});
  std::map<Activity, int> counts;
  for (const PlannedPerson& person : scene.people()) ++counts[person.activity];
  expect_count(counts[Activity::kTexting], kPeople, 0.2, "texting");
  expect_count(counts[Activity::kPhoning], kPeople, 0.1, "phoning");
  expect_count(counts[Activity::kNone], kPeople, 0.7, "none");
}

TEST(PanelStatistics, arrivals_by_the_hour_are_a_poisson_process) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"perHour", "3600"}, {"begin", "100"}, {"end", "7300"}, {"alone", "1"}});
  const auto people = scene.people();
  const double n = static_cast<double>(people.size());
  EXPECT_NEAR(n, 7200.0, kSigmas * std::sqrt(7200.0));
  double late = 0.0, gaps_over_mean = 0.0;
  for (std::size_t i = 0; i < people.size(); ++i) {
    ASSERT_GE(people[i].depart, 100.0);
    ASSERT_LT(people[i].depart, 7300.0);
    late += people[i].depart > 3700.0;
    if (i > 0) gaps_over_mean += people[i].depart - people[i - 1].depart > 1.0;
  }
  expect_count(late, n, 0.5, "second half");
  expect_count(gaps_over_mean, n - 1.0, std::exp(-1.0), "gaps over 1 s");
}

TEST(PanelStatistics, groups_by_the_hour_bring_as_many_people) {
  PanelScene scene = PanelScene::plaza();
  scene.add({{"perHour", "3600"}, {"end", "7200"}});
  double mean = 0.0, square = 0.0;  // of a unit's size
  double group = 0.0;
  for (const auto& [size, probability] : size_probabilities()) group += size * probability;
  const double p = 0.45 * group / (0.55 + 0.45 * group);
  mean = square = p;
  for (const auto& [size, probability] : size_probabilities()) {
    mean += (1.0 - p) * size * probability;
    square += (1.0 - p) * size * size * probability;
  }
  const double n = static_cast<double>(scene.people().size());
  EXPECT_NEAR(n, 7200.0, kSigmas * std::sqrt(7200.0 / mean * square));  // compound Poisson
}

}  // namespace
}  // namespace pedzone::test
