#include "core/csv_stream.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

namespace pedzone {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class CsvStream : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }

  void write(const std::string& text) { std::ofstream(file_, std::ios::binary) << text; }

  /// Fields of each row in brackets; or the error.
  std::string visited() {
    std::string told;
    try {
      visit_rows(file_, {"id", "x"},
                 [&](const CsvRow& row) { told += "[" + row[0] + "|" + row[1] + "]"; });
    } catch (const InputError& error) {
      return error.what();
    }
    return told;
  }
  std::string number_of(const std::string& field) {
    write("id,x\na," + field + "\n");
    double number = 0.0;
    try {
      visit_rows(file_, {"id", "x"}, [&](const CsvRow& row) {
        number = row.number(1, {0.0, 9.0});
      });
    } catch (const InputError& error) {
      return error.what();
    }
    return std::to_string(number);
  }

  /// Its own for each test: they run side by side.
  std::string file_ = testing::TempDir() + "pedzone_csv_stream_test." +
                      testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
};

TEST_F(CsvStream, visits_rows) {
  write("id,x\na,1\nb,\n");
  EXPECT_EQ(visited(), "[a|1][b|]");
}

TEST_F(CsvStream, takes_other_line_ends_and_none_at_the_end) {
  write("id,x\r\na,1\r\nb,2");
  EXPECT_EQ(visited(), "[a|1][b|2]");
}

TEST_F(CsvStream, passes_over_a_byte_order_mark) {
  write("\xEF\xBB\xBFid,x\na,1\n");
  EXPECT_EQ(visited(), "[a|1]");
}

TEST_F(CsvStream, reads_quoted_fields_with_commas_quotes_and_line_ends) {
  write("id,x\n\"a,\"\"b\"\"\nc\",1\n\"\",2\n");
  EXPECT_EQ(visited(), "[a,\"b\"\nc|1][|2]");
}

TEST_F(CsvStream, reads_what_is_longer_than_a_piece_and_gzipped) {
  const gzFile file = gzopen(file_.c_str(), "wb");
  std::string text = "id,x\n", expected;
  for (int i = 0; i < 60000; ++i) {
    text += "person" + std::to_string(i) + ",1\n";
    expected += "[person" + std::to_string(i) + "|1]";
  }
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  EXPECT_EQ(visited(), expected);
}

TEST_F(CsvStream, refuses_what_is_cut_off) {
  write("id,x\na,1\nb");
  EXPECT_THAT(visited(), AllOf(HasSubstr(file_ + ":3"), HasSubstr("cut off")));
  write("id,x\na,1\n\"b");
  EXPECT_THAT(visited(), AllOf(HasSubstr(file_ + ":3"), HasSubstr("cut off")));
}

TEST_F(CsvStream, refuses_another_header_another_number_of_fields_and_nothing) {
  write("id,y\na,1\n");
  EXPECT_THAT(visited(), AllOf(HasSubstr(file_ + ":1"), HasSubstr("'id,y'"), HasSubstr("id,x")));
  write("id,x\na,1\na,1,2\n");
  EXPECT_THAT(visited(), AllOf(HasSubstr(file_ + ":3"), HasSubstr("3 fields")));
  write("");
  EXPECT_THAT(visited(), HasSubstr("is empty"));
  EXPECT_TRUE(std::filesystem::remove(file_));
  EXPECT_THAT(visited(), HasSubstr("cannot be opened"));
}

TEST_F(CsvStream, any_header_is_told_before_the_first_row_and_none_of_an_empty_file) {
  const auto told = [&] {
    std::string text;
    visit_any_rows(
        file_,
        [&](const std::vector<std::string>& header) {
          text += std::to_string(header.size()) + ":";
        },
        [&](const CsvRow& row) { text += row[0] + ";"; });
    return text;
  };
  write("a,b,c\n1,2,3\n4,5,6\n");
  EXPECT_EQ(told(), "3:1;4;");
  write("");
  EXPECT_EQ(told(), "0:");
  write("a,b\n1,2,3\n");
  EXPECT_THROW(told(), InputError);
}

TEST_F(CsvStream, numbers_have_to_be_numbers_in_range) {
  EXPECT_EQ(number_of("2.5"), "2.500000");
  EXPECT_THAT(number_of("two"), AllOf(HasSubstr(file_ + ":2"), HasSubstr("column x"),
                                      HasSubstr("'two' is not a number"), HasSubstr("0 to 9")));
  EXPECT_THAT(number_of("nan"), HasSubstr("is not a number"));
  EXPECT_THAT(number_of("10"), HasSubstr("is out of range"));
}

}  // namespace
}  // namespace pedzone
