#include "results/table.hpp"

namespace pedzone {

std::string described(const std::vector<ColumnInfo>& columns) {
  std::string text = "| column | unit | meaning |\n| --- | --- | --- |\n";
  for (const ColumnInfo& column : columns) {
    text += fmt::format("| `{}` | {} | {} |\n", column.name, column.unit, column.meaning);
  }
  return text;
}

}  // namespace pedzone
