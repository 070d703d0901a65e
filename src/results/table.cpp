#include "results/table.hpp"

#include <fmt/format.h>

#include <iterator>

namespace pedzone {

void append_number(std::string& line, double number, int digits) {
  fmt::format_to(std::back_inserter(line), "{:.{}f}", number, digits);
}

std::string described(const std::vector<ColumnInfo>& columns) {
  std::string text = "| column | unit | meaning |\n| --- | --- | --- |\n";
  for (const ColumnInfo& column : columns) {
    text += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit, column.meaning);
  }
  return text;
}

}  // namespace pedzone
