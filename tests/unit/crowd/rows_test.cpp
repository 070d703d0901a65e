// The crowd as it is stored, for those who read it without a copy.
#include <gtest/gtest.h>

#include "scene.hpp"

namespace pedzone::test {
namespace {

class Rows : public ::testing::Test {
 protected:
  Rows() : zone_(zone_of(box(0.0, 0.0, 30.0, 10.0))), crowd_(zone_, 1) {
    for (int k = 0; k < 5; ++k) {
      NewPerson person;
      person.key = static_cast<std::uint64_t>(k + 1);
      person.position = {2.0 + 3.0 * k, 5.0};
      person.destination = {{29.0, 5.0}, {29.0, 5.0}};
      handles_.push_back(crowd_.add(person));
    }
  }

  Zone zone_;
  Crowd crowd_;
  std::vector<Crowd::Handle> handles_;
};

TEST_F(Rows, tell_who_stands_in_them) {
  crowd_.remove(handles_[1]);
  crowd_.step(0.3, {});
  EXPECT_EQ(crowd_.persons().x.size(), 4U);
  for (std::size_t row = 0; row < crowd_.size(); ++row) {
    const PersonView view = crowd_.view(crowd_.handle_in(row));
    EXPECT_EQ(crowd_.persons().x[row], view.position.x());
    EXPECT_EQ(crowd_.persons().vx[row], view.velocity.x());
  }
}

TEST_F(Rows, know_who_is_there) {
  EXPECT_TRUE(crowd_.has(handles_[4]));
  crowd_.remove(handles_[4]);
  EXPECT_FALSE(crowd_.has(handles_[4]));
  crowd_.remove(handles_[0]);
  EXPECT_FALSE(crowd_.has(handles_[0]));
  EXPECT_TRUE(crowd_.has(handles_[3]));
  EXPECT_FALSE(crowd_.has(1000));
}

TEST_F(Rows, that_are_given_away_keep_their_memory_and_change_nothing) {
  const double* const memory = crowd_.persons().x.data();
  const Persons given = crowd_.give_away_persons();
  EXPECT_EQ(given.x.data(), memory);
  EXPECT_NE(crowd_.persons().x.data(), memory);
  EXPECT_EQ(crowd_.persons().x, given.x);
  EXPECT_EQ(crowd_.size(), 5U);
  const std::vector<double> before = given.x;
  crowd_.step(0.1, {});
  EXPECT_EQ(given.x, before);
  EXPECT_NE(crowd_.persons().x, before);
}

}  // namespace
}  // namespace pedzone::test
