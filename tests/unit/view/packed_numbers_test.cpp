#include "view/packed_numbers.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace pedzone {
namespace {

using testing::ElementsAre;

TEST(DifferenceRows, first_differences_begin_anew_with_each_row) {
  DifferenceRows rows(DifferenceRows::Order::kFirst);
  for (const std::vector<int>& row : {std::vector{5, 7, 4}, std::vector{100, 100}}) {
    rows.begin_row();
    for (const int number : row) rows.add(number);
  }
  const auto found = rows.differences();
  EXPECT_THAT(std::vector<int>(found.begin(), found.end()), ElementsAre(5, 2, -3, 100, 0));
}

TEST(DifferenceRows, second_differences_of_even_motion_are_zero) {
  DifferenceRows rows(DifferenceRows::Order::kSecond);
  for (const int start : {1000, -40}) {
    rows.begin_row();
    for (int i = 0; i < 4; ++i) rows.add(start + 13 * i);
  }
  const auto found = rows.differences();
  EXPECT_THAT(std::vector<int>(found.begin(), found.end()),
              ElementsAre(1000, 13, 0, 0, -40, 13, 0, 0));
}

/// Made by Python: base64.b64encode(zlib.compress(bytes, 9)) of the varints' bytes.
TEST(Packed, is_deflated_zigzag_varints_in_base64) {
  const std::vector<std::int32_t> numbers{0, -1, 1, 127};
  EXPECT_EQ(packed(numbers), "eNpjYGT6xwgAAgwBAw==") << "bytes 00 01 02 fe 01";
}

TEST(Packed, takes_the_largest_numbers) {
  const std::vector<std::int32_t> numbers{std::numeric_limits<std::int32_t>::max(),
                                          std::numeric_limits<std::int32_t>::min()};
  EXPECT_EQ(packed(numbers), "eNr79///f/7/IAIAMDkIFg==") << "bytes fe ff ff ff 0f ff ff ff ff 0f";
}

}  // namespace
}  // namespace pedzone
