// What counts as yes and no in parameters and options.
#include "sumo/files/truth.hpp"

#include <gtest/gtest.h>

namespace pedzone {
namespace {

TEST(Truth, is_read_as_sumo_does) {
  for (const char* yes : {"1", "yes", "true", "on", "x", "t", "True", "YES"}) {
    EXPECT_TRUE(is_true(yes)) << yes;
    EXPECT_FALSE(is_false(yes)) << yes;
  }
  for (const char* no : {"0", "no", "false", "off", "-", "f", "False"}) {
    EXPECT_TRUE(is_false(no)) << no;
    EXPECT_FALSE(is_true(no)) << no;
  }
  for (const char* neither : {"", "tru", "truer", "maybe"}) {
    EXPECT_FALSE(is_true(neither) || is_false(neither)) << neither;
  }
}

}  // namespace
}  // namespace pedzone
