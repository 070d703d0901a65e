#include "results/crossing_table.hpp"

namespace pedzone {
namespace {

using Row = StreetCrossed;
using Column = TableColumn<Row>;
constexpr int kDigits = 2;  // of all numbers

std::vector<Column> columns() {
  return {number_column({"time", "s", "when it stepped out"}, &Row::time, kDigits),
          text_column({"person", "", "id"}, &Row::person),
          text_column({"zone", "", "id"}, &Row::zone),
          text_column({"street", "", "id of its first edge"}, &Row::street),
          number_column({"x", "m", "where it stepped out"}, &Row::x, kDigits),
          number_column({"y", "m", "where it stepped out"}, &Row::y, kDigits),
          number_column({"pos", "m", "the same, along the street"}, &Row::pos, kDigits),
          number_column({"width", "m", "of the carriageway"}, &Row::width, kDigits),
          number_column({"waited", "s", "at the kerb"}, &Row::waited, kDigits),
          number_column({"gap", "s", "until the next vehicle came; empty where none was seen"},
                        &Row::gap, kDigits),
          number_column({"needed", "s", "critical gap: width / speed + start-up + margin"},
                        &Row::needed, kDigits),
          {{"looked", "", "false: stepped out without looking", ColumnKind::kTruth},
           [](std::string& line, const Row& row) { line += row.looked ? "true" : "false"; },
           [](Row& row, const CsvRow& fields, std::size_t c) { row.looked = fields[c] == "true"; }},
          list_column({"rejected", "s", "gaps that it had let pass, one after the other"},
                      &Row::rejected, kDigits)};
}

}  // namespace

const Table<StreetCrossed>& crossing_table() {
  static const Table<StreetCrossed> table(columns());
  return table;
}

}  // namespace pedzone
