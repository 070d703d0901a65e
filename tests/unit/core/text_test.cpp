#include "core/text.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pedzone {
namespace {

TEST(Lists, name_their_things) {
  const std::vector<std::string> words{"a", "b", "c"};
  EXPECT_EQ(comma_list(words), "a, b, c");
  EXPECT_EQ(separated_list(words, ","), "a,b,c");
  EXPECT_EQ(comma_list(words, csv_field), "a, b, c");
  EXPECT_EQ(comma_list(std::vector<std::string>{}), "");
}

TEST(JsonString, is_quoted_and_escaped) {
  EXPECT_EQ(json_string("a \"b\" \\ c"), R"("a \"b\" \\ c")");
  EXPECT_EQ(json_string(std::string_view("\n\t\x1f\0", 4)), R"("\u000a\u0009\u001f\u0000")");
  EXPECT_EQ(json_string("Größe"), "\"Größe\"");
}

TEST(JsonString, cannot_end_a_script) {
  EXPECT_EQ(json_string("</script><!--"), R"("\u003c/script>\u003c!--")");
}

}  // namespace
}  // namespace pedzone
