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

TEST(InputError, asks_whether_a_name_that_is_allowed_was_meant) {
  const auto error = [](const char* value, const char* allowed) {
    return std::string(InputError("is unknown", {.value = value, .allowed = allowed}).what());
  };
  EXPECT_EQ(error("sigth", "sight, patience"),
            "'sigth' is unknown; allowed: sight, patience. Did you mean 'sight'?");
  for (const char* value : {"heuristc", "hheuristic", "heuristix", "hueristic", "heur"}) {
    EXPECT_THAT(error(value, "orca, heuristic, heuristic-original, or a path (*.so)"),
                testing::EndsWith(". Did you mean 'heuristic'?"));
  }
  for (const char* value : {"telepathy", "", "or", "heuristic"}) {
    EXPECT_THAT(error(value, "orca-1, heuristic"), testing::EndsWith("allowed: orca-1, heuristic"));
  }
  EXPECT_THAT(error("b", "a, c"), testing::EndsWith("allowed: a, c"));
  EXPECT_THAT(error("6", "0 to 5"), testing::EndsWith("allowed: 0 to 5"));
}

}  // namespace
}  // namespace pedzone
