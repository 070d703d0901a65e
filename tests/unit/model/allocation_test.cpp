// Once sizes have settled, a step of the model asks for no memory.
#include <gtest/gtest.h>

#include "allocations.hpp"
#include "scene.hpp"
#include "world/model_names.hpp"

namespace pedzone::test {
namespace {

class Allocation : public ::testing::TestWithParam<std::string_view> {};

TEST_P(Allocation, none_in_a_step_once_sizes_have_settled) {
  const auto model = make_model(std::string(GetParam()));
  Scene scene = random_scene({.people = 800, .density = 1.0, .vehicles = 12, .obstacles = 10}, 5);
  const WallIndex walls(scene.walls);
  std::vector<Decision> decisions(scene.people.size());
  Persons persons = persons_of(scene.people);
  const auto step = [&] {
    model->prepare({&persons, scene.vehicles, &walls, &scene.parameters});
    model->decide(0, decisions.size(), decisions);
    // The bounding box stays as it is: the first four stand in its corners.
    for (std::size_t i = 4; i < persons.size(); ++i) {
      persons.x[i] += 0.1 * decisions[i].speed * std::cos(decisions[i].direction) * 0.5;
      persons.y[i] += 0.1 * decisions[i].speed * std::sin(decisions[i].direction) * 0.5;
    }
  };
  const double side = std::sqrt(800.0);
  for (int corner = 0; corner < 4; ++corner) {
    persons.x[corner] = 7000.0 + (corner % 2 != 0 ? side + 10.0 : -10.0);
    persons.y[corner] = -3000.0 + (corner / 2 != 0 ? side + 10.0 : -10.0);
  }
  for (int i = 0; i < 20; ++i) step();
  const long before = allocations();
  for (int i = 0; i < 20; ++i) step();
  EXPECT_EQ(allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(Models, Allocation, ::testing::ValuesIn(kModelNames));

}  // namespace
}  // namespace pedzone::test
