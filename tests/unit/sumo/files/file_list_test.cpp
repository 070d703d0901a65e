#include "sumo/files/file_list.hpp"

#include <gmock/gmock.h>

namespace pedzone {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// As SUMO 1.15 takes --route-files, tried with its program.
TEST(FileList, is_split_at_commas_only) {
  EXPECT_THAT(split_file_list("a.xml, b c.xml ,d;e.xml"),
              ElementsAre("a.xml", "b c.xml", "d;e.xml"));
  EXPECT_THAT(split_file_list(" a.xml "), ElementsAre("a.xml"));
  EXPECT_THAT(split_file_list(",a.xml,,"), ElementsAre("a.xml"));
  EXPECT_THAT(split_file_list(" , "), IsEmpty());
  EXPECT_THAT(split_file_list(""), IsEmpty());
}

}  // namespace
}  // namespace pedzone
