// Both kernels against the brute-force twin: every choice of random scenes, to the bit.
#include <gtest/gtest.h>

#include "model/heuristic_model.hpp"
#include "scene.hpp"
#include "twin.hpp"

namespace pedzone::test {
namespace {

struct Case {
  const char* name;
  double density;
  void (*adjust)(Parameters&);
  VehicleForm form = VehicleForm::kPlain;
};

class KernelTwin : public testing::TestWithParam<Case> {};

void expect_same(const std::vector<Decision>& a, const std::vector<Decision>& b, const char* kernel,
                 std::uint32_t seed) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].direction, b[i].direction) << kernel << " seed " << seed << " person " << i;
    ASSERT_EQ(a[i].free_distance, b[i].free_distance) << kernel << " seed " << seed;
    ASSERT_EQ(a[i].speed, b[i].speed) << kernel << " seed " << seed << " person " << i;
    ASSERT_EQ(a[i].waits, b[i].waits) << kernel << " seed " << seed << " person " << i;
    ASSERT_EQ(a[i].turns, b[i].turns) << kernel << " seed " << seed << " person " << i;
  }
}

TEST_P(KernelTwin, makes_the_same_choices) {
  const VehicleForm form = GetParam().form;
  HeuristicModel twin(form, twin_kernel()), baseline(form, baseline_kernel());
  HeuristicModel avx2(form, has_avx2() ? avx2_kernel() : baseline_kernel());
  std::size_t waiting = 0, slowed = 0, turned = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    Scene scene = random_scene(
        {.people = 400, .density = GetParam().density, .vehicles = 12, .obstacles = 12}, seed);
    GetParam().adjust(scene.parameters);
    const std::vector<Decision> expected = scene.decide(twin);
    expect_same(scene.decide(baseline), expected, "baseline", seed);
    expect_same(scene.decide(avx2), expected, "avx2", seed);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      waiting += expected[i].waits ? 1 : 0;
      slowed += expected[i].speed < scene.people[i].speed ? 1 : 0;
      turned += expected[i].turns ? 1 : 0;
    }
  }
  EXPECT_GT(waiting, 0U);
  EXPECT_GT(slowed, 0U);
  EXPECT_GT(turned, 20U);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, KernelTwin,
    testing::Values(Case{"sparse", 0.1, [](Parameters&) {}}, Case{"half", 0.5, [](Parameters&) {}},
                    Case{"one", 1.0, [](Parameters&) {}}, Case{"two", 2.0, [](Parameters&) {}},
                    Case{"crush", 5.0, [](Parameters&) {}},
                    Case{"eq_1", 1.0, [](Parameters& p) { p.equation = 1.0; }},
                    Case{"short_sight", 1.0, [](Parameters& p) { p.sight = 1.5; }},
                    Case{"long_sight", 0.3, [](Parameters& p) { p.sight = 35.0; }},
                    Case{"narrow_view", 1.0, [](Parameters& p) { p.field_of_view = 40.0; }},
                    Case{"view_all_round", 1.0, [](Parameters& p) { p.field_of_view = 180.0; }},
                    Case{"wide_view", 0.5, [](Parameters& p) { p.field_of_view = 130.0; }},
                    Case{"all_round_candidates", 1.0,
                         [](Parameters& p) { p.candidate_field = 180.0; }},
                    Case{"narrow_candidates", 1.0, [](Parameters& p) { p.candidate_field = 10.0; }},
                    Case{"discomfort", 0.5, [](Parameters&) {}, VehicleForm::kDiscomfort},
                    Case{"much_discomfort", 1.0, [](Parameters& p) { p.discomfort_margin = 3.0; },
                         VehicleForm::kDiscomfort},
                    Case{"discomfort_eq_1", 1.0, [](Parameters& p) { p.equation = 1.0; },
                         VehicleForm::kDiscomfort},
                    Case{"discomfort_all_round", 0.2,
                         [](Parameters& p) { p.field_of_view = 180.0; }, VehicleForm::kDiscomfort}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pedzone::test
