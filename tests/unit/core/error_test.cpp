#include "core/error.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

TEST(InputError, names_file_line_element_value_and_what_is_allowed) {
  const InputError error("is out of range",
                         {"old.zone.xml", 7, "<zone> attribute openSpace", "-3", "0 to 50"});
  EXPECT_STREQ(error.what(),
               "old.zone.xml:7: <zone> attribute openSpace: '-3' is out of range; "
               "allowed: 0 to 50");
}

TEST(InputError, leaves_out_what_is_not_known) {
  EXPECT_STREQ(InputError("does not exist", {"town.sumocfg", 0, "", "", ""}).what(),
               "town.sumocfg: does not exist");
}

}  // namespace
}  // namespace pedzone
