// Who wins when behaviours disagree, and what is left of a decision when several hold a person
// back.
#include "crowd/state/proposals.hpp"

#include <gtest/gtest.h>

#include "crowd/state/restraints.hpp"

namespace pedzone {
namespace {

Persons two_people() {
  Persons persons;
  for (std::vector<double>* column : persons.numbers()) column->resize(2);
  persons.walking = 2;
  return persons;
}

TEST(Proposals, the_most_important_one_wins_whoever_comes_first) {
  const std::vector<Behaviour> rising{Behaviour::kWay,  Behaviour::kChild, Behaviour::kGroup,
                                      Behaviour::kSeat, Behaviour::kRound, Behaviour::kDash,
                                      Behaviour::kClaim};
  Proposals proposals;
  for (std::size_t k = 1; k < rising.size(); ++k) {
    for (const bool important_first : {false, true}) {
      const Wish more{2.0, 20.0, rising[k]}, less{1.0, 10.0, rising[k - 1]};
      proposals.begin(2);
      proposals.propose(1, important_first ? more : less);
      proposals.propose(1, important_first ? less : more);
      Persons persons = two_people();
      resolve(proposals, persons);
      EXPECT_EQ(persons.goal_direction[1], 2.0) << k;
      EXPECT_EQ(persons.goal_distance[1], 20.0) << k;
      EXPECT_EQ(persons.goal_distance[0], 0.0) << "nobody proposed anything to this one";
    }
  }
}

TEST(Proposals, of_one_behaviour_the_later_one_holds_and_nothing_is_left_of_the_substep_before) {
  Proposals proposals;
  proposals.begin(1);
  proposals.propose(0, {1.0, 1.0, Behaviour::kClaim});
  proposals.propose(0, {2.0, 2.0, Behaviour::kClaim});
  EXPECT_EQ(proposals.best(0).direction, 2.0);
  proposals.begin(1);
  proposals.propose(0, {0.5, 3.0, Behaviour::kWay});
  EXPECT_EQ(proposals.best(0).direction, 0.5);
}

TEST(Proposals, lead_towards_a_place) {
  const Wish wish = towards({0.0, -2.0}, Behaviour::kSeat);
  EXPECT_DOUBLE_EQ(wish.direction, -0.5 * kPi);
  EXPECT_DOUBLE_EQ(wish.distance, 2.0);
  EXPECT_EQ(wish.by, Behaviour::kSeat);
}

TEST(Restraints, the_least_speed_holds_and_who_has_it_wait_has_it_wait) {
  Restraints restraints;
  restraints.begin(4);
  restraints.limit(0, 0.4);
  restraints.limit(0, 0.9);
  restraints.wait(1);
  restraints.limit(1, 0.9);
  restraints.stand_facing(2, 1.5);
  std::vector<Decision> decisions(4, Decision{0.25, 1.3, 5.0, false, false});
  decisions[3].waits = true;
  restraints.apply(decisions);
  EXPECT_EQ(decisions[0].speed, 0.4);
  EXPECT_FALSE(decisions[0].waits);
  EXPECT_EQ(decisions[1].speed, 0.0);
  EXPECT_TRUE(decisions[1].waits);
  EXPECT_EQ(decisions[2].speed, 0.0);
  EXPECT_EQ(decisions[2].direction, 1.5);
  EXPECT_EQ(decisions[3].speed, 1.3);
  EXPECT_EQ(decisions[3].direction, 0.25);
  EXPECT_TRUE(decisions[3].waits);
}

}  // namespace
}  // namespace pedzone
